// What the reader chose on a page that is served, so that the next one begins with it.

/** Boxes of the menus by what stands beside them. */
function boxes() {
  const all = new Map();
  for (const panel of ["parts", "traces", "forces"]) {
    for (const label of document.querySelectorAll(`#${panel} label`)) {
      const box = label.querySelector("input[type=checkbox]");
      if (box) all.set(`${panel} ${label.textContent}`, box);
    }
  }
  return all;
}

/** What can be opened, by its title and which one of that title it is. */
function openable() {
  const all = new Map();
  for (const details of document.querySelectorAll("details:not(.menu)")) {
    const title = details.querySelector("summary").textContent;
    let name = title;
    for (let again = 2; all.has(name); again++) name = `${title} ${again}`;
    all.set(name, details);
  }
  return all;
}

const titles = () => plots.map((plot) => plot.columns.map((column) => column.name).join());

/** The choices as they are. */
function state() {
  const arrows = document.querySelector("#forces input[type=range]");
  const entries = (map, value) => [...map].map(([name, item]) => [name, value(item)]);
  return {
    time: player.time,
    playing: player.playing,
    repeat: player.repeat,
    speed: player.speed,
    zoom,
    dark: isDark() === system.matches ? null : isDark(),
    scroll: scrollY,
    boxes: entries(boxes(), (box) => box.checked),
    open: entries(openable(), (details) => details.open),
    hidden: titles().map((title, i) => [title, [...plots[i].hidden]]),
    against: [phase.x, phase.y].map((select) => run.columns[select.value].name),
    arrows: arrows && arrows.value,
    view: drawing && drawing.view && [drawing.view.azimuth, drawing.view.elevation, drawing.view.zoom],
  };
}

/** Makes the choices again, as far as the page has what they are about. */
function restore(kept) {
  if (!kept.playing) player.pause();
  else if (!player.playing) player.play();
  if (kept.repeat !== player.repeat) byId("loop").click();
  if (SPEEDS.includes(kept.speed)) setSpeed(kept.speed);
  if (kept.dark !== null) setTheme(kept.dark);
  for (const [name, checked] of kept.boxes) {
    const box = boxes().get(name);
    if (box && box.checked !== checked) box.click();
  }
  for (const [name, open] of kept.open) {
    const details = openable().get(name);
    if (details) details.open = open;
  }
  for (const [title, hidden] of kept.hidden) {
    const plot = plots[titles().indexOf(title)];
    if (!plot) continue;
    plot.hidden = new Set(hidden);
    plot.card.querySelectorAll(".legend button").forEach((button, i) => button.setAttribute("aria-pressed", String(!plot.hidden.has(i))));
    if (plot.chart) plot.columns.forEach((_, i) => plot.chart.setSeries(i + 1, { show: !plot.hidden.has(i) }));
  }
  [phase.x, phase.y].forEach((select, i) => {
    const index = run.columns.findIndex((column) => column.name === kept.against[i]);
    if (index >= 0) select.value = index;
  });
  const arrows = document.querySelector("#forces input[type=range]");
  if (arrows && kept.arrows !== null) {
    arrows.value = kept.arrows;
    arrows.dispatchEvent(new Event("input"));
  }
  if (kept.view && drawing && drawing.view) {
    [drawing.view.azimuth, drawing.view.elevation, drawing.view.zoom] = kept.view;
    drawing.turned();
  }
  if (kept.zoom) zoomTo(kept.zoom);
  player.seek(kept.time);
  player.render();
  scrollTo(0, kept.scroll);
}

Object.assign(window.report, { state, restore });
