/* SPDX-License-Identifier: MIT */
/* The budget as a table: a tick box and a bar for each source; it is the legend of the curves too. */
function cell(text, attributes) { return make("td", attributes || {}, text); }
function sourceRow(s, index) {
  const box = make("input", { type: "checkbox", id: "tick-" + index, "data-source": s.id });
  box.addEventListener("change", () => tick([s], box.checked));
  const linear = s.row.covariance_rms_m;
  s.box = box;
  s.mark = make("span", { class: "swatch", "aria-hidden": "true" });
  s.rms = cell("");
  s.bar = make("span", { class: "bar" });
  s.figure = make("span", { class: "figure" });
  s.line = make("tr", { "data-source": s.id },
    make("th", { scope: "row" }, make("label", { for: "tick-" + index }, box, s.mark, make("span", {}, ...breakable(s.id), s.row.assumed ? " *" : ""))),
    s.rms, make("td", { class: "share" }, s.bar, s.figure), cell(typeof s.row.value === "string" ? s.row.value : "", { class: "text" }), cell(digits(s.row.drift_cep_nmi_per_h, 3)),
    cell(linear ? length(linear.at_end) : NONE), cell(length(s.row.horizontal_rms_m.max)));
  return s.line;
}
function footRow(name, id, rms, more) {
  return make("tr", {}, make("th", { scope: "row" }, name), cell(isNumber(rms) ? length(rms) : "", { id }), cell(""), cell(""), ...more.map((text) => cell(text)));
}
function makeBudget() {
  const unit = ", " + LENGTH.name, { all, none, covariance } = result;
  const columns = ["source", "rms" + unit, "share", "value", "drift CEP, nmi/h", "rms at the end by covariance" + unit, "largest rms" + unit];
  byId("budget-table").append(
    make("caption", { class: "note" }, "Horizontal position error of each source alone"),
    make("thead", {}, make("tr", {}, ...columns.map((name) => make("th", { scope: "col", class: name === "value" ? "text" : "" }, name)))),
    make("tbody", {}, ...sources.map(sourceRow)),
    make("tfoot", {}, footRow("total of the ticked, root sum square", "total", NaN, ["", "", ""]),
      footRow("all sources at once, simulated", "joint", NaN, [digits(all.drift_cep_nmi_per_h, 3),
        covariance && !(covariance.not_covered || []).length ? length(covariance.horizontal_rms_m.at_end) : NONE, length(all.horizontal_rms_m.max)]),
      ...(sources.some((s) => s.id === "numerical") ? []
        : [footRow("no error at all, numerical residue", "residue", none.horizontal_rms_m.at_end, ["", "", length(none.horizontal_rms_m.max)])])));
  if (!sources.length) byId("budget-note").append("No error source is switched on.");
  if (sources.some((s) => s.row.assumed)) byId("budget-note").append("* assumed: not a published figure, or not as one. ");
  for (const item of covariance ? covariance.differs || [] : [])
    byId("budget-note").append(`${item.source}: simulation and covariance differ by ${percent(item.relative)}, so it is not linear. `);
  for (const item of covariance ? covariance.not_covered || [] : [])
    byId("budget-note").append(`${item.source} is not in the covariance: ${item.because}. `);
  if (!sources.length) byId("sources").hidden = true;
  byId("at").max = LAST;
  byId("at").addEventListener("input", () => { state.at = Number(byId("at").value); showAll(); });
  byId("tick-all").addEventListener("click", () => tick(sources, true));
  byId("tick-none").addEventListener("click", () => tick(sources, false));
}
/* What unticking did, in words; the verdict above is of the mission as it was flown. */
function showWhatIf() {
  const off = sources.filter((s) => !s.on), k = state.at;
  const whole = Math.sqrt(sources.reduce((sum, s) => sum + s.curve[k] * s.curve[k], 0));
  byId("what-if").textContent = !off.length ? "All sources are ticked."
    : `Without ${off.length > 3 ? off.length + " sources" : off.map((s) => s.id).join(", ")}: ${lengthText(total(k))} instead of ${lengthText(whole)} rms` +
      (whole > 0 ? `, ${digits(100 * total(k) / whole, 3)} %. ` : ". ") + "The verdict and the band of the runs are those of all sources.";
}
function showBudget() {
  const k = state.at, time = clock(curves.times_s[k]) + (k === LAST ? ", the end" : "");
  byId("at").value = k;
  byId("at").setAttribute("aria-valuetext", time);
  byId("at-text").value = time;
  sources.forEach((s, i) => {
    const part = share(s, k), line = lineOf(i);
    s.box.checked = s.on;
    s.line.className = s.on ? "" : "off";
    s.mark.replaceWith(s.mark = swatch(line));
    s.rms.textContent = length(s.curve[k]);
    s.rms.dataset.m = s.curve[k];
    s.figure.textContent = s.on ? percent(part) : NONE;
    s.figure.dataset.share = part;
    s.bar.style.width = 100 * part + "%";
  });
  byId("total").textContent = length(total(k));
  byId("total").dataset.m = total(k);
  showWhatIf();
  byId("joint").textContent = length(curves.all[k]);
  byId("joint").dataset.m = k === LAST ? result.all.horizontal_rms_m.at_end : curves.all[k];
}
