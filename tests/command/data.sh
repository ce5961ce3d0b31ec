# SPDX-License-Identifier: MIT
# Data files: what truth writes is what navigate reads, and what is wrong with a file has a place.
. "$COMMAND_TESTS/lib.sh"
small_scenario >mission.yaml
expect 0 "$SCHULER" truth mission.yaml --imu-out imu.csv --reference-out reference.csv
empty out
[ "$(wc -l <imu.csv)" -eq 6001 ] || complain "$(wc -l <imu.csv) lines of increments"
[ "$(wc -l <reference.csv)" -eq 6002 ] || complain "$(wc -l <reference.csv) lines of reference"
head -n 1 imu.csv >header
echo "time_s,dtheta_x_rad,dtheta_y_rad,dtheta_z_rad,dv_x_mps,dv_y_mps,dv_z_mps" >wanted
same header wanted
head -n 1 reference.csv >header
echo "time_s,lat_deg,lon_deg,height_m,vn_mps,ve_mps,vd_mps,roll_deg,pitch_deg,heading_deg" >wanted
same header wanted

# At rest increments are gravity and earth rate: components of (cos 45, 0, -sin 45) of 7.292115e-5 rad/s
# turned by 30 deg, over 0.02 s; 9.8061 m/s^2 at 45 deg and 300 m (normal gravity, to 1e-4).
sed -n 2p imu.csv | awk -F, '
    function check(name, got, want, tol) {
        if (got - want > tol || want - got > tol) { print name ": " got " is not " want; bad = 1 }
    }
    {
        w = 7.292115e-5 * sqrt(0.5) * 0.02
        check("dtheta_x", $2, w * cos(3.14159265358979 / 6), 1e-15)
        check("dtheta_y", $3, -w * sin(3.14159265358979 / 6), 1e-15)
        check("dtheta_z", $4, -w, 1e-15)
        check("dv_z", $7, -9.8053 * 0.02, 2e-5)
        exit bad
    }' >wrong || complain "$(cat wrong)"

expect 0 "$SCHULER" navigate --imu imu.csv --reference reference.csv --out nav.csv --json r.json
has out "horizontal position"
[ "$(wc -l <nav.csv)" -eq 6002 ] || complain "$(wc -l <nav.csv) lines of the navigator"
same header wanted
# Perfect increments at rest: rounding only, far below a micrometre in two minutes.
json r.json errors horizontal_m max | awk '{ exit !($1 < 1e-6) }' || complain "drift $(json r.json errors horizontal_m max) m"
[ "$(json r.json increments)" = 6000 ] || complain "increments $(json r.json increments)"
expect 0 "$SCHULER" navigate --imu imu.csv --reference reference.csv --out nav3.csv --vertical baro
has out "vertical baro"
expect 0 "$SCHULER" navigate --imu imu.csv --reference reference.csv --out nav2.csv --vertical truth --coning previous --gravity grs80 --json -
json out format >value
[ "$(cat value)" = schuler-navigate-1 ] || complain "JSON on standard output"

# A sparse reference at some of the increments' times.
expect 0 "$SCHULER" truth mission.yaml --reference-out sparse.csv --reference-every '10 s'
[ "$(wc -l <sparse.csv)" -eq 14 ] || complain "$(wc -l <sparse.csv) lines of sparse reference"
expect 0 "$SCHULER" navigate --imu imu.csv --reference sparse.csv --out nav.csv --json sparse.json
[ "$(wc -l <nav.csv)" -eq 14 ] || complain "$(wc -l <nav.csv) lines"
expect 2 "$SCHULER" truth mission.yaml --reference-out x.csv --reference-every '0.03 s'
expect 2 "$SCHULER" truth mission.yaml --reference-out x.csv --reference-every '10'
absent x.csv

# Turning makes the order of the algorithm matter; both come back to the truth.
cat >turn.yaml <<'YAML'
scenario: A turn
trajectory:
  kind: segments
  start: {lat: 45 deg, lon: 7 deg, height: 1000 m, heading: 45 deg, speed: 100 m/s}
  segments:
    - hold: {for: 5 s}
    - turn: {by: 90 deg, bank: 45 deg, roll_rate: 20 deg/s}
imu: {rate: 50 Hz, accel: {model: linear}, gyro: {model: linear}}
YAML
expect 0 "$SCHULER" truth turn.yaml --imu-out turn_imu.csv --reference-out turn_ref.csv
for coning in previous cubic optimal_4; do
    expect 0 "$SCHULER" navigate --imu turn_imu.csv --reference turn_ref.csv --out $coning.csv --coning $coning --json $coning.json
    json $coning.json errors horizontal_m max | awk '{ exit !($1 < 1e-3) }' || complain "$coning drifts"
done
differ previous.csv cubic.csv
differ optimal_4.csv cubic.csv

# A rate of 200 Hz by --set.
expect 0 "$SCHULER" truth mission.yaml --imu-out fast.csv --set 'imu.rate=200 Hz'
[ "$(wc -l <fast.csv)" -eq 24001 ] || complain "$(wc -l <fast.csv) lines at 200 Hz"

# refuse FILE SED PLACE TEXT: that file spoilt
refuse() {
    cp imu.csv i.csv
    cp reference.csv r.csv
    sed "$2" $1.csv >spoilt
    mv spoilt $(echo $1 | cut -c1).csv
    expect 2 "$SCHULER" navigate --imu i.csv --reference r.csv --out o.csv
    has err "$3"
    has err "$4"
    empty out
    absent o.csv
    no_partial
}
refuse imu '1s/dv_y_mps/dvy/' i.csv:1:56 "'dv_y_mps' is expected"
refuse imu '1s/,dv_z_mps//' i.csv:1:64 "too few columns"
refuse imu '1s/$/,extra/' i.csv:1:73 "too many columns"
refuse imu '3s/,[^,]*$//' i.csv:3 "fewer than the 7 numbers"
refuse imu '3s/$/,1/' i.csv:3 "more than the 7 numbers"
refuse imu '3s/^[^,]*/0.0x/' i.csv:3:1 "'0.0x' is not a number"
refuse imu '3s/^[^,]*/nan/' i.csv:3:1 "'nan' is not a number"
refuse imu '3s/^[^,]*/0x1/' i.csv:3:1 "'0x1' is not a number"
refuse imu '3s/^[^,]*/4e999/' i.csv:3:1 "is not a finite number"
refuse imu '3s/.*//' i.csv:3 "fewer than the 7 numbers"
refuse imu '4s/^[^,]*/0.03/' i.csv:4:1 "time runs back from 0.04 s to 0.03 s"
refuse imu '4s/^[^,]*/0.04/' i.csv:4:1 "time 0.04 s is repeated"
refuse imu '4s/^[^,]*/0.0700001/' i.csv:4:1 "a gap"
refuse imu '4d' i.csv:4:1 "a gap: 0.08 s follows 0.04 s, but the interval is 0.02 s"
refuse imu '2s/^[^,]*/0/' i.csv:2:1 "is not after the reference's first time"
refuse imu '2,$d' i.csv "no increments"
refuse reference '2,$d' r.csv "no row to start from"
refuse reference '4s/^[^,]*/0.05/' r.csv:4:1 "is not a time of the increments"
refuse reference '4s/^[^,]*/0.02/' r.csv:4:1 "does not increase"
refuse reference '2s/,45,\|,4[45]\.[0-9]*,/,95,/' r.csv:2:3 "latitude 95 deg is outside"
expect 2 "$SCHULER" navigate --imu nothere.csv --reference reference.csv --out o.csv
expect 2 "$SCHULER" navigate --imu . --reference reference.csv --out o.csv
expect 2 "$SCHULER" navigate --imu mission.yaml --reference reference.csv --out o.csv
expect 2 "$SCHULER" navigate --imu "$SCHULER" --reference reference.csv --out o.csv
truncate -s 1G huge.csv && expect 2 "$SCHULER" navigate --imu huge.csv --reference reference.csv --out o.csv
rm -f huge.csv
expect 2 "$SCHULER" navigate --imu imu.csv --reference reference.csv --out o.csv --gravity egm0
absent o.csv
expect 3 "$SCHULER" navigate --imu imu.csv --reference reference.csv --out no/such/o.csv

# Windows line ends and a byte order mark are no mistake; increments that end early are said.
{ printf '\357\273\277'; sed 's/$/\r/' imu.csv; } >dos.csv
expect 0 "$SCHULER" navigate --imu dos.csv --reference reference.csv --out dos_nav.csv
expect 0 "$SCHULER" navigate --imu imu.csv --reference reference.csv --out nav.csv
same dos_nav.csv nav.csv
head -n 1001 imu.csv >short.csv
expect 0 "$SCHULER" navigate --imu short.csv --reference reference.csv --out nav.csv
has err "reference.csv:1003: warning: reference rows after the last sample: 5000"
[ "$(wc -l <nav.csv)" -eq 1002 ] || complain "$(wc -l <nav.csv) lines"
finish
