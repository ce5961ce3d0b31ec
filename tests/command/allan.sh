# SPDX-License-Identifier: MIT
# allan: coefficients of recorded data, a sensor file that run accepts, and data that are refused.
. "$COMMAND_TESTS/lib.sh"

# A minute of white noise at 100 Hz: sums of twelve uniform numbers less six, 1e-3 rad/s on each axis,
# about the earth's rate; and gravity. N = 1e-3 sqrt(0.01) rad/sqrt(s) = 0.3438 deg/sqrt(h).
awk 'BEGIN {
    srand(5)
    print "time_s,gx_radps,gy_radps,gz_radps,ax_mps2,ay_mps2,az_mps2"
    for (k = 1; k <= 6000; k++) {
        printf "%.2f", k / 100
        for (i = 0; i < 6; i++) {
            sum = -6
            for (j = 0; j < 12; j++) sum += rand()
            printf ",%.9g", i == 5 ? -9.80665 + 1e-2 * sum : (i < 3 ? 1e-3 * sum + 4e-5 : 1e-2 * sum)
        }
        print ""
    }
}' >rates.csv

expect 0 "$SCHULER" allan rates.csv --psd --terms N --out my.yaml --name my-imu --json a.json --csv a.csv --psd-csv p.csv
has out "angle random walk, deg/sqrt(h)"
has err "wrote my.yaml"
lacks err "warning"
has a.csv "tau"
# Six thousand numbers give N to 1 %; five of those.
sed -n '/angle_random_walk/,/}/p' a.json | awk '/"value"/ { gsub(",", ""); if ($2 < 0.327 || $2 > 0.361) bad = 1 } END { exit bad }' ||
    complain "the angle random walk is not 0.344 deg/sqrt(h) within 5 %"
expect 0 "$SCHULER" sensors show ./my.yaml
has out "angle_random_walk"
small_scenario >mission.yaml
expect 0 "$SCHULER" run mission.yaml --imu my.yaml --runs 4
has out "gyro.angle_random_walk"
expect 0 "$SCHULER" allan rates.csv --quiet --json - --threads 1
cp out one
expect 0 "$SCHULER" allan rates.csv --quiet --json - --threads 2
same out one

# Units and rate from the command line, one column.
cut -d, -f2 rates.csv | sed 's/gx_radps/gx/' >one.csv
expect 0 "$SCHULER" allan one.csv --columns gx:rad/s --rate 100Hz
expect 2 "$SCHULER" allan one.csv --columns gx:rad/s
has err "rate"
expect 2 "$SCHULER" allan one.csv --columns hx:rad/s --rate 100Hz
has err "gx"
expect 2 "$SCHULER" allan one.csv --columns gx:rad/sss --rate 100Hz
has err "unit"

# Data that are refused, with their place.
sed '3001d' rates.csv >gap.csv
expect 2 "$SCHULER" allan gap.csv --out no.yaml
has err "gap.csv:3001: error: a gap"
sed '51{h;G}' rates.csv >twice.csv
expect 2 "$SCHULER" allan twice.csv
has err "twice.csv:52: error: time 0.5 s is repeated"
sed '100s/,[^,]*/,nan/' rates.csv >nan.csv
expect 2 "$SCHULER" allan nan.csv
has err "nan.csv:100:"
sed '1d' rates.csv >headless.csv
expect 2 "$SCHULER" allan headless.csv
: >empty.csv
expect 2 "$SCHULER" allan empty.csv --out no.yaml
expect 2 "$SCHULER" allan nothere.csv --out no.yaml
absent no.yaml
# A wrong unit by a power of ten is doubted.
sed '1s/mps2/g/g' rates.csv >in_g.csv
expect 0 "$SCHULER" allan in_g.csv
has err "is the unit right?"
no_partial
finish
