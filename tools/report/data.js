/* SPDX-License-Identifier: MIT */
/* What the page is made from, numbers as text, and elements made of text alone. */
const byId = (id) => document.getElementById(id);
const read = (id) => JSON.parse(byId(id).textContent);
const result = read("result");
const curves = read("curves");
const LAST = curves.times_s.length - 1;
const NMI_M = 1852;
const isNumber = (x) => typeof x === "number" && Number.isFinite(x);
const NONE = "\u2013";

/* Four digits; very small and large ones with a power of ten. */
function digits(x, count = 4) {
  if (!isNumber(x)) return NONE;
  if (x === 0) return "0";
  const size = Math.abs(x);
  if (size < 1e-4 || size >= 1e7) {
    const [mantissa, power] = x.toExponential(Math.max(count - 2, 0)).split("e");
    return mantissa + "\u00b710" + power.replace("+", "").replace(/./g, (c) => "\u207b\u2070\u00b9\u00b2\u00b3\u2074\u2075\u2076\u2077\u2078\u2079"["-0123456789".indexOf(c)]);
  }
  const decimals = Math.max(0, count - 1 - Math.floor(Math.log10(size)));
  return x.toFixed(decimals);
}
/* As it was written: no more digits than it has. */
const plain = (x) => !isNumber(x) ? NONE : x === 0 || Math.abs(x) >= 1e-4 && Math.abs(x) < 1e7 ? String(Number(x.toPrecision(6))) : digits(x, 3).replace(".0\u00b7", "\u00b7");
const many = (n, what) => n + " " + what + (n === 1 ? "" : "s");
const percent = (x) => isNumber(x) ? (100 * x).toFixed(1) + " %" : NONE;

/* One unit of length for the whole page, by the largest curve. */
const largest = Math.max(...curves.high, ...curves.all, ...curves.sources.map((s) => Math.max(...s)), 0);
const LENGTH = largest >= NMI_M ? { name: "nmi", m: NMI_M } : largest >= 1 ? { name: "m", m: 1 } : { name: "mm", m: 1e-3 };
const length = (m) => digits(m / LENGTH.m);
const lengthText = (m) => length(m) + " " + LENGTH.name;

const TIME = result.duration_s >= 5400 ? { name: "h", s: 3600 } : result.duration_s >= 180 ? { name: "min", s: 60 } : { name: "s", s: 1 };
function clock(s) {
  const whole = Math.floor(s), rest = s - whole, two = (x) => String(x).padStart(2, "0");
  const fraction = rest > 5e-4 ? rest.toFixed(3).slice(1).replace(/0+$/, "") : "";
  return Math.floor(whole / 3600) + ":" + two(Math.floor(whole / 60) % 60) + ":" + two(whole % 60) + fraction;
}

/* make("td", {class: "text"}, "text", child...): text is always text. */
function make(tag, attributes, ...children) {
  const element = document.createElement(tag);
  for (const [name, value] of Object.entries(attributes || {})) element.setAttribute(name, value);
  element.append(...children);
  return element;
}

/* Long names may break after a dot or an underscore. */
const breakable = (name) => name.split(/(?<=[._])(?=[a-z])/).flatMap((part, i) => i ? [make("wbr"), part] : [part]);

/* A table of columns over about a dozen of the times. */
function timeTable(caption, columns) {
  const rows = Math.min(LAST, 12), body = make("tbody");
  for (let i = 0; i <= rows; i++) {
    const k = Math.round(i * LAST / rows);
    body.append(make("tr", {}, make("th", { scope: "row" }, clock(curves.times_s[k])),
      ...columns.map((c) => make("td", {}, length(c.values[k])))));
  }
  return make("table", {}, make("caption", { class: "note" }, caption + ", " + LENGTH.name),
    make("thead", {}, make("tr", {}, make("th", { scope: "col" }, "time"), ...columns.map((c) => make("th", { scope: "col" }, c.name)))), body);
}
