/* SPDX-License-Identifier: MIT */
/* The verdict in words, and the key numbers. */
const rate = (x) => digits(x, 3) + " nmi/h";
function limitsText(r) {
  if (isNumber(r.lower) && r.lower === r.upper) return "nothing is drawn, every run is the same";
  if (!isNumber(r.upper) || !(r.lower > 0)) return "too few runs for " + digits(100 * r.confidence) + " % limits";
  return digits(100 * r.confidence) + " % limits " + digits(r.lower, 3) + " to " + rate(r.upper);
}
function showVerdict() {
  const r = result.requirement, box = byId("verdict");
  const words = { PASS: "Meets the requirement", FAIL: "Does not meet the requirement", INCONCLUSIVE: "Not decided: too few runs to tell" };
  if (!r) {
    box.append(make("strong", {}, "No requirement is stated"),
      make("p", {}, `Drift ${rate(result.all.drift_cep_nmi_per_h)} CEP, ${rate(result.all.drift_r95_nmi_per_h)} R95.`));
    return;
  }
  if (words[r.verdict]) box.className = r.verdict;
  const margin = 1 - r.value_nmi_per_h / r.limit_nmi_per_h;
  box.append(make("strong", {}, `${words[r.verdict] || r.verdict} (${r.verdict})`),
    make("p", {}, `Drift ${rate(r.value_nmi_per_h)} ${r.statistic}, limit ${rate(r.limit_nmi_per_h)} ${r.statistic}; ${limitsText(r)}; ` +
      (margin >= 0 ? `margin ${digits(100 * margin, 3)} %.` : `${digits(-100 * margin, 3)} % over the limit.`)));
}

function card(name, value, detail) {
  byId("numbers").append(make("div", {}, make("dt", {}, name), make("dd", { class: "value" }, value), make("dd", { class: "detail" }, detail)));
}
function showNumbers() {
  const { all, requirement: r, covariance } = result, most = sources[0];
  const limits = (name) => r && r.statistic === name ? limitsText(r) : "";
  card("Drift, CEP", rate(all.drift_cep_nmi_per_h), limits("CEP") || "median of the runs");
  card("Drift, R95", rate(all.drift_r95_nmi_per_h), limits("R95") || "95 % of the runs are below");
  const linear = covariance ? covariance.horizontal_rms_m.at_end : NaN;
  card("Position at the end, rms", lengthText(all.horizontal_rms_m.at_end), isNumber(linear)
    ? `all sources at once; linear covariance ${lengthText(linear)} (${linear >= all.horizontal_rms_m.at_end ? "+" : "\u2212"}${digits(Math.abs(100 * (linear / all.horizontal_rms_m.at_end - 1)), 2)} %)`
    : "all sources at once");
  if (most) card("Largest source", most.id, `${percent(share(most, LAST))} of the variance, alone ${rate(most.row.drift_cep_nmi_per_h)} CEP`);
  if (r) card("Margin", digits(100 * (1 - r.value_nmi_per_h / r.limit_nmi_per_h), 3) + " %", most && isNumber(most.row.margin)
    ? most.row.margin > 0 ? `the limit is reached with ${digits(most.row.margin, 3)} times ${most.id}` : `without ${most.id} it would still not be met`
    : "to the limit, " + r.statistic);
}
