# SPDX-License-Identifier: MIT
# Help, version, and what a wrong command line says.
. "$COMMAND_TESTS/lib.sh"

expect 0 "$SCHULER" --version
grep -Eq '^schuler [0-9]+\.[0-9]+\.[0-9]+$' out || complain "version is '$(cat out)'"
expect 0 "$SCHULER" --help
empty err
cp out help
[ "$(wc -L <out)" -le 80 ] || complain "--help is wider than 80 columns"
for verb in run verify solve sweep compare report check sensors models truth navigate allan explain export characterize bench init; do
    has help "  $verb"
    expect 0 "$SCHULER" $verb --help
    empty err
    has out "Usage: schuler $verb"
    has out "Examples:"
    tail -n 3 out | grep -q -e 'Exit status' -e '^line' -e '^command' -e '^interrupted' ||
        complain "$verb --help does not end with the exit status"
    [ "$(wc -l <out)" -le 40 ] || complain "$verb --help has $(wc -l <out) lines"
    [ "$(wc -L <out)" -le 80 ] || complain "$verb --help is wider than 80 columns"
    # The manual names every option that the help names.
    grep -Eo '^ +(-[a-z], )? *--[a-z-]+' out | grep -Eo -e '--[a-z-]+' | while read -r option; do
        case $option in --help | --usage) continue ;; esac
        grep -qF -e "$option" "$SOURCE_DIR/tools/schuler.1.scd" || echo "$verb $option"
    done >missing
    empty missing
    "$SCHULER" help $verb >again
    same out again
done

expect 2 "$SCHULER"
empty out
expect 2 "$SCHULER" rn x.yaml
has err "did you mean 'run'?"
empty out
expect 2 "$SCHULER" --nonsense
expect 2 "$SCHULER" run
expect 2 "$SCHULER" run --sed 4 x.yaml
has err "unknown option '--sed'; did you mean '--seed'?"
expect 2 "$SCHULER" run -x x.yaml
expect 2 "$SCHULER" run a.yaml b.yaml
expect 2 "$SCHULER" run --runs 0 x.yaml
has err "--runs: '0' is not a whole number from 1 to 100000"
expect 2 "$SCHULER" run --runs 1e3 x.yaml
expect 2 "$SCHULER" run --seed -1 x.yaml
expect 2 "$SCHULER" run --seed 99999999999999999999 x.yaml
expect 2 "$SCHULER" run --threads many x.yaml
expect 2 "$SCHULER" run --set nothing x.yaml
expect 2 "$SCHULER" run --json "" x.yaml
expect 2 "$SCHULER" run --isa avx3 x.yaml
has err "avx2"
expect 2 "$SCHULER" check
expect 2 "$SCHULER" truth x.yaml
expect 2 "$SCHULER" navigate --imu i.csv
expect 2 "$SCHULER" navigate --imu i.csv --reference r.csv --out o.csv --vertical bara
has err "baro"
finish
