# SPDX-License-Identifier: MIT
# A result in the formats of other programs.
. "$COMMAND_TESTS/lib.sh"
small_scenario >mission.yaml
expect 0 "$SCHULER" run mission.yaml -q -o result

# The runs: their ends are those of errors.csv, the drift is the slope through the origin of the reports.
expect 0 "$SCHULER" export result --csv runs.csv
empty out
empty err
head -n 1 runs.csv >header
echo "source,run,end_m,max_m,drift_nmi_per_h,velocity_rms_mps" >wanted
same header wanted
[ "$(wc -l <runs.csv)" -eq $((1 + 7 * 12)) ] || complain "$(wc -l <runs.csv) lines"
awk -F, '
    NR == FNR { if ($1 == "all") { end[$2] = $3; max[$2] = $4; drift[$2] = $5; v[$2] = $6 } next }
    $1 == "all" && $3 > 0 {
        r = sqrt($4 * $4 + $5 * $5); last[$2] = r; if (r > big[$2]) big[$2] = r
        tr[$2] += $3 * r; tt[$2] += $3 * $3; vv[$2] += $7 * $7 + $8 * $8; n[$2]++ }
    function off(a, b) { d = a - b; return (d < 0 ? -d : d) > 1e-12 * b }
    END {
        for (k in last) {
            runs++
            if (off(end[k], last[k]) || off(max[k], big[k]) || off(v[k], sqrt(vv[k] / n[k]))) { print k; bad++ }
            if (off(drift[k], tr[k] / tt[k] * 3600 / 1852)) { print k, drift[k]; bad++ }
        }
        exit bad > 0 || runs != 12 }' runs.csv result/errors.csv || complain "runs are not those of errors.csv"
expect 0 "$SCHULER" export result/result.nc --csv -
same out runs.csv

# points FILE: the positions of a KML file, one a line, a blank line after each shape
points() { awk '/<coordinates>/ { on = 1; next } /<\/coordinates>/ { on = 0; print ""; next } on' "$1"; }
well_formed() {
    if command -v xmllint >/dev/null 2>&1; then xmllint --noout "$1" || complain "$1 is not well-formed"; fi
}

# The track of a flight across the dateline, under a name that XML must not see as it is. The path is the one
# that was flown, with the switches of the run.
cat >flight.yaml <<'YAML'
scenario: 'East & <far> "out" Å'
runs: 12
trajectory:
  kind: segments
  start: {lat: 60 deg, lon: 179.825 deg, height: 1000 m, heading: 90 deg, speed: 100 m/s}
  segments:
    - hold: {for: 100 s}
imu:
  rate: 100 Hz
  accel: {model: linear, bias: {normal: 5 mg}}
  gyro: {model: linear}
YAML
expect 0 "$SCHULER" run flight.yaml -q -o flown --set 'trajectory.start.height=2000 m'
expect 0 "$SCHULER" export flown --kml track.kml --csv runs.csv
[ -s runs.csv ] || complain "no runs.csv beside the track"
no_partial
well_formed track.kml
has track.kml '<name>East &amp; &lt;far&gt; &quot;out&quot; Å</name>'
points track.kml >points
# 100 s at 100 m/s from 179.825 E: 10 km are 0.179 degrees at 60 N, so the end is at 179.996 W.
awk -F, '
    BEGIN { shape = 0 }
    !NF { shape++; next }
    { n[shape]++; lon[shape] = $1
      if ($1 > 180 || $1 < -180) bad = "longitude " $1
      if (n[shape] > 1 && ($1 - before > 1 || before - $1 > 1)) bad = "a jump to " $1
      before = $1
      if (shape < 2) { if ($3 != "2000.000" && ($3 < 1999.9 || $3 > 2009)) bad = "height " $3; sum += n[shape] > 0 } }
    NR == 1 && ($1 != 179.825 || $2 != 60) { bad = "start " $0 }
    END {
        if (lon[0] != 180) bad = "the first piece ends at " lon[0]
        if (lon[1] > -179.995 || lon[1] < -179.997) bad = "the track ends at " lon[1]
        if (sum > 2002 || sum < 1900) bad = sum " points"
        if (bad) print bad
        exit bad != "" }' points >out || complain "track: $(cat out)"
# Circles of hundreds of metres, cut where they cross: about the end, 95 % and 50 %.
awk -F, 'NR > 1 && $1 == "all" { print $3 }' runs.csv | sort -g >ends
awk '{ e[NR] = $1 } END { printf "%.6g\n%.6g\n", e[11] + 0.45 * (e[12] - e[11]), (e[6] + e[7]) / 2 }' ends >radii
grep -o 'end within [0-9.]* m' track.kml | grep -o '[0-9.]*' | grep . >got
same got radii
awk -F'[<>]' '/of 12 navigators/ { split($0, w, "within "); r = w[2] + 0 }
    /<LinearRing>/ { on = 1; first = ""; next }
    /<\/LinearRing>/ { on = 0; if (last != first) { print "not closed"; bad++ } next }
    /<Polygon>/ { on = 1; next }
    on { last = $0; if (first == "") first = $0
         split($0, p, ","); lon = p[1] < 0 ? p[1] + 360 : p[1]
         if (p[3] != "0.000") { print "height " p[3]; bad++ }
         e = (lon - 180.0042) * 55800; n = (p[2] - 60) * 111412; d = sqrt(e * e + n * n) / r
         if (p[1] == 180 || p[1] == -180) edge++
         else { vertices++; if (d < 0.99 || d > 1.01) { print r, $0, d; bad++ } } }
    END { if (vertices < 144 || edge < 8) { print vertices, edge; bad++ } exit bad > 0 }' track.kml >out ||
    complain "circles: $(head -n 3 out)"

# At rest the track is two points; without any error there is no circle, and that is said.
expect 0 "$SCHULER" run mission.yaml -q --only numerical -o perfect
expect 0 "$SCHULER" export perfect --kml -
mv out rest.kml
well_formed rest.kml
[ "$(points rest.kml | grep -c ,)" -eq 4 ] || complain "points at rest: $(points rest.kml)"
has rest.kml "not drawn"
lacks rest.kml "<Polygon>"

# Bad input: said, and nothing written. What was there stays.
echo precious >kept.csv
refuse() { # refuse TEXT RESULT
    expect 2 "$SCHULER" export "$2" --csv kept.csv --kml none.kml
    has err "$1"
    empty out
    absent none.kml
    [ "$(cat kept.csv)" = precious ] || complain "kept.csv was replaced by $2"
    no_partial
}
refuse "nowhere: error: cannot be read" nowhere
mkdir bare
refuse "bare/result.nc: error: cannot be read" bare
refuse "error: cannot be read" result/budget.csv
head -c 9000 result/result.nc >torn.nc
refuse "torn.nc: error: " torn.nc
expect 0 "$SCHULER" truth mission.yaml --reference-out truth.nc --reference-every '10 s'
refuse "this is no result of schuler run" truth.nc
expect 2 "$SCHULER" export result
has err "nothing to write"
expect 2 "$SCHULER" export --csv x.csv
expect 2 "$SCHULER" export result result --csv x.csv
expect 2 "$SCHULER" export result --csv same --kml same
expect 2 "$SCHULER" export result --csv ''
cp result/result.nc untouched.nc
ln -s result/result.nc link
expect 2 "$SCHULER" export result --csv link
has err "would be replaced"
expect 2 "$SCHULER" export result/result.nc --kml result/result.nc
same result/result.nc untouched.nc
absent same
expect 3 "$SCHULER" export result --csv x.csv --kml no/such.kml
absent x.csv
expect 3 "$SCHULER" export result --csv no/such.csv --kml x.kml
absent x.kml
no_partial
mkdir none
echo nothing >none/libnetcdf.so.19
expect 3 env LD_LIBRARY_PATH="$work/none" "$SCHULER" export result --csv x.csv
has err "NetCDF files need the library"
absent x.csv
if [ -c /dev/full ]; then
    "$SCHULER" export result --csv - >/dev/full 2>err
    [ $? -eq 3 ] || complain "full standard output"
fi
finish
