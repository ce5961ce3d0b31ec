# SPDX-License-Identifier: MIT
# explain: what a source is, what it does in a scenario, and names that are refused.
. "$COMMAND_TESTS/lib.sh"

# Without a scenario: an example at 45 deg for an hour. 0.01 deg/h on all axes: 1.98 km (two level
# channels of 1.35 km each and 90 m of the vertical one).
expect 0 "$SCHULER" explain gyro.bias
empty err
has out "R b (t - sin(w t)/w)"
has out "0.01 deg/h (an example)"
grep -Eq '^  1:00:00 +- +19[78][0-9] +19[78][0-9]$' out || complain "not 1.98 km after an hour: $(cat out)"
lacks out "In the scenario"
[ "$(wc -L <out)" -le 80 ] || complain "wider than 80 columns"

# Every kind of source says something, and nothing is nan.
for source in accel.scale_factor accel.misalignment accel.velocity_random_walk accel.bias_instability accel.bias_random_walk \
    accel.bias_ramp accel.sinusoid accel.thermal_transient accel.quantization accel.bandwidth accel.lever_arm accel.K2 accel.bias_temperature \
    gyro.scale_factor gyro.misalignment gyro.angle_random_walk gyro.bias_instability gyro.gauss_markov gyro.gauss_markov_2 gyro.bias_random_walk \
    gyro.bias_ramp gyro.sinusoid gyro.thermal_transient gyro.quantization gyro.delay gyro.D_SS gyro.g_sensitivity gyro.lock_in \
    initial.position initial.velocity initial.tilt initial.heading gravity.disturbance numerical \
    baro.bias baro.scale_factor baro.lag baro.noise baro.gauss_markov; do
    expect 0 "$SCHULER" explain $source --json all.json
    has out "How its position error grows"
    has out "depends"
    lacks out "nan"
    [ "$(wc -L <out)" -le 80 ] || complain "$source: wider than 80 columns"
    json all.json source >out
    has out "$source"
done

# In a scenario it is what run --only says, to the last digit, whatever the threads.
small_scenario >mission.yaml
expect 0 "$SCHULER" run mission.yaml --only gyro.bias --json run.json
expect 0 "$SCHULER" explain gyro.bias mission.yaml --json explain.json --threads 1
has out "0.01 deg/h"
has out "12 runs, seed 7"
has out "95 % limits"
json run.json budget 0 horizontal_rms_m at_end >one
json explain.json simulated horizontal_rms_m >two
same one two
json run.json budget 0 drift_cep_nmi_per_h >one
json explain.json simulated drift_cep_nmi_per_h >two
same one two
expect 0 "$SCHULER" explain gyro.bias mission.yaml --json - --threads 2 --quiet
same out explain.json
# Switched off in the file: explained all the same.
{ cat mission.yaml; echo "errors: {without: [gyro]}"; } >without.yaml
expect 0 "$SCHULER" explain gyro.bias without.yaml --json off.json
json off.json simulated horizontal_rms_m >two
json explain.json simulated horizontal_rms_m >one
same one two
expect 0 "$SCHULER" explain gyro.bias mission.yaml --runs 3 --seed 8
has out "too few runs for limits: 3"
expect 0 "$SCHULER" explain gyro.bias mission.yaml --set 'imu.gyro.bias=0.02 deg/h'
has out "the same in every run"

# Not in the scenario: said so, and still explained.
expect 0 "$SCHULER" explain gyro.scale_factor mission.yaml --json zero.json
has out "not set in the scenario: zero"
has out "(an example)"
json zero.json simulated horizontal_rms_m >out
has out "null"
expect 0 "$SCHULER" explain accel.K2 mission.yaml
has out "none: the scenario's accel model is linear"
expect 0 "$SCHULER" explain gravity.disturbance mission.yaml
has out "truth.gravity and navigation.gravity are both wgs84"
expect 0 "$SCHULER" explain gravity.disturbance mission.yaml --set truth.gravity=grs80
has out "the same in every run"
expect 0 "$SCHULER" explain baro.bias mission.yaml
has out "there is no barometer"
expect 0 "$SCHULER" explain baro.bias mission.yaml --set navigation.vertical=baro
has out "not set in the scenario: zero"
expect 0 "$SCHULER" explain baro.bias mission.yaml --set navigation.vertical=baro --set 'baro.bias={normal: 50 m}'
has out "50 m"
has out "95 % limits"
expect 0 "$SCHULER" explain numerical mission.yaml
has out "drift"
# The model: the scenario's, --imu's, or the one that is asked for.
expect 0 "$SCHULER" explain gyro.D_F --model fibre_optic
has out "the gyro model fibre_optic; also of ring_laser"
expect 0 "$SCHULER" explain gyro.bias --imu hg9900
has out "0.0035 deg/h"
lacks out "an example"

# What is refused.
refuse() {
    wanted_text=$1
    shift
    expect 2 "$SCHULER" explain "$@"
    has err "$wanted_text"
    empty out
}
refuse "did you mean 'gyro.bias'?" gyro.bais
refuse "did you mean 'accel.bias'?" bias
refuse "did you mean 'initial.tilt'?" initial.til
refuse "'schuler models' lists" nothing_like_it
refuse "'schuler models' lists" ""
refuse "is a setting, no error source" gyro.gauss_markov_time
refuse "'schuler models show noise_density'" accel.noise_density
refuse "there is no gyro model 'fibre'" gyro.D_F --model fibre
refuse "there is no accel model 'ring_laser'" accel.bias --model ring_laser
refuse "the accel model 'linear' has no 'K2'; 'ieee337' has it" accel.K2 --model linear
refuse "no error of a sensor model" initial.tilt --model linear
refuse "which error source?"
refuse "which FILE?" gyro.bias --runs 3
refuse "nothere.yaml" gyro.bias nothere.yaml
refuse "one scenario file" gyro.bias mission.yaml mission.yaml
refuse "did you mean '--model'?" gyro.bias --modle linear
refuse "nothere" gyro.bias --imu nothere
sed 's/bias: {normal: 50 ug}/bais: 50 ug/' mission.yaml >wrong.yaml
refuse "wrong.yaml:" gyro.bias wrong.yaml --json no.json
absent no.json

expect 0 "$SCHULER" explain --help
has out "Examples:"
[ "$(wc -l <out)" -le 40 ] || complain "--help has $(wc -l <out) lines"
[ "$(wc -L <out)" -le 80 ] || complain "--help is wider than 80 columns"
[ ! -c /dev/full ] || expect 3 sh -c '"$SCHULER" explain gyro.bias >/dev/full'
no_partial
finish
