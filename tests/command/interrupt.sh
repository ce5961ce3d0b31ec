# SPDX-License-Identifier: MIT
# Ctrl-C: status 130, and nothing unfinished stays.
. "$COMMAND_TESTS/lib.sh"
small_scenario | sed 's/2 min/200 h/' >long.yaml
# A shell starts background work with SIGINT ignored, but the program sets its own handler.
interrupt() { # interrupt FILE COMMAND...: stops the command once FILE exists
    sign=$1
    shift
    "$@" >out 2>err &
    pid=$!
    i=0
    until ls $sign >/dev/null 2>&1 || [ $i -ge 300 ]; do
        sleep 0.1
        i=$((i + 1))
    done
    kill -INT $pid
    wait $pid
    code=$?
    [ $code -eq 130 ] || complain "exit $code: $*"
    has err interrupted
    empty out
    no_partial
}
interrupt 'result.partial*' "$SCHULER" run long.yaml --runs 20 -o result --json result.json
absent result
absent result.json
interrupt 'i.csv.partial*' "$SCHULER" truth long.yaml --imu-out i.csv --reference-out r.csv
absent i.csv
absent r.csv
finish
