# SPDX-License-Identifier: MIT
# A processor without AVX2 and FMA takes other variants of libm: there the promise is the same noise and 1e-9
# relative for the rest. glibc can be told to behave like that machine.
. "$COMMAND_TESTS/lib.sh"
[ "$(uname -m)" = x86_64 ] || exit 77
cat >flight.yaml <<'YAML'
scenario: Ten minutes of turns
seed: 3
runs: 3
trajectory:
  kind: segments
  start: {lat: 48 deg, lon: 11 deg, height: 500 m, heading: 80 deg, speed: 90 m/s}
  segments:
    - climb: {to: 2000 m, at: 12 m/s}
    - turn:  {by: 200 deg, bank: 30 deg}
    - hold:  {for: 5 min}
imu: {use: stim300}
initial: {tilt: {normal: 0.5 mrad}, heading: {normal: 5 mrad}}
YAML
expect 0 "$SCHULER" run flight.yaml -q -o here
expect 0 env GLIBC_TUNABLES=glibc.cpu.hwcaps=-AVX2,-AVX2_Usable,-FMA,-FMA_Usable,-FMA4,-FMA4_Usable \
    "$SCHULER" run flight.yaml -q -o there
# Every figure of every report: 1e-9 of the largest in its column, or 1e-8 m, m/s, arcsec where nothing but
# rounding is there (source `none`).
paste -d, here/errors.csv there/errors.csv | awk -F, '
    NR > 1 {
        for (i = 4; i <= 12; i++) {
            a = $i; b = $(i + 12); d = a > b ? a - b : b - a; m = a < 0 ? -a : a
            if (m > largest[i]) largest[i] = m
            if (d > worst[i]) worst[i] = d
        }
        if ($1 != $13 || $2 != $14 || $3 != $15) { print "rows differ: " $0; bad = 1; exit }
        rows++
    }
    END {
        if (rows < 100) { print "only " rows " rows"; bad = 1 }
        for (i = 4; i <= 12; i++)
            if (worst[i] > 1e-9 * largest[i] + 1e-8) { print "column " i ": " worst[i] " of " largest[i]; bad = 1 }
        exit bad
    }' >out || { complain "the two machines disagree"; cat out >&2; }
finish
