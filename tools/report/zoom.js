/* SPDX-License-Identifier: MIT */
/* Dragging over a chart of time shows that stretch in all of them; a double click shows everything. */
const timeCharts = ["position-chart", "sources-chart"];
const stretch = { from: 0, to: curves.times_s[LAST] / TIME.s };
function showStretch(from, to) {
  Object.assign(stretch, { from, to });
  for (const id of timeCharts) {
    Object.assign(live.get(id).options.scales.x, { min: from, max: to });
    live.get(id).update("none");
  }
}
function makeZoom(id) {
  const canvas = byId(id), shade = make("div", { class: "shade" });
  let start = null;
  const inside = (event) => {
    const { left, right } = live.get(id).chartArea;
    return Math.min(right, Math.max(left, event.clientX - canvas.getBoundingClientRect().left));
  };
  const cover = (a, b) => Object.assign(shade.style, { left: Math.min(a, b) + "px", width: Math.abs(b - a) + "px" });
  canvas.after(shade);
  canvas.addEventListener("pointerdown", (event) => { if (event.pointerType === "mouse" && event.button === 0) start = inside(event); });
  addEventListener("pointermove", (event) => { if (start !== null) cover(start, inside(event)); });
  addEventListener("pointerup", (event) => {
    if (start === null) return;
    const scale = live.get(id).scales.x, ends = [start, inside(event)].map((x) => scale.getValueForPixel(x)).sort((a, b) => a - b);
    if (Math.abs(inside(event) - start) > 8) showStretch(...ends);
    start = null;
    cover(0, 0);
  });
  canvas.addEventListener("dblclick", () => showStretch(0, curves.times_s[LAST] / TIME.s));
}
