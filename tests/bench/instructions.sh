# SPDX-License-Identifier: MIT
# Instructions of a lane-step, counted by callgrind: unlike time they repeat exactly, so they are the gate.
# LANE_STEPS is the program. The limits hold for gcc 12 with -O2; callgrind knows no AVX-512.
command -v valgrind >/dev/null 2>&1 || { echo "no valgrind here"; exit 77; }
work=$(mktemp -d) || exit 3
trap 'rm -rf "$work"' EXIT
failures=0
# ISA NORMALS FRAME LIMIT: the count when it was written, and 3 % for a compiler's mood.
while read -r isa normals frame limit; do
    steps=$("$LANE_STEPS" "$isa" "$normals" "$frame")
    status=$?
    [ $status = 77 ] && continue
    [ $status = 0 ] || { echo "lane_steps $isa $normals $frame: exit $status"; exit 3; }
    valgrind --tool=callgrind --callgrind-out-file="$work/out" --toggle-collect=counted \
        "$LANE_STEPS" "$isa" "$normals" "$frame" >/dev/null 2>"$work/err" || { cat "$work/err"; exit 3; }
    count=$(sed -n 's/^.*Collected : \([0-9]*\).*$/\1/p' "$work/err")
    each=$((count / steps))
    echo "$isa, $frame, $normals normals a step: $each instructions a lane-step (limit $limit)"
    [ "$each" -gt 0 ] && [ "$each" -le "$limit" ] || { echo "FAILED"; failures=1; }
done <<'LIMITS'
scalar 0 ecef 1024
sse2 0 ecef 517
avx2 0 ecef 209
avx2 6 ecef 328
avx2 18 ecef 612
avx2 0 wander 315
avx2 0 ned 317
LIMITS
exit $failures
