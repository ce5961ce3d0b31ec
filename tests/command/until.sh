# SPDX-License-Identifier: MIT
# run --until: runs are added until the drift is known well enough; they are those that --runs gives.
. "$COMMAND_TESTS/lib.sh"

# width FILE: half the width of the limits, in percent of the drift
width() {
    echo "$(json "$1" requirement lower) $(json "$1" requirement upper) $(json "$1" requirement value_nmi_per_h)" |
        awk '{ print $2 == "null" ? 999 : 50 * ($2 - $1) / $3 }'
}
within() { awk -v w="$1" -v limit="$2" 'BEGIN { exit !(w <= limit) }'; }

for statistic in CEP R95 rms; do
    small_scenario >mission.yaml
    echo "requirement: {drift: 100 nmi/h, statistic: $statistic}" >>mission.yaml
    expect 0 "$SCHULER" run mission.yaml --until 15% --json until.json -o until
    mv out shown
    runs=$(json until.json runs)
    k=12
    while [ $k -lt "$runs" ]; do k=$((2 * k)); done
    [ $k -eq "$runs" ] && [ $k -gt 12 ] || complain "$statistic: $runs runs"
    within "$(width until.json)" 15 || complain "$statistic: $runs runs, $(width until.json) %"
    expect 0 "$SCHULER" run mission.yaml --runs "$runs" --json given.json -o given
    sed 's/ in given:/ in until:/' out >told
    same shown told
    same until.json given.json
    for file in budget.csv errors.csv result.json result.nc scenario.yaml; do same until/$file given/$file; done
    "$SCHULER" run mission.yaml --runs $((runs / 2)) --json half.json >out 2>err # 0, or 4: too few runs for limits
    within "$(width half.json)" 15 && complain "$statistic: $((runs / 2)) runs were enough"
done
# No requirement: CEP, from the number of --runs on. Nothing drawn: no more runs.
small_scenario >mission.yaml
expect 0 "$SCHULER" run mission.yaml --until 30% --runs 1000 -q --json r.json
[ "$(json r.json runs)" = 1000 ] || complain "$(json r.json runs) runs"
expect 0 "$SCHULER" run mission.yaml --only numerical --until 0.01% -q --json r.json
[ "$(json r.json runs)" = 12 ] || complain "$(json r.json runs) runs of nothing"

# More than there can be; no percentage.
expect 2 "$SCHULER" run mission.yaml --until 0.01% -o none --json none.json
has err "about 2" && has err "runs would be needed, and there can be 100000"
absent none
absent none.json
no_partial
for wrong in 2 0% -2% 60% 2s nan% '' inf 1e-9; do
    expect 2 "$SCHULER" run mission.yaml --until "$wrong"
    has err "is not a percentage"
    empty out
done
finish
