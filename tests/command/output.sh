# SPDX-License-Identifier: MIT
# Result files appear complete or not at all; every write is checked.
. "$COMMAND_TESTS/lib.sh"
small_scenario >mission.yaml
expect 0 "$SCHULER" run mission.yaml -o result
for file in budget.csv errors.csv result.json result.nc scenario.yaml; do
    [ -s result/$file ] || complain "no $file"
    has out $file
done
[ "$(ls result | wc -l)" -eq 5 ] || complain "more in it: $(ls result)"
head -n 1 result/errors.csv >header
echo "source,run,time_s,north_m,east_m,down_m,vn_mps,ve_mps,vd_mps,roll_arcsec,pitch_arcsec,heading_arcsec" >wanted
same header wanted
for source in all none accel.bias gyro.bias gyro.angle_random_walk; do
    grep -q "^$source,0,120," result/errors.csv || complain "no end of $source in errors.csv"
done
grep '^none,' result/errors.csv | head -n 1 | grep -q '^none,0,0,' || complain "no row at time 0"

# The NetCDF file: numbers of a run's end are those of errors.csv, and what made it stands in it.
if command -v ncdump >/dev/null 2>&1; then
    expect 0 "$SCHULER" run mission.yaml --seed 3 --set 'report.every=40 s' -o told
    expect 0 ncdump -h told/result.nc
    has out "source = 7 ;"
    has out "run = 12 ;"
    has out "time = 3 ;"
    has out 'end_m:units = "m" ;'
    has out ':Conventions = "CF-1.8" ;'
    has out ':format = "schuler-result-1" ;'
    has out ":command = \"schuler run SCENARIO --seed 3 --set \\'report.every=40 s\\'\" ;"
    has out ":seed = 3ULL ;"
    has out ":runs = 12ULL ;"
    has out 'scenario: Two minutes at rest\nseed: 7'
    ncdump -v source_name told/result.nc | sed -n '/^ source_name/,/;/p' | grep -o '"[^"]*"' | tr -d '"' >got
    printf '%s\n' accel.bias accel.velocity_random_walk gyro.bias gyro.angle_random_walk numerical all none >wanted
    same got wanted
    ncdump -v end_m -p 9,17 told/result.nc | sed -n '/^ end_m/,/;/p' | tr -d ' \n;' | sed 's/end_m=//' | tr , '\n' >got
    echo >>got
    awk -F, '$3 == 120 && $1 == "all" { printf "%.17g\n", sqrt($4 * $4 + $5 * $5) }' told/errors.csv >wanted
    sed -n 61,72p got | paste -d' ' - wanted | awk '
        { d = $1 - $2; if (d < 0) d = -d; if (!(d <= 1e-15 * $2)) bad++ } END { exit bad > 0 || NR != 12 }' ||
        complain "end_m: $(sed -n 61,72p got | paste - wanted)"
fi

# Without the library of such files there is none, and all else as before.
mkdir none
echo nothing >none/libnetcdf.so.19
expect 0 env LD_LIBRARY_PATH="$work/none" "$SCHULER" run mission.yaml -o without
has err "warning: no result.nc: NetCDF files need the library"
lacks out result.nc
absent without/result.nc
same without/result.json result/result.json
same without/errors.csv result/errors.csv
expect 0 env LD_LIBRARY_PATH="$work/none" "$SCHULER" run mission.yaml -o without --quiet
empty err
[ "$(ls without | wc -l)" -eq 4 ] || complain "in it: $(ls without)"
# Nothing is left of an earlier one.
expect 0 env LD_LIBRARY_PATH="$work/none" "$SCHULER" run mission.yaml -o result --quiet
absent result/result.nc

# The copy runs again and gives the same budget.
"$SCHULER" run mission.yaml --seed 3 -o seeded >out || complain "run --seed 3"
has seeded/scenario.yaml "--seed 3"
expect 0 "$SCHULER" run seeded/scenario.yaml --seed 3 -o copied
grep -v '^#' seeded/budget.csv >a
grep -v '^#' copied/budget.csv >b
same a b

# An earlier result is replaced, anything else is refused.
expect 0 "$SCHULER" run mission.yaml --seed 3 -o result
same result/errors.csv seeded/errors.csv
mkdir empty && expect 0 "$SCHULER" run mission.yaml -o empty/
[ -s empty/result.json ] || complain "nothing in the empty directory"
mkdir mine && echo precious >mine/thesis.txt
expect 2 "$SCHULER" run mission.yaml -o mine
has err thesis.txt
[ "$(ls mine)" = thesis.txt ] || complain "touched: $(ls mine)"
echo precious >file
expect 2 "$SCHULER" run mission.yaml -o file
[ "$(cat file)" = precious ] || complain "file overwritten"
expect 3 "$SCHULER" run mission.yaml -o no/such/place
expect 3 "$SCHULER" run mission.yaml --json no/such/place.json
# A picture, where gnuplot is.
small_scenario >plotted.yaml
if command -v gnuplot >/dev/null; then
    expect 0 "$SCHULER" run plotted.yaml --plot p.svg --quiet
    has p.svg "<svg"
    has p.svg "accel.bias"
    expect 0 "$SCHULER" run plotted.yaml --plot p.svg --rows groups
    expect 0 "$SCHULER" run plotted.yaml --plot p.svg --without accel,gyro
else
    expect 3 "$SCHULER" run plotted.yaml --plot p.svg
    has err "gnuplot is not installed"
fi
expect 2 "$SCHULER" run plotted.yaml --plot p.pdf
no_partial

# Nowhere to write to.
if [ -c /dev/full ]; then
    "$SCHULER" run mission.yaml >/dev/full 2>err
    [ $? -eq 3 ] || complain "full standard output"
    "$SCHULER" --help >/dev/full 2>err
    [ $? -eq 3 ] || complain "full standard output, help"
    "$SCHULER" run mission.yaml --json - >/dev/full 2>err
    [ $? -eq 3 ] || complain "full standard output, JSON"
fi
# What is no regular file is written to and never replaced. A device of our own: were this to go wrong as
# root, it must not be the system's.
full=/dev/full
[ "$(id -u)" -ne 0 ] || { mknod full c 1 7 2>mknod.err && full=full || full=; }
if [ -c "$full" ]; then
    expect 3 "$SCHULER" run mission.yaml --json "$full"
    expect 3 "$SCHULER" truth mission.yaml --imu-out "$full"
    [ -c "$full" ] || complain "the device was replaced"
fi
mkfifo pipe
timeout 60 cat pipe >piped &
expect 0 "$SCHULER" run mission.yaml --json pipe
wait
[ -p pipe ] || complain "the pipe was replaced"
json piped format >value
"$SCHULER" run mission.yaml >&- 2>err
[ $? -eq 3 ] || complain "closed standard output"
empty err
"$SCHULER" run mission.yaml --json kept.json -q >&- 2>err
[ $? -eq 0 ] || complain "closed standard output that is not needed"
json kept.json format >value
{ "$SCHULER" run mission.yaml 2>err; echo $? >code; } | :
code=$(cat code)
[ "$code" -eq 0 ] || [ "$code" -eq 3 ] || complain "closed pipe: $code"
empty err

# A file system that fills up while writing. Only root may make one.
if [ "$(id -u)" -eq 0 ] && mkdir tiny && mount -t tmpfs -o size=64k tmpfs tiny 2>mounted; then
    trap 'umount tiny 2>/dev/null; rm -rf "$work"' EXIT
    expect 3 "$SCHULER" run mission.yaml -o tiny/result
    has err "No space left"
    [ -z "$(ls tiny)" ] || complain "left behind: $(ls tiny)"
    expect 3 "$SCHULER" truth mission.yaml --imu-out tiny/i.csv --reference-out tiny/r.csv
    [ -z "$(ls tiny)" ] || complain "left behind: $(ls tiny)"
    umount tiny
    # Room for all but the NetCDF file.
    mount -t tmpfs -o size=220k tmpfs tiny
    expect 3 "$SCHULER" run mission.yaml -o tiny/result
    has err "result.nc: No space left"
    [ -z "$(ls tiny)" ] || complain "left behind: $(ls tiny)"
    umount tiny
fi
finish
