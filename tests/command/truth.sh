# SPDX-License-Identifier: MIT
# What truth writes: rates instead of increments, NetCDF instead of CSV.
. "$COMMAND_TESTS/lib.sh"
small_scenario >mission.yaml

# Rates at rest: those of the increments divided by the interval, the same row after row; one more, at 0 s.
expect 0 "$SCHULER" truth mission.yaml --imu-out rates.csv --rates
expect 0 "$SCHULER" truth mission.yaml --imu-out imu.csv
[ "$(wc -l <rates.csv)" -eq 6002 ] || complain "$(wc -l <rates.csv) lines of rates"
head -n 1 rates.csv >header
echo "time_s,omega_x_radps,omega_y_radps,omega_z_radps,f_x_mps2,f_y_mps2,f_z_mps2" >wanted
same header wanted
[ "$(sed -n '2s/,.*//p' rates.csv)" = 0 ] || complain "the first row is $(sed -n 2p rates.csv)"
tail -n +3 rates.csv >a
tail -n +2 imu.csv | paste -d, a - | awk -F, '
    { for (i = 2; i <= 7; i++) { d = $i - $(i + 7) / 0.02; if (d < 0) d = -d; if (d > 1e-12) bad++ } }
    $1 != $8 { bad++ }
    END { exit bad > 0 || NR != 6000 }' || complain "rates are not those of the increments"
# They are what allan takes without being told.
expect 0 "$SCHULER" allan rates.csv
expect 2 "$SCHULER" truth mission.yaml --reference-out r.csv --rates
has err "--rates"
absent r.csv

# NetCDF: both files, as one run wrote them, and again with the same bytes.
expect 0 "$SCHULER" truth mission.yaml --imu-out i.nc --reference-out r.nc --reference-every '10 s' --set 'imu.rate=10 Hz'
empty out
empty err
no_partial
cp i.nc once.nc
expect 0 "$SCHULER" truth mission.yaml --imu-out i.nc --reference-out r.nc --reference-every '10 s' --set 'imu.rate=10 Hz'
same i.nc once.nc
expect 0 "$SCHULER" truth mission.yaml --imu-out i.csv --reference-out r.csv --reference-every '10 s' --set 'imu.rate=10 Hz'

# Read back, they are the same data.
expect 0 "$SCHULER" navigate --imu i.nc --reference r.nc --out nav_nc.csv
expect 0 "$SCHULER" navigate --imu i.csv --reference r.csv --out nav.csv
same nav_nc.csv nav.csv
head -c 5000 i.nc >torn.nc
expect 2 "$SCHULER" navigate --imu torn.nc --reference r.nc --out nav.csv
has err "torn.nc: error: cannot be read"
expect 2 "$SCHULER" navigate --imu r.nc --reference r.nc --out nav.csv
has err "there is no variable 'dtheta_x_rad'"

# What cannot hold one, and what goes wrong, leaves nothing.
expect 2 "$SCHULER" truth mission.yaml --imu-out bad.nc --set 'imu.rate=0 Hz'
absent bad.nc
mkfifo pipe.nc
expect 2 "$SCHULER" truth mission.yaml --imu-out pipe.nc
has err "needs a regular file"
[ -p pipe.nc ] || complain "the pipe was replaced"
expect 3 "$SCHULER" truth mission.yaml --imu-out no/such.nc
expect 3 "$SCHULER" truth mission.yaml --imu-out x.nc --reference-out no/such.csv
absent x.nc
no_partial
if [ "$(id -u)" -eq 0 ] && mkdir tiny && mount -t tmpfs -o size=64k tmpfs tiny 2>mounted; then
    trap 'umount tiny 2>/dev/null; rm -rf "$work"' EXIT
    expect 3 "$SCHULER" truth mission.yaml --imu-out tiny/i.nc --reference-out tiny/r.nc
    has err "No space left"
    [ -z "$(ls tiny)" ] || complain "left behind: $(ls tiny)"
    umount tiny
fi

# Read by another program. (17 digits of a double are the double.)
if command -v ncdump >/dev/null 2>&1; then
    expect 0 ncdump -h i.nc
    has out "time_s = 1200 ;"
    has out 'dv_z_mps:units = "m s-1" ;'
    has out ":command = \"schuler truth mission.yaml --imu-out i.nc --reference-out r.nc --reference-every \\'10 s\\' --set \\'imu.rate=10 Hz\\'\" ;"
    has out ":seed = 7ULL ;"
    has out 'scenario: Two minutes at rest\nseed: 7'
    for pair in i:dv_z_mps:7 r:heading_deg:10 r:time_s:1; do
        file=${pair%%:*}
        column=${pair##*:}
        name=${pair#*:}
        name=${name%:*}
        ncdump -v "$name" -p 9,17 $file.nc | sed -n "/^data:/,\$p" | tr -d ' \n' | sed "s/^.*$name=//; s/;.*//" | tr , '\n' >got
        echo >>got
        tail -n +2 $file.csv | cut -d, -f"$column" >wanted
        paste -d' ' got wanted | awk '$1 != $2 { bad++ } END { exit bad > 0 || NR < 13 }' || complain "$name of $file.nc: $(paste got wanted | head -n 3)"
    done
fi
finish
