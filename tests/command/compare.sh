# SPDX-License-Identifier: MIT
# Several IMUs on one mission.
. "$COMMAND_TESTS/lib.sh"
small_scenario >mission.yaml
cat >twice.yaml <<'YAML'
sensor: Twice as bad
rate: 50 Hz
accel: {model: linear, bias: {normal: 100 ug}, velocity_random_walk: 0.006 m/s/sqrt(h)}
gyro: {model: linear, bias: {normal: 0.02 deg/h}, angle_random_walk: 0.004 deg/sqrt(h)}
YAML
cat >once.yaml <<'YAML'
sensor: Once
rate: 50 Hz
accel: {model: linear, bias: {normal: 50 ug}, velocity_random_walk: 0.003 m/s/sqrt(h)}
gyro: {model: linear, bias: {normal: 0.01 deg/h}, angle_random_walk: 0.002 deg/sqrt(h)}
YAML
sed '/^imu:/,$d' mission.yaml >bare.yaml
echo 'imu: {use: once.yaml}' >>bare.yaml

# The same draws, twice as large: exactly twice the drift but for what is not linear, and the worse one, given
# first, is listed last.
expect 0 "$SCHULER" compare bare.yaml --imu twice.yaml --imu once.yaml --json c.json --csv c.csv
has out "the same draws for every IMU"
has out "drifts 2 times as much as once.yaml (95 % limits 2 to 2, 12 pairs)"
[ "$(json c.json format)" = schuler-compare-1 ] || complain "format"
[ "$(json c.json imus 0 imu)" = once.yaml ] || complain "the better one is not the first"
[ "$(json c.json imus 1 rank)" = 2 ] || complain "rank"
case $(json c.json imus 1 times_the_best ratio) in 2.000* | 1.999*) ;; *) complain "ratio" ;; esac
[ "$(json c.json imus 1 result budget 0 source)" = accel.bias ] || complain "budget"
[ "$(wc -l <c.csv)" -eq 13 ] || complain "lines of c.csv: $(cat c.csv)"
has c.csv '"once.yaml",gyro.bias,'

# What it says of one IMU is what run says.
"$SCHULER" run bare.yaml --imu twice.yaml --json r.json >/dev/null 2>&1
[ "$(json r.json all drift_cep_nmi_per_h)" = "$(json c.json imus 1 drift_nmi_per_h)" ] ||
    complain "not the drift of run"

# Accelerometers of one part, gyros of another.
expect 0 "$SCHULER" compare bare.yaml --imu once.yaml --imu twice.yaml+once.yaml --json -
mv out c.json
[ "$(json c.json imus 1 result budget 0 horizontal_rms_m at_end)" != \
    "$(json c.json imus 0 result budget 0 horizontal_rms_m at_end)" ] || complain "accelerometers are the same"
[ "$(json c.json imus 1 result budget 2 horizontal_rms_m at_end)" = \
    "$(json c.json imus 0 result budget 2 horizontal_rms_m at_end)" ] || complain "gyros are not the same"

# A requirement: 0 when one meets it, 1 when none does.
echo 'requirement: {drift: 1000 nmi/h, statistic: R95}' >>bare.yaml
expect 4 "$SCHULER" compare bare.yaml --imu once.yaml --imu twice.yaml # 12 runs do not tell a 95th percentile
has out "open"
expect 0 "$SCHULER" compare bare.yaml --imu once.yaml --imu twice.yaml --runs 80
has out "PASS"
expect 1 "$SCHULER" compare bare.yaml --imu once.yaml --imu twice.yaml --runs 80 --set 'requirement.drift=1e-6 nmi/h'
has out "FAIL"

expect 2 "$SCHULER" compare bare.yaml --imu once.yaml
has err "two IMUs or more"
expect 2 "$SCHULER" compare bare.yaml --imu once.yaml --imu hg9990
has err "hg9900"
empty out
expect 2 "$SCHULER" compare bare.yaml --imu once.yaml --imu +once.yaml
empty out
no_partial
finish
