# SPDX-License-Identifier: MIT
# JSON is valid, alone on standard output, and says the same as the table and the files.
. "$COMMAND_TESTS/lib.sh"
small_scenario >mission.yaml
echo "requirement: {drift: 10 nmi/h, statistic: CEP}" >>mission.yaml
"$SCHULER" run mission.yaml -q --json - >result.json || complain "run"
"$SCHULER" run mission.yaml --all --json file.json -o result >table 2>err || complain "run -o"
same result.json file.json
same result.json result/result.json

is() { # is VALUE KEY...
    wanted=$1
    shift
    [ "$(json result.json "$@")" = "$wanted" ] || complain "$* is $(json result.json "$@"), not $wanted"
}
is schuler-result-1 format
is "$("$SCHULER" --version | cut -d' ' -f2)" version
is "Two minutes at rest" scenario name
is "$(sha256sum mission.yaml | cut -d' ' -f1)" scenario sha256
is 7 seed
is 12 runs
is 120 duration_s
is 10 requirement limit_nmi_per_h
is CEP requirement statistic
is 0.94999999999999996 requirement confidence
is absent rss drift_cep_nmi_per_h
for key in group drift_cep_nmi_per_h share; do
    [ "$(json result.json budget 0 $key)" != absent ] || complain "no $key"
done

# Every row of the table is the JSON's row, rounded as the table rounds; shares add to one.
count=$(json result.json budget)
i=0
: >rows
while [ "$i" -lt "$count" ]; do
    echo "$(json result.json budget $i source) $(json result.json budget $i horizontal_rms_m at_end)" \
        "$(json result.json budget $i drift_cep_nmi_per_h) $(json result.json budget $i share)" >>rows
    i=$((i + 1))
done
awk -F'[ %]+' '
    FILENAME == "rows" { m[$1] = $2; cep[$1] = $3; share[$1] = $4; sum += $4; n++; next }
    /numerical residue/ { next }
    $2 in m {
        # position, drift, share are the last numbers of the line; a bar may follow
        line = $0; sub(/%.*/, "", line); k = split(line, f, " ")
        digits = length(f[k-2]) - index(f[k-2], ".")
        off = f[k-2] - m[$2]; if (off < 0) off = -off
        if (off > 0.51 * 10 ^ -digits) { print "position of " $2 ": " f[k-2] " is not " m[$2]; bad = 1 }
        digits = length(f[k-1]) - index(f[k-1], ".")
        off = f[k-1] - cep[$2]; if (off < 0) off = -off
        if (off > 0.51 * 10 ^ -digits) { print "drift of " $2 ": " f[k-1] " is not " cep[$2]; bad = 1 }
        off = f[k] - 100 * share[$2]; if (off < 0) off = -off
        if (off > 0.051) { print "share of " $2 ": " f[k] " is not " share[$2]; bad = 1 }
        seen++
    }
    END {
        if (sum < 1 - 1e-12 || sum > 1 + 1e-12) { print "shares add to " sum; bad = 1 }
        if (seen != n) { print seen " of " n " sources are in the table"; bad = 1 }
        exit bad
    }' rows table >wrong || complain "$(cat wrong table)"

# The limits of the verdict, rounded as it rounds.
awk -v lower="$(json result.json requirement lower)" -v upper="$(json result.json requirement upper)" '
    /% limits/ {
        digits = length($4) - index($4, ".")
        if ($4 - lower > 0.51 * 10 ^ -digits || lower - $4 > 0.51 * 10 ^ -digits) exit 1
        if ($6 - upper > 0.51 * 10 ^ -digits || upper - $6 > 0.51 * 10 ^ -digits) exit 1
        seen = 1
    }
    END { exit !seen }' table || complain "limits: $(grep limits table) are not those of the JSON"

# budget.csv has them too, to the last digit.
grep "^gyro.bias," result/budget.csv | grep -qF "$(json result.json budget "$(grep -n '^gyro.bias ' rows |
    cut -d: -f1 | awk '{ print $1 - 1 }')" horizontal_rms_m at_end)" || complain "budget.csv and JSON differ"

expect 0 "$SCHULER" check mission.yaml --json -
json out files 0 ok >value
[ "$(cat value)" = true ] || complain "check --json"
finish
