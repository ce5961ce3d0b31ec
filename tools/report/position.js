/* SPDX-License-Identifier: MIT */
/* Position error over time: all sources at once, and each of them. */
function limitCurve() {
  const r = result.requirement;
  return r ? curves.times_s.map((s) => r.limit_nmi_per_h * NMI_M * s / 3600) : null;
}
function positionLines() {
  const limit = limitCurve(), accent = colour("accent"), lines = [
    { label: "95 % of the runs", data: points(curves.high), borderColor: accent, borderWidth: 1 },
    { label: "5 % of the runs", data: points(curves.low), borderColor: accent, borderWidth: 1, backgroundColor: colour("band"), fill: "-1" },
    { label: "median of the runs", data: points(curves.median), borderColor: accent },
    { label: "rms of the ticked sources", data: points(totalCurve()), borderColor: colour("ink"), borderDash: [6, 4] }];
  if (limit) lines.push({ label: "limit", data: points(limit), borderColor: colour("limit"), borderWidth: 1.5 });
  return lines;
}
/* The axis belongs to the error: a limit far above it leaves the chart. */
function positionTop() {
  const most = Math.max(...curves.high, ...curves.all, ...totalCurve()), limit = limitCurve();
  return limit && limit[LAST] > 2.5 * most ? { max: Number((2 * most / LENGTH.m).toPrecision(2)) } : {};
}
function positionChart() {
  return { type: "line", data: { datasets: positionLines() },
    options: chartOptions({ x: timeAxis(), y: axis("horizontal error, " + LENGTH.name, Object.assign({ type: "linear", min: 0 }, positionTop())) }) };
}
function legendItem(mark, text) { return make("span", {}, mark, text); }
function showPosition() {
  const r = result.requirement, line = (name, dash) => swatch({ colour: colour(name), dash: dash || [] }), chart = live.get("position-chart");
  byId("position-legend").replaceChildren(
    legendItem(make("span", { class: "swatch area", "aria-hidden": "true" }), `5 to 95 % of ${many(curves.joint_runs, "run")}`),
    legendItem(line("accent"), "median"), legendItem(line("ink", [6, 4]), "ticked sources, root sum square of rms"),
    ...(r ? [legendItem(line("limit"), `limit ${plain(r.limit_nmi_per_h)} nmi/h, to be held by ${r.statistic}`)] : []));
  byId("position-table").replaceChildren(timeTable("Horizontal position error", [
    { name: "5 %", values: curves.low }, { name: "median", values: curves.median }, { name: "95 %", values: curves.high }, { name: "rms of the runs", values: curves.all },
    { name: "ticked sources, rms", values: totalCurve() }, ...(r ? [{ name: "limit", values: limitCurve() }] : [])]));
  byId("position-chart").setAttribute("aria-label", `Horizontal position error over time. At the end the median of the runs is ${lengthText(curves.median[LAST])}, ` +
    `90 % of them are between ${lengthText(curves.low[LAST])} and ${lengthText(curves.high[LAST])}.`);
  if (!chart) return drawChart("position-chart", positionChart);
  chart.data.datasets[3].data = points(totalCurve());
  chart.update("none");
}

function sourcesChart() {
  const above = (m) => m > 0 ? m : NaN; /* a logarithm has no zero */
  const lines = sources.map((s, i) => ({ label: s.id, data: points(s.curve.map(above)), borderColor: lineOf(i).colour, borderDash: lineOf(i).dash, hidden: !s.on }));
  lines.push({ label: "total of the ticked", data: points(totalCurve().map(above)), borderColor: colour("ink"), borderDash: [6, 4], borderWidth: 1.5 });
  const most = Math.max(...curves.all, ...totalCurve()) / LENGTH.m;
  return { type: "line", data: { datasets: lines }, options: chartOptions({ x: timeAxis(), y: axis("horizontal rms, " + LENGTH.name, { type: "logarithmic",
    min: most > 0 ? 10 ** Math.floor(Math.log10(most) - 4.5) : undefined,
    ticks: { color: colour("soft"), callback: (y) => Math.abs(Math.log10(y) % 1) < 1e-9 || Math.abs(Math.log10(y) % 1) > 1 - 1e-9 ? plain(y) : "" } }) }) };
}
function showSources() {
  const chart = live.get("sources-chart"), ticked = sources.filter((s) => s.on);
  byId("sources-legend").replaceChildren(...sources.flatMap((s, i) => s.on ? [legendItem(swatch(lineOf(i)), s.id)] : []),
    legendItem(swatch({ colour: colour("ink"), dash: [6, 4] }), "total of the ticked"));
  byId("sources-chart").setAttribute("aria-label", "Horizontal rms error of each source over time, logarithmic. Largest at the end: " +
    (ticked.length ? ticked.slice(0, 3).map((s) => s.id + " " + lengthText(s.curve[LAST])).join(", ") : "none") + ".");
  if (!chart) {
    byId("sources-table").replaceChildren(timeTable("Horizontal rms error of each source", sources.map((s) => ({ name: s.id, values: s.curve }))));
    return drawChart("sources-chart", sourcesChart);
  }
  sources.forEach((s, i) => { chart.data.datasets[i].hidden = !s.on; });
  chart.data.datasets[sources.length].data = points(totalCurve().map((m) => m > 0 ? m : NaN));
  chart.update("none");
}
