/* SPDX-License-Identifier: MIT */
/* End points of the joint runs on a map of equal scale, with the circles that hold half and 95 % of them. */
function circle(radius_m) {
  return Array.from({ length: 121 }, (_, i) => ({ x: radius_m * Math.sin(i * Math.PI / 60) / LENGTH.m, y: radius_m * Math.cos(i * Math.PI / 60) / LENGTH.m }));
}
/* A metre is as long on both axes: the shorter side shows all points, the longer one more. */
const equalScale = { id: "equal", afterLayout(chart) {
  const { width, height } = chart.chartArea, reach = chart.options.reach;
  const x = reach * Math.max(1, width / height), y = reach * Math.max(1, height / width);
  const { x: ax, y: ay } = chart.options.scales;
  if (Math.abs(ax.max / x - 1) < 1e-3 && Math.abs(ay.max / y - 1) < 1e-3 || chart.rounds > 4) { chart.rounds = 0; return; }
  chart.rounds = (chart.rounds || 0) + 1;
  Object.assign(ax, { min: -x, max: x });
  Object.assign(ay, { min: -y, max: y });
  chart.update("none");
}, afterRender(chart) {
  const { x, y } = chart.scales; /* pixels per metre east over those north */
  chart.canvas.dataset.scales = (x.getPixelForValue(1) - x.getPixelForValue(0)) / (y.getPixelForValue(0) - y.getPixelForValue(1));
} };
function endsChart() {
  const most = Math.max(curves.r95, ...curves.north.map(Math.abs), ...curves.east.map(Math.abs)) / LENGTH.m;
  const reach = 1.05 * (most > 0 ? most : 1);
  const ring = (label, radius, width) => ({ label, data: circle(radius), showLine: true, borderColor: colour("ink"), borderWidth: width, borderDash: width > 1 ? [] : [6, 4], pointRadius: 0, pointHitRadius: 0 });
  return { type: "scatter", plugins: [equalScale], data: { datasets: [
    { label: "end of a run", data: curves.east.map((e, i) => ({ x: e / LENGTH.m, y: curves.north[i] / LENGTH.m })), backgroundColor: colour("accent"), pointRadius: curves.east.length > 400 ? 1.5 : 3 },
    ring("50 %", curves.r50, 2), ring("95 %", curves.r95, 1)] },
    options: chartOptions({ x: axis("east, " + LENGTH.name, { type: "linear", min: -reach, max: reach, ticks: { color: colour("soft"), callback: inner } }),
      y: axis("north, " + LENGTH.name, { type: "linear", min: -reach, max: reach, ticks: { color: colour("soft"), callback: inner } }) },
    { reach, interaction: { mode: "nearest", intersect: true }, plugins: { legend: { display: false }, tooltip: { callbacks: {
      label: (item) => `north ${digits(item.parsed.y)}, east ${digits(item.parsed.x)} ${LENGTH.name}` } } } }) };
}
/* The ends of the axes are no round numbers: not written. */
function inner(value) { return Math.abs(value) > 0.999 * this.max ? "" : plain(value); }
function showEnds() {
  const shown = curves.east.length, mean = (x) => x.reduce((sum, v) => sum + v, 0) / x.length;
  byId("ends-legend").replaceChildren(
    legendItem(make("span", { class: "swatch dot", "aria-hidden": "true" }), shown < curves.joint_runs ? `${shown} of ${curves.joint_runs} runs` : many(shown, "run")),
    legendItem(swatch({ colour: colour("ink"), dash: [] }), "half of the runs: " + lengthText(curves.r50)),
    legendItem(swatch({ colour: colour("ink"), dash: [6, 4] }), "95 %: " + lengthText(curves.r95)));
  byId("ends-chart").setAttribute("aria-label", `End points of the runs, north against east of the true position. Half of them are within ${lengthText(curves.r50)}, 95 % within ${lengthText(curves.r95)}.`);
  const row = (name, m) => make("tr", {}, make("th", { scope: "row" }, name), cell(length(m)));
  byId("ends-table").replaceChildren(make("table", {}, make("caption", { class: "note" }, "End points about the true position, " + LENGTH.name), make("tbody", {},
    row("radius that holds 50 %", curves.r50), row("radius that holds 95 %", curves.r95), row("mean north", mean(curves.north)), row("mean east", mean(curves.east)),
    row("most northern", Math.max(...curves.north)), row("most southern", Math.min(...curves.north)), row("most eastern", Math.max(...curves.east)), row("most western", Math.min(...curves.east)))));
  if (!live.has("ends-chart")) drawChart("ends-chart", endsChart);
}
