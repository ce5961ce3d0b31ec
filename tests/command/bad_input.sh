# SPDX-License-Identifier: MIT
# Every kind of mistake in a scenario: status 2, its place, nothing on standard output, nothing written.
. "$COMMAND_TESTS/lib.sh"
small_scenario >good.yaml
expect 0 "$SCHULER" check good.yaml
has out "good.yaml: ok, 4 error sources, 0:02:00"
empty err

# mistake SED-EXPRESSION PLACE TEXT
mistake() {
    sed "$1" good.yaml >bad.yaml
    for verb in run check; do
        expect 2 "$SCHULER" $verb bad.yaml
        has err "bad.yaml:$2: error: "
        has err "$3"
        empty out
    done
}
mistake 's/    bias: {normal: 0.01 deg.h}/    bais: {normal: 0.01 deg\/h}/' 16:5 "did you mean 'bias'?"
mistake 's/for: 2 min/for: 2 deg/' 7:10 "'deg' is a unit of angle"
mistake 's/for: 2 min/for: 2/' 7:8 "unit missing"
mistake 's/for: 2 min/for: 2 mun/' 7:10 "unknown unit"
mistake 's/^runs: 12/seed: 12/' 3:1 "duplicate key 'seed'"
mistake '/^  for: /d' 4:1 "needs the key 'for'"
mistake 's/lat: 45 deg/lat: 95 deg/' 6:16 "95"
mistake 's/kind: static/kind: sttic/' 5:9 "did you mean 'static'?"
mistake 's/^runs: 12/runs: twelve/' 3:7 "twelve"
mistake 's/heading: 30 deg}/heading: 30 deg/' 7:6 ""
mistake 's/50 ug/nan/' 12:20 ""

# All mistakes at once.
sed 's/50 ug/50/; s/0.01 deg/0.01 dog/' good.yaml >bad.yaml
expect 2 "$SCHULER" check bad.yaml
[ "$(grep -c 'error:' err)" -eq 2 ] || complain "not both mistakes: $(cat err)"
# The caret is under what is wrong.
has err "     | "

expect 2 "$SCHULER" check nothere.yaml
expect 2 "$SCHULER" check good.yaml nothere.yaml
has out "good.yaml: ok"
mkdir folder.yaml
expect 2 "$SCHULER" check folder.yaml
: >empty.yaml
expect 2 "$SCHULER" check empty.yaml
head -c 4096 "$SCHULER" >binary.yaml
expect 2 "$SCHULER" check binary.yaml
truncate -s 1G huge.yaml && expect 2 "$SCHULER" check huge.yaml
rm -f huge.yaml
if [ "$(id -u)" -ne 0 ]; then # root reads everything
    cp good.yaml secret.yaml && chmod 000 secret.yaml
    expect 2 "$SCHULER" check secret.yaml
fi
expect 2 "$SCHULER" check good.yaml/below.yaml

expect 2 "$SCHULER" run good.yaml --set imu.gyro.bais='1 deg/h'
has err "did you mean 'bias'?"
expect 2 "$SCHULER" run good.yaml --imu hg99
expect 2 "$SCHULER" run good.yaml --only gyro.bais
expect 2 "$SCHULER" run good.yaml --without nothing
expect 2 "$SCHULER" run good.yaml --set truth.gravity=egm0 -o result --json result.json
absent result
absent result.json
expect 2 "$SCHULER" check good.yaml bad.yaml --json found.json
[ "$(json found.json files 0 ok)" = true ] || complain "good.yaml is not ok in JSON"
[ "$(json found.json files 1 errors)" = 2 ] || complain "not two errors in JSON"
[ "$(json found.json files 1 diagnostics 0 line)" = 12 ] || complain "line in JSON"
no_partial
finish
