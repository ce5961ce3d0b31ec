# SPDX-License-Identifier: MIT
# Colour and progress only on a terminal; plain ASCII where nothing else can be shown.
. "$COMMAND_TESTS/lib.sh"
small_scenario >mission.yaml
echo "requirement: {drift: 100 nmi/h, statistic: CEP}" >>mission.yaml
escape=$(printf '\033')
TERM=xterm
export TERM
expect 0 "$SCHULER" run mission.yaml
lacks out "$escape"
lacks err "$escape"
has out "█"
[ "$(wc -L <out)" -le 80 ] || complain "wider than 80 columns: $(wc -L <out)"
LC_ALL=C "$SCHULER" run mission.yaml >ascii 2>err
LC_ALL=C grep -q '[^ -~]' ascii && complain "not ASCII: $(LC_ALL=C grep '[^ -~]' ascii)"
has ascii "#"

# The rest needs a pseudo-terminal, which a bare container may not have.
script -qec true /dev/null >/dev/null 2>&1 </dev/null || { echo "no pseudo-terminal here: terminal output not tested"; finish; }
on_terminal() { script -qec "$*" /dev/null >out </dev/null; }
unset NO_COLOR
on_terminal "$SCHULER run mission.yaml --runs 200"
has out "$escape[1;32mPASS"
# Progress: truth shows it from its first step on; the line is erased at the end.
on_terminal "$SCHULER truth mission.yaml --imu-out imu.csv"
has out "  0 %$escape[K"
# ... and with --until what is known so far.
on_terminal "$SCHULER run mission.yaml --until 20%"
[ "$(tr '\r' '\n' <out | grep -o '0\.[0-9]* nmi/h CEP ± [0-9]* %' | sort -u | wc -l)" -gt 2 ] ||
    complain "no estimates: $(tr '\r' '\n' <out | head -n 9)"
NO_COLOR=1
export NO_COLOR
on_terminal "$SCHULER run mission.yaml --quiet"
lacks out "$escape[1"
on_terminal "$SCHULER truth mission.yaml --imu-out imu.csv --quiet"
lacks out "$escape"
finish
