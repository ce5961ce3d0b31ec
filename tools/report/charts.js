/* SPDX-License-Identifier: MIT */
/* Charts in the colours of the page, redrawn when those change. */
const dark = matchMedia("screen and (prefers-color-scheme: dark)"); /* paper is white */
const colour = (name) => getComputedStyle(document.documentElement).getPropertyValue("--" + name).trim();
/* Ten hues that stay apart on white and on black, then again with dashes. */
const HUES = [[211, 80], [25, 90], [140, 60], [350, 75], [270, 55], [185, 75], [50, 90], [315, 60], [95, 60], [0, 0]];
const DASHES = [[], [7, 4], [2, 3], [10, 3, 2, 3]];
function lineOf(index) {
  const [hue, saturation] = HUES[index % HUES.length];
  const lightness = dark.matches ? 65 : hue === 50 ? 36 : 42;
  return { colour: `hsl(${hue} ${saturation}% ${lightness}%)`, dash: DASHES[Math.floor(index / HUES.length) % DASHES.length] };
}
function swatch(line) {
  const mark = make("span", { class: "swatch", "aria-hidden": "true" });
  mark.style.borderTopColor = line.colour;
  if (line.dash.length) mark.style.borderTopStyle = line.dash[0] > 5 ? "dashed" : "dotted";
  return mark;
}
const points = (values) => values.map((m, k) => ({ x: curves.times_s[k] / TIME.s, y: m / LENGTH.m }));

function axis(title, more) {
  return Object.assign({ title: { display: true, text: title, color: colour("soft") },
    ticks: { color: colour("soft"), maxRotation: 0 }, grid: { color: colour("line"), drawBorder: false } }, more);
}
function timeAxis() {
  return axis("time, " + TIME.name, { type: "linear", min: stretch.from, max: stretch.to, ticks: { color: colour("soft"), maxRotation: 0, callback: (x) => plain(Number(x.toPrecision(4))) } });
}
function chartOptions(scales, more) {
  return Object.assign({ animation: false, responsive: true, maintainAspectRatio: false, parsing: false, normalized: true,
    interaction: { mode: "index", intersect: false, axis: "x" },
    elements: { point: { radius: 0, hitRadius: 4 }, line: { borderWidth: 2, tension: 0 } }, scales,
    plugins: { legend: { display: false }, tooltip: { itemSort: (a, b) => b.parsed.y - a.parsed.y, callbacks: {
      title: (items) => items.length ? clock(items[0].parsed.x * TIME.s) : "",
      label: (item) => item.dataset.label + " " + digits(item.parsed.y) + " " + LENGTH.name } } } }, more);
}

const drawn = new Map(); /* id of a canvas: how to make its chart */
const live = new Map();
function drawChart(id, make) {
  drawn.set(id, make);
  if (live.has(id)) live.get(id).destroy();
  live.set(id, new Chart(byId(id), make()));
}
dark.addEventListener("change", () => { showAll(); for (const [id, make] of drawn) drawChart(id, make); });
