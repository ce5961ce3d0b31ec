# SPDX-License-Identifier: MIT
# The page in a browser: its numbers are those of result.json, and unticking a source takes its variance out.
. "$COMMAND_TESTS/lib.sh"
for browser in chromium chromium-browser google-chrome none; do
    command -v $browser >/dev/null && break
done
[ "$browser" != none ] || { echo "no chromium"; exit 77; }

# dom FILE[#...] [WIDTH]: what the page has become in ./dom, what its script complained of in ./err
dom() {
    timeout 120 $browser --headless --no-sandbox --disable-gpu --disable-background-networking --user-data-dir="$work/profile" \
        --window-size="${2-1200}",2000 --enable-logging=stderr --virtual-time-budget=5000 --dump-dom "file://$work/$1" >dom 2>err ||
        { echo "the browser does not run here: $(tail -n 3 err)"; exit 77; }
    has dom 'data-ready="yes"'
    lacks err CONSOLE
}
# value ID: the number that the element holds
value() { grep -o "id=\"$1\" data-[a-z]*=\"[^\"]*" dom | sed 's/.*"//'; }
# close A B TOLERANCE: relative; of nothing, no
close() { awk -v a="$1" -v b="$2" -v t="$3" 'BEGIN { d = a - b; exit !(a != "" && b != "" && (d < 0 ? -d : d) <= t * (b < 0 ? -b : b)) }' || complain "$1 is not $2"; }

small_scenario | sed 's|^scenario:.*|scenario: "<b>Two</b> minutes \&amp; at rest"|' >mission.yaml
echo 'requirement: {drift: 1000 nmi/h, statistic: CEP}' >>mission.yaml
expect 0 "$SCHULER" run mission.yaml --runs 80 -o result
expect 0 "$SCHULER" report result
r=result/result.json
at_end() { json $r "$@" horizontal_rms_m at_end; }

dom result.html
has dom '<h1>&lt;b&gt;Two&lt;/b&gt; minutes &amp;amp; at rest</h1>'
has dom 'Meets the requirement (PASS)'
has dom 'limit 1000 nmi/h CEP; 95 % limits'
close "$(value total)" "$(at_end rss)" 1e-6
close "$(value joint)" "$(at_end all)" 1e-12
has dom '>All sources are ticked'
n=$(json $r budget) i=0
while [ "$i" -lt "$n" ]; do
    id=$(json $r budget $i source)
    row=$(grep -o "<tr data-source=\"$id\".*" dom | sed 's,</tr>.*,,')
    close "$(echo "$row" | grep -o 'data-m="[^"]*' | sed 's/.*"//')" "$(at_end budget $i)" 1e-12
    close "$(echo "$row" | grep -o 'data-share="[^"]*' | sed 's/.*"//')" "$(json $r budget $i share)" 1e-6
    [ "$id" != gyro.bias ] || gyro=$(at_end budget $i)
    [ "$id" != accel.bias ] || accel=$(at_end budget $i)
    i=$((i + 1))
done
[ "$(grep -o '<canvas[^>]*aria-label="[^"]*[0-9]' dom | wc -l)" -eq 3 ] || complain "charts without a description in words"
close "$(grep -o 'data-scales="[^"]*' dom | sed 's/.*"//')" 1 0.01
dom result.html 500
close "$(grep -o 'data-scales="[^"]*' dom | sed 's/.*"//')" 1 0.01

# The ticks are in the address; without a source the sum of squares is without its square.
dom 'result.html#without=accel.bias'
close "$(value total)" "$(awk -v t="$(at_end rss)" -v a="$accel" 'BEGIN { printf "%.17g", sqrt(t * t - a * a) }')" 1e-6
lacks dom '>All sources are ticked'
has dom '>Without accel.bias:'
grep -o '<tr data-source="accel.bias".*' dom | sed 's,</tr>.*,,' >row
has row 'data-share="0"'
has row 'class="off"'
dom 'result.html#without=accel.bias,gyro.bias,accel.velocity_random_walk,gyro.angle_random_walk,numerical'
[ "$(value total)" = 0 ] || complain "the total of nothing is $(value total)"
dom 'result.html#without=%'
close "$(value total)" "$(at_end rss)" 1e-6

# A click does the same as the address: the box of the gyro's bias, and back.
sed 's,^</body>,<script>const box = document.querySelector("input[data-source=\\"gyro.bias\\"]"); box.click();</script>&,' result.html >clicked.html
dom clicked.html
close "$(value total)" "$(awk -v t="$(at_end rss)" -v g="$gyro" 'BEGIN { printf "%.17g", sqrt(t * t - g * g) }')" 1e-6
sed 's,box.click();,&box.click();,' clicked.html >twice.html
dom twice.html
close "$(value total)" "$(at_end rss)" 1e-6

# Dragging over the middle half of one chart of time shows 30 s to 90 s in the other, too.
cat >drag.js <<'JS'
<script>
const canvas = document.getElementById("position-chart"), area = Chart.getChart(canvas).chartArea;
const event = (type, part) => new PointerEvent(type, { bubbles: true, pointerType: "mouse", button: 0,
  clientX: canvas.getBoundingClientRect().left + area.left + part * (area.right - area.left) });
canvas.dispatchEvent(event("pointerdown", 0.25));
canvas.dispatchEvent(event("pointerup", 0.75));
const { min, max } = Chart.getChart("sources-chart").scales.x;
document.body.append(Object.assign(document.createElement("p"), { textContent: `from ${Math.round(min)} to ${Math.round(max)} s` }));
</script>
JS
{ sed '/^<\/body>/,$d' result.html && cat drag.js && echo '</body></html>'; } >dragged.html
dom dragged.html
has dom '>from 30 to 90 s<'

# One draw of nothing: flat zero curves, and a logarithmic axis without anything on it.
sed "/^requirement/d" mission.yaml >bare.yaml
expect 0 "$SCHULER" run bare.yaml --without accel,gyro,numerical -o bare
expect 0 "$SCHULER" report bare
dom bare.html
has dom '>No error source is switched on'
finish
