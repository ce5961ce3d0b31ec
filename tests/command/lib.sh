# SPDX-License-Identifier: MIT
# Shared by the command tests: sourced, with SCHULER, JSON_VALUE and SOURCE_DIR set by ctest.
set -u
LC_ALL=C.UTF-8
export LC_ALL
work=$(mktemp -d) || exit 1
trap 'chmod -R u+rwx "$work" 2>/dev/null; rm -rf "$work"' EXIT
cd "$work" || exit 1
failures=0

complain() {
    echo "FAILED: $*" >&2
    failures=$((failures + 1))
}

# expect CODE COMMAND...: runs it, output in ./out and ./err
expect() {
    wanted=$1
    shift
    "$@" >out 2>err
    got=$?
    [ "$got" -eq "$wanted" ] || {
        complain "exit $got instead of $wanted: $*"
        cat err >&2
    }
}

# has FILE TEXT / lacks FILE TEXT: a fixed string
has() { grep -qF -e "$2" "$1" || { complain "'$2' is not in $1:"; cat "$1" >&2; }; }
lacks() { ! grep -qF -e "$2" "$1" || { complain "'$2' is in $1:"; cat "$1" >&2; }; }
empty() { [ ! -s "$1" ] || { complain "$1 is not empty:"; cat "$1" >&2; }; }
same() { cmp "$1" "$2" >&2 || complain "$1 and $2 differ"; }
differ() { ! cmp -s "$1" "$2" || complain "$1 and $2 are the same"; }
absent() { [ ! -e "$1" ] || complain "$1 exists"; }
# left_behind: names of unfinished files in this folder
no_partial() { [ -z "$(find . -name '*.partial*')" ] || complain "left behind: $(find . -name '*.partial*')"; }
json() { "$JSON_VALUE" "$@" || complain "json $*"; }

# A small mission, so that a run takes milliseconds.
small_scenario() {
    cat <<'YAML'
scenario: Two minutes at rest
seed: 7
runs: 12
trajectory:
  kind: static
  start: {lat: 45 deg, lon: 7 deg, height: 300 m, heading: 30 deg}
  for: 2 min
imu:
  rate: 50 Hz
  accel:
    model: linear
    bias: {normal: 50 ug}
    velocity_random_walk: 0.003 m/s/sqrt(h)
  gyro:
    model: linear
    bias: {normal: 0.01 deg/h}
    angle_random_walk: 0.002 deg/sqrt(h)
YAML
}

finish() {
    [ "$failures" -eq 0 ] || echo "$failures failures" >&2
    [ "$failures" -eq 0 ]
    exit
}
