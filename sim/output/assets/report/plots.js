// Curves over time, their zoom in common, and a cursor at the animation's time.

const HEIGHT = 190;
/** Of one row of the legend. */
const LEGEND = 32;
const plots = [];
let zoom = null;

/** One card: title, legend with values, curves. */
class PlotCard {
  constructor(figure, opened) {
    this.columns = figure.columns.map((index) => run.columns[index]);
    this.hidden = new Set();
    this.visible = false;
    this.opened = opened;
    this.body = element("div", opened ? { style: `min-height: ${HEIGHT + LEGEND}px` } : {});
    this.card = element("article", { class: `plot card${opened ? " open" : ""}` });
    if (opened) {
      this.card.append(element("h3", {}, figure.title), this.body);
    } else {
      const details = element("details", {}, element("summary", {}, figure.title, this.hint()), this.body);
      details.addEventListener("toggle", () => {
        this.card.classList.toggle("open", details.open);
        if (details.open && !this.chart) this.build();
        player.refresh();
      });
      this.card.append(details);
    }
    new IntersectionObserver(([entry]) => {
      this.visible = entry.isIntersecting;
      if (this.visible) this.show();
    }, { rootMargin: "50%" }).observe(this.card);
  }

  /** Draws an open card when it is seen, or about to be. */
  show() {
    if (this.opened && !this.chart) this.build();
    this.update(player.shown());
  }

  /** What a closed card would show. */
  hint() {
    const names = this.columns.map((column) => column.label);
    return element("span", { class: "hint" }, names.length > 4 ? `${names.slice(0, 3).join(", ")}, …` : names.join(", "));
  }

  build() {
    this.values = this.columns.map(() => element("span", { class: "value" }));
    const entries = this.columns.map((column, i) => this.entry(column, i));
    this.room = element("div", { class: "curve" });
    this.body.append(element("div", { class: "legend" }, ...entries), this.room);
    this.makeChart();
    new ResizeObserver(() => this.fit()).observe(this.room);
  }

  entry(column, i) {
    this.swatches = this.swatches || [];
    const swatch = element("span", { class: "swatch" });
    this.swatches.push(swatch);
    const button = element("button", { type: "button", "aria-pressed": String(!this.hidden.has(i)), title: "Show or hide" },
      swatch, element("span", { class: "name" }, column.label), this.values[i]);
    button.addEventListener("click", () => {
      const hide = !this.hidden.has(i);
      if (hide) this.hidden.add(i);
      else this.hidden.delete(i);
      button.setAttribute("aria-pressed", String(!hide));
      this.chart.setSeries(i + 1, { show: !hide });
      this.update(player.shown());
    });
    return button;
  }

  makeChart() {
    const axis = { stroke: () => palette.muted, font: `12px ${FONT}`, labelFont: `12px ${FONT}`, grid: { stroke: () => palette.grid, width: 1 }, ticks: { stroke: () => palette.line, width: 1, size: 5 } };
    const units = [...new Set(this.columns.map((column) => column.unit))].map((unit) => `[${unit}]`).join(", ");
    const options = {
      width: this.room.clientWidth || 300,
      height: HEIGHT,
      padding: [8, 22, 0, 0],
      legend: { show: false },
      cursor: { x: false, y: false, points: { show: false }, drag: { x: true, y: false, setScale: true, dist: 6 } },
      scales: { x: { time: false }, y: { range: (_, low, high) => padded(low, high) } },
      axes: [
        { ...axis, ...abscissaTicks(), size: 26, label: abscissa.label, labelSize: 16, labelGap: 0 },
        { ...axis, values: (_, splits) => ticks(splits), space: 26, size: 62, label: units, labelSize: 20, labelGap: 2 },
      ],
      series: [{}, ...this.columns.map((column, i) => ({
        label: column.label,
        show: !this.hidden.has(i),
        stroke: () => series(i),
        width: 2,
        dash: dash(i),
        spanGaps: false,
        points: { show: false },
      }))],
      hooks: { setScale: [(chart, scale) => scale === "x" && share(chart)], setSize: [() => this.update(player.shown())] },
    };
    this.chart = new uPlot(options, [times, ...this.columns.map((column) => finite(column.values))], this.room);
    this.now = element("div", { class: "now" });
    this.dots = this.columns.map(() => element("div", { class: "dot" }));
    this.chart.over.append(this.now, ...this.dots);
    this.recolour();
    this.listen(this.chart.over);
    if (zoom) this.chart.setScale("x", zoom);
  }

  /** Hovering shows a time, a click goes there, a double click shows the whole run. */
  listen(over) {
    let pressed = null;
    const timeUnder = (event) => Math.min(end, Math.max(start, this.chart.posToVal(event.clientX - over.getBoundingClientRect().left, "x")));
    over.addEventListener("mousedown", (event) => (pressed = event.clientX));
    over.addEventListener("mousemove", (event) => event.buttons === 0 && player.preview(timeUnder(event)));
    over.addEventListener("mouseleave", () => player.preview(null));
    over.addEventListener("click", (event) => {
      if (pressed === null || Math.abs(event.clientX - pressed) < 6) player.seek(timeUnder(event));
      pressed = null;
    });
    over.addEventListener("dblclick", () => zoomTo(null));
    pinchable(over);
  }

  fit() {
    const width = Math.floor(this.room.clientWidth);
    if (this.chart && width > 0 && Math.abs(width - this.chart.width) >= 1) this.chart.setSize({ width, height: HEIGHT });
  }

  recolour() {
    this.columns.forEach((_, i) => {
      this.swatches[i].style.borderTopColor = series(i);
      this.swatches[i].style.borderTopStyle = dash(i).length ? "dashed" : "solid";
      this.dots[i].style.background = series(i);
    });
  }

  /** Cursor and values at a time. */
  update(time) {
    if (!this.chart || !this.visible) return;
    const place = locate(time);
    const { min, max } = this.chart.scales.x;
    const inside = time >= min && time <= max;
    const x = this.chart.valToPos(time, "x");
    this.now.style.visibility = inside ? "visible" : "hidden";
    this.now.style.transform = `translateX(${x - 0.75}px)`;
    this.columns.forEach((column, i) => {
      const value = valueAt(column, place);
      const y = this.chart.valToPos(value, "y");
      const on = inside && !this.hidden.has(i) && Number.isFinite(y) && y >= -1 && y <= this.chart.over.clientHeight + 1;
      this.dots[i].style.visibility = on ? "visible" : "hidden";
      this.dots[i].style.transform = `translate(${x}px, ${y}px)`;
      this.values[i].firstChild ? (this.values[i].firstChild.data = number(value)) : this.values[i].append(number(value), element("span", { class: "unit" }, ` ${column.unit}`));
    });
  }
}

/** Ticks along the abscissa: round values of what is shown for time. */
function abscissaTicks() {
  const values = (_, splits) => ticks(splits.map(abscissaAt));
  if (!run.abscissa) return { values };
  return {
    values,
    splits: (chart, _, min, max) => {
      const ends = [abscissaAt(min), abscissaAt(max)].sort((a, b) => a - b);
      const found = round(ends, Math.max(2, chart.bbox.width / devicePixelRatio / 70), abscissa.unit === "°").map(timeAt);
      return abscissa.rate < 0 ? found.reverse() : found;
    },
  };
}

/** At most so many round values in a range; of degrees, parts of a turn. */
function round([low, high], most, degrees = false) {
  const raw = (high - low) / most;
  const power = 10 ** Math.floor(Math.log10(raw));
  const digits = degrees && power >= 1 ? [1, 1.5, 3, 4.5, 6, 9, 10] : [1, 2, 5, 10];
  const step = power * digits.find((digit) => digit * power >= raw * (1 - 1e-9));
  const first = Math.ceil(low / step - 1e-9);
  return Array.from({ length: Math.max(0, Math.floor(high / step + 1e-9) - first + 1) }, (_, i) => (first + i) * step);
}

/** Gaps where a value is not finite. */
function finite(values) {
  return Array.from(values, (value) => (Number.isFinite(value) ? value : null));
}

/** A range with some space, also round a constant; rounding of a constant is not blown up. */
function padded(low, high) {
  if (low === null || high === null) return [-1, 1];
  const size = Math.max(Math.abs(low), Math.abs(high));
  if (high - low <= 1e-6 * size || size === 0) {
    const half = size > 0 ? 0.1 * size : 1;
    return [(low + high) / 2 - half, (low + high) / 2 + half];
  }
  const space = 0.06 * (high - low);
  return [low - space, high + space];
}

let sharing = false;

/** Gives one chart's range of time to all others. */
function share(chart) {
  if (sharing || !player.ready) return;
  const { min, max } = chart.scales.x;
  zoomTo(min <= start && max >= end ? null : { min, max });
}

/** Shows a range of time in all plots; the whole run without one. */
function zoomTo(range) {
  const whole = end > start ? end - start : 1;
  if (range) {
    const span = Math.min(whole, Math.max(range.max - range.min, 1e-6 * whole));
    const from = Math.min(Math.max(range.min, start), end - span);
    range = span >= 0.9999 * whole ? null : { min: from, max: from + span };
  }
  zoom = range;
  sharing = true;
  for (const plot of plots) if (plot.chart) plot.chart.setScale("x", range || { min: start, max: end > start ? end : start + 1 });
  sharing = false;
  document.body.classList.toggle("zoomed", zoom !== null);
  player.refresh();
}

/** Zooms by a factor about the cursor. */
function zoomBy(factor) {
  const { min, max } = zoom || { min: start, max: end };
  const now = Math.min(max, Math.max(min, player.shown()));
  zoomTo({ min: now - (now - min) * factor, max: now + (max - now) * factor });
}

/** Any quantity against any other. */
class Phase {
  constructor() {
    this.canvas = element("canvas", { id: "phase", role: "img", "aria-label": "One quantity against another" });
    const options = () => run.columns.map((column, i) => element("option", { value: i }, `${column.label === column.name ? "" : column.label + " · "}${column.name}`));
    this.x = element("select", { "aria-label": "Along the abscissa", onchange: () => this.reset() }, ...options());
    this.y = element("select", { "aria-label": "Along the ordinate", onchange: () => this.reset() }, ...options());
    [this.x.value, this.y.value] = run.phase;
    const controls = element("div", { class: "against" }, element("label", {}, "across", this.x), element("label", {}, "up", this.y));
    const details = element("details", {}, element("summary", {}, "Any against any", element("span", { class: "hint" }, "phase portrait")), controls, this.canvas);
    this.card = element("article", { class: "plot card" }, details);
    details.addEventListener("toggle", () => {
      this.card.classList.toggle("open", details.open);
      if (details.open) this.reset();
    });
    new ResizeObserver(() => this.reset()).observe(this.canvas);
  }

  get open() {
    return this.card.classList.contains("open");
  }

  reset() {
    if (!this.open || !this.canvas.clientWidth) return;
    const ratio = window.devicePixelRatio || 1;
    const [w, h] = [this.canvas.clientWidth, this.canvas.clientHeight];
    [this.canvas.width, this.canvas.height] = [Math.round(w * ratio), Math.round(h * ratio)];
    this.ratio = ratio;
    this.columns = [this.x, this.y].map((select) => run.columns[select.value]);
    this.ranges = this.columns.map((column) => {
      const values = column.values.filter(Number.isFinite);
      const reduce = (pick) => values.reduce((a, b) => pick(a, b), values[0] ?? 0);
      return padded(reduce(Math.min), reduce(Math.max));
    });
    this.box = [74, 12, w - 18, h - 44];
    this.path = new Path2D();
    const step = Math.max(1, Math.floor(times.length / 6000));
    let down = false;
    for (let i = 0; i < times.length; i += step) {
      const [x, y] = this.place(this.columns.map((column) => column.values[i]));
      const shown = Number.isFinite(x + y);
      if (shown && down) this.path.lineTo(x, y);
      else if (shown) this.path.moveTo(x, y);
      down = shown;
    }
    this.update(player.shown());
  }

  place([x, y]) {
    const [left, top, right, bottom] = this.box;
    const share = (value, [low, high]) => (value - low) / (high - low);
    return [left + share(x, this.ranges[0]) * (right - left), bottom - share(y, this.ranges[1]) * (bottom - top)];
  }

  update(time) {
    if (!this.open || !this.path) return;
    const c = this.canvas.getContext("2d");
    c.setTransform(this.ratio, 0, 0, this.ratio, 0, 0);
    c.clearRect(0, 0, this.canvas.width, this.canvas.height);
    this.axes(c);
    c.strokeStyle = series(0);
    c.lineWidth = 1.8;
    c.lineJoin = "round";
    c.stroke(this.path);
    const [x, y] = this.place(this.columns.map((column) => valueAt(column, locate(time))));
    c.beginPath();
    c.arc(x, y, 5, 0, 2 * Math.PI);
    c.fillStyle = series(1);
    c.fill();
  }

  axes(c) {
    const [left, top, right, bottom] = this.box;
    c.font = `12px ${FONT}`;
    c.lineWidth = 1;
    c.fillStyle = palette.muted;
    c.strokeStyle = palette.grid;
    const rule = (from, to) => {
      c.beginPath();
      c.moveTo(...from);
      c.lineTo(...to);
      c.stroke();
    };
    const xs = round(this.ranges[0], Math.max(2, (right - left) / 80));
    const ys = round(this.ranges[1], 6);
    ticks(xs).forEach((text, i) => {
      const [x] = this.place([xs[i], this.ranges[1][0]]);
      rule([x, top], [x, bottom]);
      c.textAlign = "center";
      c.fillText(text, x, bottom + 16);
    });
    ticks(ys).forEach((text, i) => {
      const [, y] = this.place([this.ranges[0][0], ys[i]]);
      rule([left, y], [right, y]);
      c.textAlign = "right";
      c.fillText(text, left - 7, y + 4);
    });
    c.textAlign = "center";
    const label = (column) => `${column.name} [${column.unit}]`;
    c.fillText(label(this.columns[0]), (left + right) / 2, bottom + 36);
    c.save();
    c.translate(14, (top + bottom) / 2);
    c.rotate(-Math.PI / 2);
    c.fillText(label(this.columns[1]), 0, 0);
    c.restore();
  }
}
