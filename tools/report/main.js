/* SPDX-License-Identifier: MIT */
/* Everything in its place. */
byId("duration").textContent = clock(result.duration_s);
if (curves.rows > curves.times_s.length) byId("thinned").textContent = `Of ${curves.rows} times of errors.csv the page holds ${curves.times_s.length}.`;
byId("copy").addEventListener("click", () => {
  const text = byId("scenario").textContent, said = (words) => { byId("copied").textContent = words; };
  const select = () => { getSelection().selectAllChildren(byId("scenario")); said(document.execCommand("copy") ? "Copied." : "Selected: press Ctrl+C."); };
  if (navigator.clipboard) navigator.clipboard.writeText(text).then(() => said("Copied."), select);
  else select();
});
Chart.defaults.font.family = getComputedStyle(document.documentElement).fontFamily;
showVerdict();
showNumbers();
makeBudget();
readAddress();
views.push(showBudget, showPosition, showSources, showEnds);
showAll();
timeCharts.forEach(makeZoom);
addEventListener("hashchange", () => { readAddress(); showAll(); });
document.documentElement.dataset.ready = "yes";
