/* SPDX-License-Identifier: MIT */
/* The verdict in words, and the key numbers. */
const rate = (x) => digits(x, 3) + " nmi/h";
function limitsText(r) {
  if (isNumber(r.lower) && r.lower === r.upper) return "nothing is drawn, every run is the same";
  if (!isNumber(r.upper) || !(r.lower > 0)) return "too few runs for " + plain(100 * r.confidence) + " % limits";
  return plain(100 * r.confidence) + " % limits " + digits(r.lower, 3) + " to " + rate(r.upper);
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
    make("p", {}, `Drift ${rate(r.value_nmi_per_h)} ${r.statistic}, limit ${plain(r.limit_nmi_per_h)} nmi/h ${r.statistic}; ${limitsText(r)}; ` +
      (margin >= 0 ? `margin ${digits(100 * margin, 3)} %.` : `${digits(-100 * margin, 3)} % over the limit.`)));
}

function card(name, value, detail) {
  byId("numbers").append(make("div", {}, make("dt", {}, name), make("dd", { class: "value" }, ...breakable(value)), make("dd", { class: "detail" }, ...breakable(detail))));
}
function linearText(covariance, simulated) {
  if (!covariance) return "";
  const linear = covariance.horizontal_rms_m.at_end, missing = (covariance.not_covered || []).length;
  if (missing) return `; linear covariance does not cover ${many(missing, "source")}`;
  if (!(linear > 0)) return "";
  return `; linear covariance ${lengthText(linear)} (${linear >= simulated ? "+" : "\u2212"}${digits(Math.abs(100 * (linear / simulated - 1)), 2)} %)`;
}
/* A source has no margin when the requirement would not be met without it either. */
function marginText(most) {
  if (!most) return "no source is switched on";
  if (!("margin" in most.row)) return `not met without ${most.id} either`;
  return isNumber(most.row.margin) ? `the limit is reached with ${digits(most.row.margin, 3)} times ${most.id}` : `${most.id} does not matter`;
}
function showNumbers() {
  const { all, requirement: r, covariance } = result, most = sources[0];
  const limits = (name) => r && r.statistic === name ? limitsText(r) : "";
  card("Drift, CEP", rate(all.drift_cep_nmi_per_h), limits("CEP") || "median of the runs");
  card("Drift, R95", rate(all.drift_r95_nmi_per_h), limits("R95") || "95 % of the runs are below");
  card("Position at the end, rms", lengthText(all.horizontal_rms_m.at_end), "all sources at once" + linearText(covariance, all.horizontal_rms_m.at_end));
  if (most) card("Largest source", most.id, `${percent(share(most, LAST))} of the variance, alone ${rate(most.row.drift_cep_nmi_per_h)} CEP`);
  if (r) card("Margin", r.value_nmi_per_h > r.limit_nmi_per_h ? "none" : digits(100 * (1 - r.value_nmi_per_h / r.limit_nmi_per_h), 3) + " %", marginText(most));
}
