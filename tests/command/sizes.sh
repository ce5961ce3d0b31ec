# SPDX-License-Identifier: MIT
# verify, solve and sweep.
. "$COMMAND_TESTS/lib.sh"
{ small_scenario; echo 'requirement: {drift: 1 nmi/h, statistic: CEP}'; } >met.yaml
{ small_scenario; echo 'requirement: {drift: 0.0001 nmi/h, statistic: CEP}'; } >missed.yaml
{ small_scenario; echo 'requirement: {drift: 0.045 nmi/h, statistic: CEP}'; } >close.yaml

# One, several: the worst verdict is the status.
expect 0 "$SCHULER" verify met.yaml
has out "PASS"
expect 4 "$SCHULER" verify met.yaml close.yaml
has out "UNDECIDED"
has out "would tell"
expect 1 "$SCHULER" verify met.yaml missed.yaml close.yaml --junit v.xml --json v.json
[ "$(json v.json verdicts 1 verdict)" = FAIL ] || complain "verdict in JSON"
has v.xml 'tests="3" failures="1" errors="1"'
has v.xml '<testcase classname="missed.yaml" name="Two minutes at rest"'
[ "$(grep -c '</testcase>' v.xml)" -eq 3 ] || complain "three cases: $(cat v.xml)"
# A wider interval with more confidence; the same value as run.
"$SCHULER" verify close.yaml --confidence '99 %' --json wide.json >/dev/null 2>&1
"$SCHULER" run close.yaml --json run.json >/dev/null 2>&1
[ "$(json wide.json verdicts 0 value_nmi_per_h)" = "$(json run.json requirement value_nmi_per_h)" ] ||
    complain "not the value of run"
awk "BEGIN { exit !($(json wide.json verdicts 0 upper) >= $(json run.json requirement upper)) }" ||
    complain "99 % limits are narrower than 95 %"
small_scenario >none.yaml
expect 2 "$SCHULER" verify none.yaml
has err "no requirement"
expect 0 "$SCHULER" verify none.yaml --preset mil_0p8
has out "limit 0.8 nmi/h"
expect 2 "$SCHULER" verify none.yaml --preset mil_1nmy
has err "mil_1nmi"
# Rows of groups, and all but one: what a group of one source is, is that source; without a source is a run
# with --without it.
"$SCHULER" run met.yaml --rows groups --json g.json >/dev/null 2>&1
"$SCHULER" run met.yaml --only gyro --json gyro.json >/dev/null 2>&1
[ "$(json g.json budget 1 source)" = gyro ] || complain "groups: $(json g.json budget 1 source)"
[ "$(json g.json budget 1 horizontal_rms_m at_end)" = "$(json gyro.json all horizontal_rms_m at_end)" ] ||
    complain "the row of a group is not that group alone"
expect 0 "$SCHULER" run met.yaml --rows without --json w.json
has out "without each source"
lacks out "root sum square"
"$SCHULER" run met.yaml --without accel.bias --json less.json >/dev/null 2>&1
[ "$(json w.json budget 0 source)" = "without accel.bias" ] || complain "without: $(json w.json budget 0 source)"
[ "$(json w.json budget 0 horizontal_rms_m at_end)" = "$(json less.json all horizontal_rms_m at_end)" ] ||
    complain "all but one is not --without that one"
expect 2 "$SCHULER" run met.yaml --rows group
has err "groups"

expect 2 "$SCHULER" verify met.yaml --confidence '101 %'
expect 2 "$SCHULER" verify met.yaml absent.yaml
empty out

# One linear source alone: the factor is the limit over the drift, to the tolerance of the search.
"$SCHULER" run met.yaml --only accel.bias --json run.json >/dev/null 2>&1
expect 0 "$SCHULER" solve met.yaml --only accel.bias --for accel.bias --json s.json
awk "BEGIN { x = $(json s.json solutions 0 factor) * $(json run.json requirement value_nmi_per_h); exit !(x > 0.998 && x < 1.002) }" ||
    complain "factor $(json s.json solutions 0 factor)"
awk "BEGIN { x = $(json run.json budget 0 margin) / $(json s.json solutions 0 factor); exit !(x > 0.998 && x < 1.002) }" ||
    complain "margin of run: $(json run.json budget 0 margin)"
has out "ug 1σ"
# What it says is so: with that value the requirement is just met.
"$SCHULER" run met.yaml --only accel.bias --json run.json \
    --set "imu.accel.bias={normal: $(awk "BEGIN { print 50 * $(json s.json solutions 0 factor) }") ug}" >/dev/null 2>&1
awk "BEGIN { x = $(json run.json requirement value_nmi_per_h); exit !(x > 0.998 && x < 1.002) }" ||
    complain "drift with the solution: $(json run.json requirement value_nmi_per_h)"
expect 0 "$SCHULER" solve missed.yaml --for gyro.bias,accel.bias
has out "no value suffices"
has out "all of these together"
expect 2 "$SCHULER" solve met.yaml --for gyro.bais
has err "did you mean 'gyro.bias'"
expect 2 "$SCHULER" solve none.yaml --for gyro.bias
has err "no requirement"

# A linear source alone drifts in proportion; the table is the same on any number of threads.
expect 0 "$SCHULER" sweep met.yaml 'accel.bias=10..160 ug' --only accel.bias --points 3 --json w.json --csv w.csv
awk "BEGIN { a = $(json w.json points 0 drift_cep_nmi_per_h); b = $(json w.json points 1 drift_cep_nmi_per_h);
    c = $(json w.json points 2 drift_cep_nmi_per_h); exit !(b / a > 3.999 && b / a < 4.001 && c / b > 3.999 && c / b < 4.001) }" ||
    complain "not in proportion: $(cat w.csv)"
[ "$(wc -l <w.csv)" -eq 4 ] || complain "lines of w.csv"
expect 0 "$SCHULER" sweep met.yaml 'accel.bias=10..160 ug' --only accel.bias --points 3 --csv - --threads 1
same out w.csv
expect 0 "$SCHULER" sweep met.yaml 'gyro.bias=0..0.02 deg/h' 'accel.bias=1..90 ug' --even --points 2
has out "accel.bias, ug"
for bad in 'accel.bias=10..160' 'accel.bias=160..10 ug' 'accel.bias=0..10 ug' 'accel.bias' 'accel.bias=..3 ug' \
    'accel.bias=10..160 deg' 'gyro.bais=1..2 deg/h' 'accel.bias=1..' '=1..2 ug' 'accel.bias=nan..2 ug'; do
    expect 2 "$SCHULER" sweep met.yaml "$bad"
    empty out
done
expect 2 "$SCHULER" sweep met.yaml 'accel.bias=1..2 ug' 'accel.bias=1..3 ug'
no_partial
finish
