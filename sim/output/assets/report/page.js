// The page: what its controls do.

const byId = (id) => document.getElementById(id);
readPalette();

const drawing = run.drawing.width > 0 ? new Drawing(byId("drawing")) : null;
if (!drawing) byId("view").remove();

function addPlots() {
  const add = (figure, opened) => {
    const plot = new PlotCard(figure, opened);
    plots.push(plot);
    byId("plots").append(plot.card);
  };
  for (const figure of run.figures) add(figure, true);
  for (const figure of run.more) add(figure, false);
  const phase = new Phase();
  byId("plots").append(phase.card);
  // Those in sight at once, the others when they come near.
  const inSight = plots.filter((plot) => plot.card.getBoundingClientRect().top < innerHeight);
  for (const plot of inSight) if (plot.opened) plot.build();
  return phase;
}

// What follows the time.
const range = Math.abs(abscissaAt(end) - abscissaAt(start));
const decimals = range > 0 ? Math.min(9, Math.max(run.abscissa ? 1 : 2, 3 - Math.floor(Math.log10(range)))) : 3;
const clockText = (time) => `${abscissa.name} = ${abscissaAt(time).toFixed(decimals).replace("-", MINUS)}${abscissa.unit === "°" ? "" : " "}${abscissa.unit}`;
player.shows.push((time) => {
  if (drawing) {
    drawing.draw(time);
    byId("clock").textContent = clockText(time);
  }
  byId("scrubber").value = end > start ? (1000 * (time - start)) / (end - start) : 0;
  byId("scrubber").setAttribute("aria-valuetext", clockText(time));
  for (const plot of plots) plot.update(time);
  phase.update(time);
});

// Player.
byId("play").addEventListener("click", () => player.toggle());
byId("back").addEventListener("click", () => player.step(-1));
byId("forward").addEventListener("click", () => player.step(1));
byId("scrubber").addEventListener("input", (event) => {
  player.pause();
  player.seek(start + (event.target.value / 1000) * (end - start));
});
byId("loop").addEventListener("click", () => {
  player.repeat = !player.repeat;
  byId("loop").setAttribute("aria-pressed", String(player.repeat));
});
for (const mark of run.events) {
  if (end > start) byId("marks").append(element("i", { style: `left: ${(100 * (mark - start)) / (end - start)}%` }));
}

function setSpeed(speed) {
  player.speed = speed;
  byId("speed").value = String(speed);
}
const speedText = (speed) => (speed >= 1 || speed >= 0.1 ? `${speed}×` : `1/${Math.round(1 / speed)}×`);
for (const speed of SPEEDS) byId("speed").append(element("option", { value: speed }, speedText(speed)));
byId("speed").addEventListener("change", (event) => setSpeed(Number(event.target.value)));
setSpeed(fittingSpeed());
const changeSpeed = (by) => setSpeed(SPEEDS[Math.min(SPEEDS.length - 1, Math.max(0, SPEEDS.indexOf(player.speed) + by))]);

// Menus over the drawing.
function checkbox(text, checked, change, colour) {
  const box = element("input", { type: "checkbox", checked });
  box.addEventListener("change", () => {
    change(box.checked);
    player.refresh();
  });
  const swatch = colour ? [element("span", { class: "swatch", style: `border-color: ${colour}` })] : [];
  return element("label", {}, box, ...swatch, element("span", {}, text));
}
const among = (set, item) => (on) => (on ? set.add(item) : set.delete(item));

function fillMenus() {
  const shapes = run.drawing.shapes;
  const parts = shapes.filter((shape) => ["line", "slider", "circle", "curve", "spring", "damper"].includes(shape.kind));
  const hide = (shape) => (on) => (on ? drawing.hidden.delete(shape.index) : drawing.hidden.add(shape.index));
  const colour = (shape) => (!["line", "circle"].includes(shape.kind) ? "var(--muted)" : `var(--series-${shape.colour % 7})`);
  byId("parts").append(...parts.map((shape) => checkbox(shape.label, true, hide(shape), colour(shape))));
  const kinds = [["joints", "joints", "line"], ["supports", "supports", "ground"], ["guides", "guides", "slider"], ["masses", "marked points", "points"]];
  byId("parts").append(element("hr"));
  for (const [key, text, kind] of kinds) {
    if (shapes.some((shape) => shape.kind === kind)) byId("parts").append(checkbox(text, true, (on) => (drawing.show[key] = on)));
  }
  byId("parts").append(checkbox("names of points", drawing.show.names, (on) => (drawing.show.names = on)));
  for (const [i, point] of drawing.points.entries()) {
    byId("traces").append(checkbox(point.name, drawing.traced.has(point.name), among(drawing.traced, point.name), `var(--series-${drawing.colourOfTrace(i) % 7})`));
  }
  byId("traces").append(element("p", {}, "Or click a point in the drawing."));
  if (run.vectors.length === 0) {
    byId("forces-menu").remove();
    return;
  }
  for (const [i, vector] of run.vectors.entries()) {
    byId("forces").append(checkbox(vector.about, false, among(drawing.vectors, i), `var(--${vector.kind})`));
  }
  const scale = element("input", { type: "range", min: -1, max: 1, step: 0.05, value: 0, "aria-label": "Length of arrows" });
  scale.addEventListener("input", () => {
    drawing.vectorScale = 10 ** scale.value;
    player.refresh();
  });
  byId("forces").append(element("hr"), element("label", {}, element("span", {}, "length"), scale));
}

if (drawing) {
  fillMenus();
  new ResizeObserver(() => {
    drawing.resize();
    if (player.ready) drawing.draw(player.shown());
  }).observe(byId("drawing"));
  if (drawing.view) turnable(byId("drawing"), drawing.view, () => drawing.turned());
  let pressed = [0, 0];
  byId("drawing").addEventListener("pointerdown", (event) => (pressed = [event.clientX, event.clientY]));
  byId("drawing").addEventListener("click", (event) => {
    // A click, not the end of turning it.
    if (Math.hypot(event.clientX - pressed[0], event.clientY - pressed[1]) > 4) return;
    const box = byId("drawing").getBoundingClientRect();
    const name = drawing.nearest(event.clientX - box.left, event.clientY - box.top, player.shown());
    if (name === null) return;
    const index = drawing.points.findIndex((point) => point.name === name);
    byId("traces").querySelectorAll("input")[index].click();
  });
} else {
  for (const id of ["parts-menu", "traces-menu", "forces-menu"]) byId(id).remove();
}
const menus = [...document.querySelectorAll("details.menu")];
document.addEventListener("click", (event) => menus.forEach((menu) => !menu.contains(event.target) && (menu.open = false)));

// Zoom.
byId("zoom-in").addEventListener("click", () => zoomBy(0.5));
byId("zoom-out").addEventListener("click", () => zoomBy(2));
byId("zoom-all").addEventListener("click", () => zoomTo(null));

// Theme: the reader's system, until chosen here.
const system = matchMedia("(prefers-color-scheme: dark)");
function setTheme(dark) {
  document.documentElement.classList.toggle("dark", dark);
  readPalette();
  for (const plot of plots) {
    if (!plot.chart) continue;
    plot.recolour();
    plot.chart.redraw(true, true);
  }
  player.refresh();
}
const isDark = () => document.documentElement.classList.contains("dark");
system.addEventListener("change", () => setTheme(system.matches));
byId("theme-button").addEventListener("click", () => setTheme(!isDark()));
byId("print-button").addEventListener("click", () => print());
/** The width of plots on A4 or letter paper, in CSS pixels. */
const PRINTED = 640;
let darkBeforePrint = false;

/** Makes equations that are wider than paper smaller, down to what can just be read. */
function fitEquations(width) {
  for (const row of document.querySelectorAll(".equations .row")) {
    row.style.width = width ? `${width}px` : "";
    row.style.removeProperty("--math-size");
    if (width && row.scrollWidth > width) row.style.setProperty("--math-size", `${Math.max(6, Math.floor((170 * width) / row.scrollWidth) / 10)}px`);
  }
}

addEventListener("beforeprint", () => {
  darkBeforePrint = isDark();
  setTheme(false);
  for (const plot of plots) plot.show();
  for (const plot of plots) if (plot.chart) plot.chart.setSize({ width: PRINTED, height: HEIGHT });
  fitEquations(PRINTED);
  player.render();
});
addEventListener("afterprint", () => {
  setTheme(darkBeforePrint);
  for (const plot of plots) plot.fit();
  fitEquations(null);
});

// Turning what stands in space.
if (!(drawing && drawing.view)) document.querySelectorAll(".space").forEach((key) => key.remove());
const turn = (azimuth, elevation) => drawing && drawing.view && (drawing.view.turn(azimuth, elevation), drawing.turned());
const reset = () => drawing && drawing.view && (drawing.view.reset(), drawing.turned());

// Keys.
byId("keys-button").addEventListener("click", () => byId("keys").showModal());
const span = () => (zoom ? zoom.max - zoom.min : end - start);
const keys = {
  " ": () => player.toggle(),
  ArrowLeft: (event) => (event.shiftKey ? player.seek(player.time - span() / 50) : player.step(-1)),
  ArrowRight: (event) => (event.shiftKey ? player.seek(player.time + span() / 50) : player.step(1)),
  Home: () => player.seek(start),
  End: () => player.seek(end),
  "[": () => changeSpeed(-1),
  "]": () => changeSpeed(1),
  l: () => byId("loop").click(),
  "+": () => zoomBy(0.5),
  "=": () => zoomBy(0.5),
  "-": () => zoomBy(2),
  0: () => zoomTo(null),
  d: () => byId("theme-button").click(),
  "?": () => byId("keys").showModal(),
  ",": () => turn(-0.1, 0),
  ".": () => turn(0.1, 0),
  u: () => turn(0, 0.1),
  n: () => turn(0, -0.1),
  v: () => reset(),
  Escape: () => menus.forEach((menu) => (menu.open = false)),
};
document.addEventListener("keydown", (event) => {
  // Controls keep the keys that they have a use for.
  const on = (selector) => event.target.closest(selector) !== null;
  const kept = on("dialog, select, input:not(#scrubber)") ? event.key !== "Escape" : on("button, summary") && [" ", "Enter"].includes(event.key);
  if (event.ctrlKey || event.metaKey || event.altKey || kept) return;
  const act = keys[event.key] || keys[event.key.toLowerCase()];
  if (!act) return;
  event.preventDefault();
  act(event);
});

/** The median time in milliseconds of drawing frames all through the run, with the pixels or without. */
function frameCost(frames = 101, pixels = true) {
  const costs = [];
  for (let i = 0; i < frames; i++) {
    const before = performance.now();
    player.seek(start + (i / (frames - 1)) * (end - start));
    player.render();
    if (pixels && drawing) drawing.context.getImageData(0, 0, 1, 1);
    costs.push(performance.now() - before);
  }
  return costs.sort((a, b) => a - b)[frames >> 1];
}

// A place in the address: #t=0.5 opens the report there, at rest; of a sweep it is a value of what is driven.
const asked = new URLSearchParams(location.hash.slice(1));
document.documentElement.classList.toggle("dark", asked.has("theme") ? asked.get("theme") === "dark" : system.matches);
readPalette();
if (run.abscissa) {
  byId("scrubber").setAttribute("aria-label", abscissa.label);
  byId("zoom-hint").textContent = "Drag to zoom, click to go to a position";
}
const phase = addPlots();
player.ready = true;
if (drawing) drawing.resize();
const place = Number(asked.get("t"));
if (asked.has("t")) player.seek(Number.isFinite(place) ? timeAt(place) : start);
else if (!matchMedia("(prefers-reduced-motion: reduce)").matches) player.play();
player.render();
window.report = { player, drawing, plots, zoomTo, frameCost, isDark };
document.documentElement.dataset.ready = performance.now().toFixed(1);
