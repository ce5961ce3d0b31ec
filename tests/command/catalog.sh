# SPDX-License-Identifier: MIT
# sensors, models, init: everything listed can be shown and used.
. "$COMMAND_TESTS/lib.sh"
expect 0 "$SCHULER" sensors
cp out list
expect 0 "$SCHULER" sensors list
same out list
awk 'NR > 2 && NF > 3 && /^  / { print $1 }' list >names
[ "$(wc -l <names)" -ge 4 ] || complain "only $(wc -l <names) parts"
small_scenario | sed 's/runs: 12/runs: 2/' >mission.yaml
while read -r part; do
    expect 0 "$SCHULER" sensors show "$part"
    has out "gyro, model"
    has out "Sources"
    expect 0 "$SCHULER" run mission.yaml --imu "$part"
done <names
expect 0 "$SCHULER" sensors show hg9900
has out "* assumed"
expect 2 "$SCHULER" sensors show hg990
has err "did you mean 'hg9900'?"
expect 2 "$SCHULER" sensors show ./nothere.yaml
expect 2 "$SCHULER" sensors shwo hg9900
expect 2 "$SCHULER" sensors show

expect 0 "$SCHULER" models
for model in linear static segments route ecef wgs84 egm96; do
    has out "  $model "
done
for model in linear static segments route ecef wgs84 egm96; do
    expect 0 "$SCHULER" models show $model
    has out "$model, a "
    [ "$(wc -L <out)" -le 80 ] || complain "models show $model is wider than 80 columns"
done
expect 0 "$SCHULER" models show linear
has out "angle_random_walk"
has out "error source gyro.bias"
expect 2 "$SCHULER" models show liner
has err "did you mean 'linear'?"

expect 0 "$SCHULER" init
awk 'NF > 1 && /^  / { print $1 }' out >templates
[ "$(wc -l <templates)" -ge 4 ] || complain "only $(wc -l <templates) templates"
mkdir folder
while read -r template; do
    expect 0 "$SCHULER" init "$template" folder
    has out "schuler run folder/$template.yaml"
    same "folder/$template.yaml" "$SOURCE_DIR/scenarios/$template.yaml"
    expect 0 "$SCHULER" check "folder/$template.yaml"
done <templates
expect 0 "$SCHULER" init static
expect 2 "$SCHULER" init static
has err "not overwritten"
expect 2 "$SCHULER" init sttic
has err "did you mean 'static'?"
expect 2 "$SCHULER" init static nowhere
no_partial
finish
