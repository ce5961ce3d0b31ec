# SPDX-License-Identifier: MIT
# The page of a result: whole, small, harmless; what is no result is refused.
. "$COMMAND_TESTS/lib.sh"
hostile='</script><script>alert(1)</script><!-- & "a" '"'b'"
small_scenario | sed "s|^scenario:.*|scenario: |" >mission.yaml
printf '%s' "$hostile" | sed "s/'/''/g; s/.*/scenario: '&'/" >name
{ cat name && echo && echo '# <img src=x onerror=alert(2)>' && sed 1d mission.yaml; } >hostile.yaml
expect 0 "$SCHULER" run hostile.yaml -o result
expect 0 "$SCHULER" report result
[ "$(cat out)" = "Report: result.html" ] || complain "says $(cat out)"
empty err
expect 0 "$SCHULER" report result/ -o page.html
same page.html result.html
expect 0 "$SCHULER" report result -o -
same out result.html
(cd result && expect 0 "$SCHULER" report . -o ../dot.html)
same dot.html result.html

# Texts of others stay texts.
has page.html '<h1>&lt;/script&gt;&lt;script&gt;alert(1)&lt;/script&gt;&lt;!-- &amp; &quot;a&quot; &#39;b&#39;</h1>'
has page.html '\u003c/script\u003e\u003cscript\u003ealert(1)'
has page.html '# &lt;img src=x onerror=alert(2)&gt;'
lacks page.html '<script>alert'
lacks page.html '<img'
[ "$(grep -c '<script' page.html)" -eq 4 ] || complain "script elements: $(grep -n '<script' page.html | cut -c1-60)"
has page.html "$(json result/result.json scenario sha256)"
has page.html '<dd id="seed">7</dd>'

# Nothing of it is elsewhere; the chart library has addresses in its comments, and the policy forbids it to use any.
has page.html "default-src 'none'"
awk '/^<script>$/ { scripts++ } scripts != 1' page.html >ours
[ -s ours ] || complain "nothing is ours"
grep -Ei 'https?:|//[a-z]+\.|src=|url\(|@import|fetch\(|XMLHttp|<link' ours | grep -vF -e 'href="data:,"' -e '# &lt;img src=x' >outside
empty outside

# However long and many: 3000 runs, 1201 times.
expect 0 "$SCHULER" run mission.yaml --set scenario=Long --set 'report.every=0.1 s' --only gyro.bias --runs 300 -o long
expect 0 "$SCHULER" report long
expect 0 "$SCHULER" run mission.yaml --set scenario=Many --set 'report.every=60 s' --only gyro.bias --runs 3000 -o many
expect 0 "$SCHULER" report many
for page in long many; do
    [ "$(wc -c <$page.html)" -lt 700000 ] || complain "$page.html has $(wc -c <$page.html) bytes"
    sed -n 's/.*id="curves">\(.*\)<\/script>$/\1/p' $page.html >$page.json
done
[ "$(json long.json times_s)" -eq 201 ] || complain "times: $(json long.json times_s)"
[ "$(json long.json times_s 200)" = 120 ] || complain "the end is $(json long.json times_s 200)"
[ "$(json long.json joint_runs)" -eq 300 ] || complain "joint runs"
[ "$(json many.json north)" -eq 1500 ] || complain "end points: $(json many.json north)"
[ "$(json many.json joint_runs)" -eq 3000 ] || complain "joint runs"

# A line separator ends a statement of a script; in the data it is written as an escape.
cp -R many separator
sed 's/"name": "Many"/"name": "a\\u2028b\\u2029"/' many/result.json >separator/result.json
expect 0 "$SCHULER" report separator
sed -n 's/.*id="result">\(.*\)<\/script>$/\1/p' separator.html >separator.json
has separator.json '"a\u2028b\u2029"'
[ "$(LC_ALL=C tr -d '\000-\177' <separator.json | wc -c)" -eq 0 ] || complain "not ASCII: $(cat separator.json)"

# Without any source there are two lanes, and nothing is drawn.
expect 0 "$SCHULER" run mission.yaml --set scenario=Bare --only numerical -o bare
expect 0 "$SCHULER" report bare

# What is no result: says so, writes nothing, leaves an earlier page alone.
refused() {
    echo earlier >bad.html
    expect 2 "$SCHULER" report bad
    has err "$1"
    empty out
    [ "$(cat bad.html)" = earlier ] || complain "$1: bad.html was touched"
    rm -rf bad
}
anew() { rm -rf bad && cp -R result bad; }
rm -rf bad
refused "bad: no such directory"
mkdir bad && refused "bad/result.json: No such file"
anew && rm bad/errors.csv && refused "bad/errors.csv: No such file"
anew && rm bad/scenario.yaml && refused "bad/scenario.yaml: No such file"
anew && head -c 300 result/result.json >bad/result.json && refused "bad/result.json:"
anew && echo '{"format": "schuler-compare-1"}' >bad/result.json && refused "the format is schuler-compare-1"
anew && sed 's/"runs": 12/"runs": "12"/' result/result.json >bad/result.json && refused "not a result: Expected integer"
anew && sed 's/"budget": \[/"budget": [7,/' result/result.json >bad/result.json && refused "not a result: Expected object"
anew && sed 's/sha256 [0-9a-f]*/sha256 0/' result/scenario.yaml >bad/scenario.yaml && refused "not the scenario of this"
anew && : >bad/errors.csv && refused "errors.csv"
anew && sed 1d result/errors.csv >bad/errors.csv && refused "errors.csv:1: not the head"
anew && head -c -20 result/errors.csv >bad/errors.csv && refused "cut off in the middle of a row"
anew && sed '$d' result/errors.csv >bad/errors.csv && refused "none, run 0 was expected; the file was cut off"
anew && grep -v '^none,' result/errors.csv >bad/errors.csv && refused "of none, run 0 was expected"
anew && grep -v '^all,7,' result/errors.csv >bad/errors.csv && refused "7 runs of all, and result.json has 12"
anew && sed 's/^gyro.bias,3,60,[^,]*/gyro.bias,3,60,many/' result/errors.csv >bad/errors.csv && refused "north_m is not a number"
anew && sed 's/^gyro.bias,3,60,/gyro.bias,3,61,/' result/errors.csv >bad/errors.csv && refused "time_s is not that"
anew && sed 's/^all,3,120,[^,]*/all,3,120,7/' result/errors.csv >bad/errors.csv && refused "not of the same result"
anew && echo 'more,0,0,0,0,0,0,0,0,0,0,0' >>bad/errors.csv && refused "a row that the budget"
expect 2 "$SCHULER" report
expect 2 "$SCHULER" report result long
expect 3 "$SCHULER" report result -o no/such/place.html
small_scenario >small.yaml
expect 0 "$SCHULER" run small.yaml --rows without -o but_one
expect 2 "$SCHULER" report but_one
has err "does not add up"
absent but_one.html
no_partial
finish
