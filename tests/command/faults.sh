# SPDX-License-Identifier: MIT
# What is odd in recorded data is told by navigate: on standard error, and in JSON.
. "$COMMAND_TESTS/lib.sh"
cat >turn.yaml <<'YAML'
scenario: A turn
trajectory:
  kind: segments
  start: {lat: 45 deg, lon: 7 deg, height: 1000 m, heading: 45 deg, speed: 100 m/s}
  segments:
    - hold: {for: 5 s}
    - turn: {by: 90 deg, bank: 45 deg, roll_rate: 20 deg/s}
    - cruise: {for: 10 s}
imu: {rate: 100 Hz, accel: {model: linear}, gyro: {model: linear}}
YAML
expect 0 "$SCHULER" truth turn.yaml --imu-out imu.csv --reference-out ref.csv --reference-every '0.5 s'

# nav IMU [OPTION...]: the report in out and r.json
nav() {
    imu=$1
    shift
    expect 0 "$SCHULER" navigate --imu "$imu" --reference ref.csv --out nav.csv --json r.json "$@"
}
# fault NUMBER KIND COUNT LINE SEVERITY
fault() {
    got="$(json r.json faults $1 kind) $(json r.json faults $1 count) $(json r.json faults $1 first_line) $(json r.json faults $1 severity)"
    [ "$got" = "$2 $3 $4 $5" ] || complain "fault $1: $got instead of $2 $3 $4 $5"
}
faults() { [ "$(json r.json faults)" = "$1" ] || complain "$(json r.json faults) faults instead of $1"; }
below() { json r.json errors "$1" max | awk -v limit="$2" '{ exit !($1 < limit) }' || complain "$1 $(json r.json errors "$1" max)"; }

# Straight flight of exact data stands still to the last bit in some stretches: no warning at least.
nav imu.csv
empty err
has out "after"
has out "million a second: reading"
below horizontal_m 1e-4
[ "$(json r.json timing rows)" = "$(($(wc -l <imu.csv) - 1))" ] || complain "rows $(json r.json timing rows)"
[ "$(json r.json growth 0 time_s)" = 1 ] || complain "growth at $(json r.json growth 0 time_s)"
n=$(json r.json growth)
[ "$(json r.json growth $((n - 1)) time_s)" = "$(json r.json duration_s)" ] || complain "the last row is not in growth"
[ "$(json r.json growth $((n - 1)) height_m)" = "$(json r.json errors height_m final)" ] || complain "growth ends elsewhere"

# Samples lost: an error, or bridged. Those of the turn's beginning, so that it matters.
sed '1001,1003d' imu.csv >gap.csv
expect 2 "$SCHULER" navigate --imu gap.csv --reference ref.csv --out no.csv --json no.json
has err "gap.csv:1001: warning: gaps where samples are missing: 1, here, up to 0.04 s"
has err "gap.csv:1001:1: error: a gap"
has err "--bridge"
absent no.csv
absent no.json
nav gap.csv --bridge
has err "gap.csv:1001: warning: gaps"
fault 0 gap 1 1001 warning
[ "$(json r.json faults 0 file)" = gap.csv ] || complain "file $(json r.json faults 0 file)"
# The roll's angles of 3 samples, 1.193, 1.135, 1.078e-4 rad, are taken to be 1.022e-4: 3.4e-5 rad, of which
# gravity makes 9e-3 m/s in the 26 s that are left. Without the bridge the heading alone would lack 2e-3 rad.
below velocity_mps 1e-2
nav gap.csv --bridge --quiet
empty out
empty err

# Times with noise of a tenth of an interval: the interval is found and the flight as good as before.
awk -F, -v OFS=, 'NR > 1 { $1 = sprintf("%.6f", $1 + 0.001 * ((NR * 7919) % 10) / 10) } 1' imu.csv >noisy.csv
nav noisy.csv
has err "noisy.csv:2: warning: times off the constant interval"
[ "$(json r.json dt_s)" = 0.01 ] || complain "dt $(json r.json dt_s)"
lacks err "ref.csv"
below horizontal_m 1e-4

# A reference that is not there at the samples' times: refused when they are regular.
sed '3s/^0.5,/0.503,/' ref.csv >between.csv
expect 2 "$SCHULER" navigate --imu imu.csv --reference between.csv --out no.csv
has err "between.csv:3:1: error: time 0.503"
# With noisy times the nearest is taken: 3 ms later the place is another by 0.3 m along the velocity, which
# the flight of 100 m/s is moved by.
sed '3s/^0.5,/0.503,/' ref.csv >ref2.csv
expect 0 "$SCHULER" navigate --imu noisy.csv --reference ref2.csv --out nav.csv --json r.json
has err "ref2.csv:3: warning: reference times between two samples"
sed -n 3p nav.csv >moved
sed -n 3p ref.csv | paste -d, - moved | awk -F, '{
    d = ($12 - $2) * 111132; e = ($13 - $3) * 78847; s = sqrt(d * d + e * e); exit !(s > 0.29 && s < 0.31) }' ||
    complain "not moved along: $(cat moved)"

# A spike is no end, but told; a stuck sensor is a note of the report alone.
awk -F, -v OFS=, 'NR == 500 { $3 = 1 } 1' imu.csv >spike.csv
nav spike.csv
has err "spike.csv:500: warning: rates beyond any vehicle's: 1, here, up to 100 rad/s"
awk -F, -v OFS=, 'NR == 1000 { x = $2; y = $3; z = $4 } NR > 1000 && NR < 1050 { $2 = x; $3 = y; $4 = z } 1' imu.csv >stuck.csv
nav stuck.csv
lacks err "stand still"
has out "the three angles stand still"

# Windows files, files without a last line end, and a stream, which can be read only once.
nav imu.csv && cp nav.csv good.csv
printf '%s' "$(cat imu.csv)" >open.csv
nav open.csv && same nav.csv good.csv
cat imu.csv | "$SCHULER" navigate --imu /dev/stdin --reference ref.csv --out nav.csv -q || complain "a stream"
same nav.csv good.csv
finish
