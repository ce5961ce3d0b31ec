# SPDX-License-Identifier: MIT
# characterize: sensors on a test stand, as tables, files and a picture; what is refused.
. "$COMMAND_TESTS/lib.sh"

cat >two.yaml <<'YAML'
sensor: two
accel: {model: linear, bias: {normal: 1 mg}, velocity_random_walk: 0.06 m/s/sqrt(h)}
gyro: {model: linear, bias: {uniform: 10 deg/h}, angle_random_walk: 0.6 deg/sqrt(h)}
YAML

# 0.06 m/s/sqrt(h) is 1e-3 m/s/sqrt(s), 0.01 m/s2 rms at 100 Hz, 1.02 mg; 1000 units have the mean bias
# within 4 mg/sqrt(1000).
expect 0 "$SCHULER" characterize two.yaml --units 1000 --json c.json --csv c.csv --series s.csv --allan a.csv
has out "Mean output of a unit, g"
has out "Allan deviation, mg"
has out "two"
within() { # GROUP NAME LEAST MOST
    x=$(json c.json sensors 0 "$1" "$2")
    awk -v x="$x" -v a="$3" -v b="$4" 'BEGIN { exit !(x != "absent" && x + 0 >= a && x + 0 <= b) }' ||
        complain "$1 $2 is $x, not from $3 to $4"
}
within output mean 9.8054 9.8079
within output spread 0.0089 0.0107
within noise mean 0.00999 0.01001
[ "$(wc -l <s.csv)" = 1001 ] || complain "a series of 10 s at 100 Hz has 1000 rows"
head -1 a.csv | grep -q '^sensor,tau_s,simulated_mps2,error_mps2,data_sheet_mps2$' || complain "head of a.csv"
awk -F, 'NR > 1 && ($3 / $5 > 1 + 5 * $4 / $3 || $3 / $5 < 1 - 5 * $4 / $3) { bad = 1 } END { exit bad }' a.csv ||
    complain "the Allan deviation is not the data sheet's"

# The same whatever the threads; another seed is another sample; side by side; a source alone.
expect 0 "$SCHULER" characterize two.yaml --quiet --json - --threads 1
cp out one
expect 0 "$SCHULER" characterize two.yaml --quiet --json - --threads 2
same out one
expect 0 "$SCHULER" characterize two.yaml --quiet --json - --seed 2
differ out one
expect 0 "$SCHULER" characterize two.yaml stim300 --instrument gyro --input "100 deg/s" --cross "0 deg/s" --rate 50Hz --for 5s
has out "stim300"
has out "input 100 deg/s, across it 0 deg/s"
expect 0 "$SCHULER" characterize two.yaml --only accel.bias --json c.json
within noise most 0 1e-9
expect 0 "$SCHULER" characterize two.yaml --without accel.bias --json c.json
within output spread 0 0.001
expect 0 "$SCHULER" characterize paper --units 8 --for 0.1s --json c.json
[ "$(json c.json sensors)" = 10 ] || complain "the paper has ten sensors"
expect 0 "$SCHULER" characterize ms1010
expect 2 "$SCHULER" characterize ms1010 --instrument gyro
has err "'ms1010' has no gyro"
if command -v gnuplot >/dev/null; then
    expect 0 "$SCHULER" characterize two.yaml stim300 --plot p.svg
    has p.svg "<svg"
else
    expect 3 "$SCHULER" characterize two.yaml --plot p.svg
    has err "gnuplot is not installed"
fi

expect 2 "$SCHULER" characterize
expect 2 "$SCHULER" characterize stim30
has err "stim300"
expect 2 "$SCHULER" characterize two.yaml --input "1 deg/s"
has err "--input"
expect 2 "$SCHULER" characterize two.yaml --only accel.bies
has err "did you mean 'accel.bias'"
expect 2 "$SCHULER" characterize two.yaml --for 1us
has err "samples of a unit"
expect 2 "$SCHULER" characterize two.yaml --for 100h --csv no.csv
has err "samples of a unit"
absent no.csv
expect 2 "$SCHULER" characterize two.yaml --plot p.pdf
expect 2 "$SCHULER" characterize two.yaml --units 0
expect 2 "$SCHULER" characterize two.yaml --instrument magnetometer
printf 'sensor: broken\naccel: {model: linear, bias: 1 deg}\ngyro: {model: linear}\n' >broken.yaml
expect 2 "$SCHULER" characterize broken.yaml
has err "broken.yaml:2"
finish
