# SPDX-License-Identifier: MIT
# The verdict in words, in JSON and as exit status.
. "$COMMAND_TESTS/lib.sh"
small_scenario >mission.yaml
expect 0 "$SCHULER" run mission.yaml
has out "no requirement is stated"

# require LIMIT...: with the requirement; the mission is far shorter than a Schuler period, so it warns.
require() {
    { small_scenario; echo "requirement: {drift: $1 nmi/h, statistic: CEP}"; } >mission.yaml
    shift
    "$SCHULER" run mission.yaml --json r.json "$@" >out 2>err
    code=$?
}
require 1000
[ $code -eq 0 ] || complain "met: exit $code"
has out "PASS  drift"
has out "limit 1000 nmi/h CEP"
[ "$(json r.json requirement verdict)" = PASS ] || complain "not PASS in JSON"
require 0.0001
[ $code -eq 1 ] || complain "not met: exit $code"
has out "FAIL  drift"
has out "to blame"
[ "$(json r.json requirement verdict)" = FAIL ] || complain "not FAIL in JSON"
require 0.0001 --runs 2
[ $code -eq 4 ] || complain "too few runs: exit $code"
has out "INCONCLUSIVE"
has out "too few runs"
[ "$(json r.json requirement verdict)" = INCONCLUSIVE ] || complain "not INCONCLUSIVE in JSON"
[ "$(json r.json requirement upper)" = null ] || complain "an unknown bound is not null"
lacks out nan
lacks out inf

# A fixed sensor: nothing is drawn, one run tells. Quiet: the verdict and nothing else.
require 1000 --runs 1 --only accel.bias --set 'imu.accel.bias=50 ug' --quiet
[ $code -eq 0 ] || complain "fixed values, one run: exit $code"
empty err
head -n 1 out | grep -q '^PASS' || complain "quiet output: $(cat out)"

# A statistic must be said.
{ small_scenario; echo "requirement: {drift: 1 nmi/h}"; } >mission.yaml
expect 2 "$SCHULER" run mission.yaml
has err "statistic"
finish
