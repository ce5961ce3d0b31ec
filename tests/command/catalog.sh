# SPDX-License-Identifier: MIT
# sensors, models, init: everything listed can be shown and used.
. "$COMMAND_TESTS/lib.sh"
expect 0 "$SCHULER" sensors
cp out list
expect 0 "$SCHULER" sensors list
same out list
[ "$(wc -L <list)" -le 100 ] || complain "sensors is wider than 100 columns"
awk '/^  / { print $1 }' list >names
[ "$(wc -l <names)" -ge 70 ] || complain "only $(wc -l <names) parts"
small_scenario | sed 's/runs: 12/runs: 2/' >mission.yaml
expect 0 "$SCHULER" sensors --kind imu
awk '/^  / { print $1 }' out >imus
[ "$(wc -l <imus)" -ge 25 ] || complain "only $(wc -l <imus) IMUs"
while read -r part; do
    expect 0 "$SCHULER" sensors show "$part"
    has out "Sources"
done <names
while read -r part; do
    expect 0 "$SCHULER" run mission.yaml --imu "$part"
    lacks err "catalog:"
done <imus
# Accelerometers and gyros of their own makers in one IMU; half an IMU is not enough.
expect 0 "$SCHULER" run mission.yaml --set "imu.accel={use: ms1010}" --set "imu.gyro={use: stim210}"
has out "accel.bias"
expect 2 "$SCHULER" run mission.yaml --imu ms1010
has err "gyro"
expect 2 "$SCHULER" run mission.yaml --set "imu.gyro={use: ms1010}"
has err "has no gyros"
expect 0 "$SCHULER" sensors show hg9900
has out "* Assumed"
has out "accel.misalignment: "

# Filters, files and differences.
expect 0 "$SCHULER" sensors --grade navigation --csv -
has out 'name,title,kind,grade'
absent ./-
expect 0 "$SCHULER" sensors --grade navigation --kind imu --json - --csv t.csv
[ "$(json out format)" = schuler-sensors-1 ] || complain "sensors --json - is not JSON alone"
[ "$(json out sensors 0 name)" = hg9900 ] || complain "hg9900 is not the first navigation-grade IMU"
[ "$(json out sensors 0 gyro_bias)" = "0.0035 deg/h 1σ" ] || complain "gyro_bias in JSON"
has t.csv 'name,title,kind,grade'
has t.csv '"ln-100"'
expect 0 "$SCHULER" sensors --technology FOG
has out "astrix-200"
lacks out "hg4930"
expect 0 "$SCHULER" sensors --maker honeywell
has out "hg4930-c"
lacks out "bmi088"
expect 2 "$SCHULER" sensors --maker nobody
has err "no part"
expect 2 "$SCHULER" sensors --grade tacticle
has err "did you mean 'tactical'?"
expect 2 "$SCHULER" sensors --kind radar
expect 0 "$SCHULER" sensors diff stim300 hg4930-c
grep -q '^    bias  *4 deg/h 1σ  *7 deg/h 1σ  *1.75$' out || complain "the ratio of two biases"
has out "g_sensitivity"
[ "$(wc -L <out)" -le 100 ] || complain "sensors diff is wider than 100 columns"
expect 2 "$SCHULER" sensors diff stim300
expect 2 "$SCHULER" sensors diff stim300 hg4930
has err "did you mean 'hg4930-"
expect 2 "$SCHULER" sensors show hg9900 --grade tactical
expect 2 "$SCHULER" sensors show hg990
has err "did you mean 'hg9900'?"
expect 2 "$SCHULER" sensors show ./nothere.yaml
expect 2 "$SCHULER" sensors shwo hg9900
expect 2 "$SCHULER" sensors show

expect 0 "$SCHULER" models
cp out list_of_models
[ "$(wc -L <out)" -le 80 ] || complain "models is wider than 80 columns"
for model in linear static segments route ecef wgs84 egm96; do
    has out "  $model "
done
for model in linear static segments route ecef wgs84 egm96; do
    expect 0 "$SCHULER" models show $model
    has out "$model, a "
    [ "$(wc -L <out)" -le 80 ] || complain "models show $model is wider than 80 columns"
done
expect 0 "$SCHULER" models show linear
has out "error source gyro.bias"
expect 2 "$SCHULER" models show liner
has err "did you mean 'linear'?"

# Models and stages: each is listed, can be shown, fits the screen, and says its keys.
expect 0 "$SCHULER" models --json models.json
same out list_of_models
for kind in sensor_models stages spellings; do
    count=$(json models.json $kind)
    [ "$count" -ge 1 ] || complain "no $kind in JSON"
    for at in $(seq 0 $((count - 1))); do
        name=$(json models.json $kind "$at" name)
        expect 0 "$SCHULER" models show "$name"
        [ "$(wc -L <out)" -le 80 ] || complain "models show $name is wider than 80 columns"
        has out "source: "
        [ $kind = spellings ] && continue
        for instrument in accel gyro; do
            keys=$(json models.json $kind "$at" $instrument)
            [ "$keys" != null ] || continue
            for key in $(seq 0 $((keys - 1))); do
                word=$(json models.json $kind "$at" $instrument "$key" key)
                has out "    $word: "
                [ $kind = sensor_models ] || has list_of_models "$word"
            done
        done
    done
done
# Gravity: what is installed and where, and how to get the rest.
mkdir gravity
printf 'EGMF-1\nName bad\n' >gravity/bad.egm
with_gravity() { expect 0 env GEOGRAPHICLIB_GRAVITY_PATH="$PWD/gravity" "$SCHULER" "$@"; }
with_gravity models --json gravity.json
has out "geographiclib-get-gravity egm2008"
has out "cannot be read"
count=$(json gravity.json gravity)
[ "$count" -eq 5 ] || complain "$count gravity models instead of 5"
[ "$(json gravity.json gravity 0 built_in)" = true ] || complain "wgs84 is not built in"
[ "$(json gravity.json gravity 2 installed)" = false ] || complain "egm96 is installed"
[ "$(json gravity.json gravity 2 install)" = "geographiclib-get-gravity egm96" ] ||
    complain "egm96 cannot be installed"
[ "$(json gravity.json gravity 4 name)" = bad ] || complain "the data set is not listed"
for model in egm96 bad; do
    with_gravity models show $model
    has out "install: geographiclib-get-gravity $model"
done
expect 2 env GEOGRAPHICLIB_GRAVITY_PATH="$PWD/gravity" "$SCHULER" models show egm9
has err "did you mean 'egm96'?"
expect 0 "$SCHULER" models show bias_instability
has out "flicker, an error beside those"
expect 0 "$SCHULER" models show bandwidth
has out "one of second, first; default second"
expect 0 "$SCHULER" models show noise_density
has out "one-sided"
expect 0 "$SCHULER" models --json -
[ "$(json out format)" = schuler-models-1 ] || complain "models --json - is not JSON alone"
[ "$(json out sensor_models 0 accel 0 source)" = accel.bias ] || complain "source in models --json"
expect 2 "$SCHULER" models --plugin nothere.so
has err "nothere.so: error: no such plug-in"

expect 0 "$SCHULER" init
awk 'NF > 1 && /^  / { print $1 }' out >templates
[ "$(wc -l <templates)" -ge 4 ] || complain "only $(wc -l <templates) templates"
mkdir folder
while read -r template; do
    expect 0 "$SCHULER" init "$template" folder
    has out "schuler run folder/$template.yaml"
    same "folder/$template.yaml" "$SOURCE_DIR/scenarios/$template.yaml"
    # One mission is flown in a real field; the others need nothing that does not come with the program.
    if [ "$template" = submarine ]; then
        expect 2 env GEOGRAPHICLIB_GRAVITY_PATH="$PWD/gravity" "$SCHULER" check "folder/$template.yaml"
        has err "folder/submarine.yaml: error: truth.gravity: gravity model 'egm96'"
        has err "install with 'geographiclib-get-gravity egm96'"
        expect 2 env GEOGRAPHICLIB_GRAVITY_PATH="$PWD/gravity" "$SCHULER" run "folder/$template.yaml"
        has err "install with 'geographiclib-get-gravity egm96'"
        expect 0 "$SCHULER" run "folder/$template.yaml" --set truth.gravity=wgs84 --only numerical --runs 1
        has out "Three days submerged"
    else
        expect 0 "$SCHULER" check "folder/$template.yaml"
    fi
done <templates
expect 0 "$SCHULER" init static
expect 2 "$SCHULER" init static
has err "not overwritten"
expect 2 "$SCHULER" init sttic
has err "did you mean 'static'?"
expect 2 "$SCHULER" init static nowhere
no_partial
finish
