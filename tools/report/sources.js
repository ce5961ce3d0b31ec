/* SPDX-License-Identifier: MIT */
/* Which sources are ticked, and what follows from it: variances add. */
let lane = 0; /* the numerical residue is not a lane of its own: it is that without any error */
const sources = result.budget.map((row) => ({ row, id: row.source, curve: row.source === "numerical" ? curves.none : curves.sources[lane++], on: true }));
for (const s of sources) s.curve[LAST] = s.row.horizontal_rms_m.at_end;
sources.sort((a, b) => b.curve[LAST] - a.curve[LAST]);
const state = { at: LAST };
const total = (k) => Math.sqrt(sources.reduce((sum, s) => s.on ? sum + s.curve[k] * s.curve[k] : sum, 0));
const share = (s, k) => s.on && total(k) > 0 ? (s.curve[k] / total(k)) ** 2 : 0;
const totalCurve = () => curves.times_s.map((_, k) => total(k));

const views = []; /* functions that show the state */
const showAll = () => views.forEach((show) => show());

/* #without=gyro.bias,accel.bias: the ticks are part of the address. */
function readAddress() {
  const found = /^#without=(.*)$/.exec(location.hash);
  let off = [];
  try { if (found) off = decodeURIComponent(found[1]).split(","); } catch (e) { /* not an address of ours */ }
  for (const s of sources) s.on = !off.includes(s.id);
}
function writeAddress() {
  const off = sources.filter((s) => !s.on).map((s) => encodeURIComponent(s.id));
  try { history.replaceState(null, "", off.length ? "#without=" + off.join(",") : location.pathname + location.search); } catch (e) { /* not everywhere allowed */ }
}
function tick(which, on) {
  for (const s of which) s.on = on;
  writeAddress();
  showAll();
}
