// Numbers as they are read, and colours of the theme.

const MINUS = "\u2212";

/** Six digits; powers of ten where that would be long. */
function number(value, digits = 6) {
  if (!Number.isFinite(value)) return "\u2013";
  if (value === 0) return "0";
  const size = Math.abs(value);
  const whole = Math.abs(Number(value.toPrecision(digits))) >= 10 ** (digits - 1);
  const text = size >= 1e6 || size < 1e-4 ? value.toExponential(digits - 1) : whole ? Number(value.toPrecision(digits)).toFixed(0) : value.toPrecision(digits);
  return text.replace("e+", "e").replaceAll("-", MINUS);
}

/** Ticks that all have the decimals their distance needs. */
function ticks(splits) {
  const finite = splits.filter((split) => split !== null);
  const largest = Math.max(...finite.map(Math.abs), 0);
  const step = finite.length > 1 ? Math.abs(finite[1] - finite[0]) : largest || 1;
  const decimals = Math.min(12, Math.max(0, -Math.floor(Math.log10(step) + 1e-9)));
  const exact = (value) => Math.abs(Number(value.toFixed(decimals)) - value) <= 1e-6 * step;
  const places = finite.every(exact) ? decimals : decimals + 1;
  const plain = largest < 1e6 && (largest >= 1e-3 || largest === 0);
  return splits.map((value) => {
    if (value === null) return "";
    if (Math.abs(value) < 1e-9 * step) return "0";
    const text = plain ? grouped(value.toFixed(places)) : String(Number(value.toPrecision(6)).toExponential());
    return text.replace("e+", "e").replaceAll("-", MINUS);
  });
}

/** Thousands apart in numbers of five digits or more. */
function grouped(text) {
  return text.replace(/\d{5,}/, (digits) => digits.replace(/\B(?=(\d{3})+$)/g, "\u2009"));
}

let palette = {};

/** Reads the theme's colours anew. */
function readPalette() {
  const style = getComputedStyle(document.documentElement);
  const colour = (name) => style.getPropertyValue(`--${name}`).trim();
  const names = ["page", "card", "ink", "muted", "line", "grid", "accent", "ground", "load", "reaction"];
  palette = Object.fromEntries(names.map((name) => [name, colour(name)]));
  palette.series = [0, 1, 2, 3, 4, 5, 6].map((index) => colour(`series-${index}`));
}

/** The colour of a curve or link; the style of those after the seventh differs too. */
const series = (index) => palette.series[index % palette.series.length];
const dash = (index) => [[], [9, 5], [2, 4]][Math.floor(index / 7) % 3];

/** An element with attributes and children. */
function element(tag, attributes = {}, ...children) {
  const made = document.createElement(tag);
  for (const [name, value] of Object.entries(attributes)) {
    if (name.startsWith("on")) made.addEventListener(name.slice(2), value);
    else if (value !== false && value !== undefined) made.setAttribute(name, value === true ? "" : value);
  }
  made.append(...children);
  return made;
}

const FONT = 'system-ui, -apple-system, "Segoe UI", Roboto, "Helvetica Neue", Arial, "Noto Sans", sans-serif';
