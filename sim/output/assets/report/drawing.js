// The mechanism at one time, to scale, on a canvas.

/** Sizes of symbols in CSS pixels, on a canvas about 600 pixels wide. */
const SIZE = { link: 5, pin: 5.5, mass: 7, slider: [20, 11], spring: 8, guide: 56, ground: [13, 18], reach: 52, arrow: 11 };

/** The height of the strip below the mechanism. */
const FOOT = 30;

/** The numbers of a point: (x, y) or (x, y, z). */
const DIMENSION = run.drawing.dimension;

/** The points of the drawing, each once: name, and where its x is in a row. */
function pointsOf(shapes) {
  const points = [];
  const add = (name, at) => {
    if (!points.some((point) => point.name === name)) points.push({ name, at });
  };
  for (const shape of shapes) shape.points.forEach((name, i) => add(name, shape.first + DIMENSION * i));
  return points;
}

class Drawing {
  constructor(canvas) {
    this.canvas = canvas;
    this.context = canvas.getContext("2d");
    this.width = run.drawing.width;
    this.row = new Float64Array(this.width);
    this.points = pointsOf(run.drawing.shapes);
    this.show = { joints: true, supports: true, guides: true, masses: true, names: run.drawing.named };
    this.hidden = new Set();
    this.traced = new Set(run.drawing.shapes.filter((shape) => shape.kind === "trace").flatMap((shape) => shape.points));
    this.vectors = new Set();
    this.vectorScale = 1;
    this.extent = this.findExtent();
    this.view = DIMENSION === 3 ? this.around() : null;
    this.largest = this.findLargestVectors();
  }

  /** The least and the greatest of each component of all positions. */
  findExtent() {
    const box = Array.from({ length: DIMENSION }, () => [Infinity, -Infinity]);
    const reach = (at, r) => {
      box.forEach((range, i) => {
        if (!Number.isFinite(drawn[at + i] + r)) return;
        range[0] = Math.min(range[0], drawn[at + i] - r);
        range[1] = Math.max(range[1], drawn[at + i] + r);
      });
    };
    for (let row = 0; row < drawn.length; row += this.width) {
      for (const shape of run.drawing.shapes) {
        const radius = shape.kind === "circle" ? Math.abs(drawn[row + shape.first + DIMENSION]) : 0;
        shape.points.forEach((_, i) => reach(row + shape.first + DIMENSION * i, radius));
      }
    }
    return box.every(([low]) => Number.isFinite(low)) ? box : box.map(() => [-1, 1]);
  }

  /** A view of all positions. */
  around() {
    const centre = this.extent.map(([low, high]) => (low + high) / 2);
    let radius = 0;
    for (let row = 0; row < drawn.length; row += this.width) {
      for (const shape of run.drawing.shapes) {
        const more = shape.kind === "circle" ? Math.abs(drawn[row + shape.first + 3]) : 0;
        shape.points.forEach((_, i) => {
          const at = row + shape.first + 3 * i;
          const apart = Math.hypot(...centre.map((part, j) => drawn[at + j] - part)) + more;
          if (apart > radius) radius = apart;
        });
      }
    }
    return new View(centre, radius || 1);
  }

  /** Shows the view anew. */
  turned() {
    this.paths = new Map();
    player.refresh();
  }

  /** The longest vector of each kind of quantity. */
  findLargestVectors() {
    const largest = {};
    for (const vector of run.vectors) {
      for (let row = 0; row < vector.numbers.length; row += 2 * DIMENSION) {
        const size = Math.hypot(...vector.numbers.subarray(row + DIMENSION, row + 2 * DIMENSION));
        if (Number.isFinite(size)) largest[vector.kind] = Math.max(largest[vector.kind] || 0, size);
      }
    }
    return largest;
  }

  /** Fits the sheet to the canvas. */
  resize() {
    const { clientWidth: w, clientHeight: h } = this.canvas;
    const ratio = window.devicePixelRatio || 1;
    this.canvas.width = Math.round(w * ratio);
    this.canvas.height = Math.round(h * ratio);
    this.ratio = ratio;
    this.unit = Math.min(1.15, Math.max(0.62, Math.min(w / 600, h / 460)));
    // The scale and the clock have the lowest strip.
    const free = h - FOOT;
    const { radius } = this.view || {};
    const [[left, right], [bottom, top]] = this.view ? [[-radius, radius], [-radius, radius]] : this.extent;
    const reach = SIZE.reach * this.unit;
    const fill = (space, range) => (range > 0 ? Math.max(20, space - 2 * reach) / range : Infinity);
    const scale = Math.min(fill(w, right - left), fill(free, top - bottom));
    this.scale = Number.isFinite(scale) && scale < 1e12 ? scale : 100;
    this.origin = [w / 2 - (this.scale * (left + right)) / 2, free / 2 + (this.scale * (bottom + top)) / 2];
    this.sheet = [w, h];
    this.paths = new Map();
  }

  place(x, y) {
    return [this.origin[0] + this.scale * x, this.origin[1] - this.scale * y];
  }

  pointAt(row, at) {
    return this.view ? this.place(...this.view.place(row[at], row[at + 1], row[at + 2])) : this.place(row[at], row[at + 1]);
  }

  /** The shapes from the farthest to the nearest. */
  ordered(row, shapes) {
    if (!this.view) return shapes;
    const nearness = ({ first, points }) =>
      points.reduce((sum, _, i) => sum + this.view.nearness(...row.subarray(first + 3 * i, first + 3 * i + 3)), 0) / points.length;
    return shapes.map((shape) => [nearness(shape), shape]).sort((a, b) => a[0] - b[0]).map(([, shape]) => shape);
  }

  draw(time) {
    const c = this.context;
    c.setTransform(this.ratio, 0, 0, this.ratio, 0, 0);
    c.clearRect(0, 0, ...this.sheet);
    c.fillStyle = palette.card;
    c.fillRect(0, 0, ...this.sheet);
    c.lineJoin = c.lineCap = "round";
    const place = locate(time);
    const row = this.rowAt(place);
    const shapes = this.ordered(row, run.drawing.shapes.filter((shape) => !this.hidden.has(shape.index)));
    const each = (kind, draw) => shapes.filter((shape) => shape.kind === kind).forEach(draw);
    this.drawScale();
    each("curve", (shape) => this.curve(row, shape));
    if (this.show.guides) each("slider", (shape) => this.guide(row, shape));
    if (this.show.supports) each("ground", (shape) => shape.points.forEach((_, i) => this.ground(row, shape.first + DIMENSION * i)));
    for (const name of this.traced) this.trace(name, row);
    each("spring", (shape) => this.spring(row, shape));
    each("damper", (shape) => this.damper(row, shape));
    each("line", (shape) => this.link(row, shape));
    each("circle", (shape) => this.circle(row, shape));
    each("slider", (shape) => this.slider(row, shape));
    if (this.show.joints) each("line", (shape) => shape.points.forEach((_, i) => this.pin(row, shape.first + DIMENSION * i, series(shape.colour))));
    if (this.show.masses) each("points", (shape) => shape.points.forEach((_, i) => this.mass(row, shape.first + DIMENSION * i)));
    for (const index of this.vectors) this.vector(run.vectors[index], locate(time, arrowTimes));
    if (this.show.names) this.names(row, shapes);
  }

  /** Between samples angles take the shorter way. */
  rowAt(place) {
    const row = between(drawn, this.width, place, this.row);
    if (place.share > 0 && !this.view) {
      for (const shape of run.drawing.shapes) {
        if (shape.kind !== "slider") continue;
        const at = shape.first + 2;
        const from = drawn[place.index * this.width + at];
        const turn = drawn[(place.index + 1) * this.width + at] - from;
        row[at] = from + place.share * (turn - 2 * Math.PI * Math.round(turn / (2 * Math.PI)));
      }
    }
    return row;
  }

  line(points, width, colour, dashes = []) {
    const c = this.context;
    c.beginPath();
    points.forEach(([x, y], i) => (i === 0 ? c.moveTo(x, y) : c.lineTo(x, y)));
    c.lineWidth = width;
    c.strokeStyle = colour;
    c.setLineDash(dashes);
    c.stroke();
    c.setLineDash([]);
  }

  disc([x, y], radius, colour) {
    const c = this.context;
    c.beginPath();
    c.arc(x, y, radius, 0, 2 * Math.PI);
    c.fillStyle = colour;
    c.fill();
  }

  polygon(points, fill, width, colour) {
    const c = this.context;
    c.beginPath();
    points.forEach(([x, y], i) => (i === 0 ? c.moveTo(x, y) : c.lineTo(x, y)));
    c.closePath();
    c.fillStyle = fill;
    c.fill();
    c.lineWidth = width;
    c.strokeStyle = colour;
    c.stroke();
  }

  /** Where the points of a shape are on the sheet. */
  places(row, shape) {
    return shape.points.map((_, i) => this.pointAt(row, shape.first + DIMENSION * i));
  }

  link(row, shape) {
    this.line(this.places(row, shape), SIZE.link * this.unit, series(shape.colour));
  }

  curve(row, shape) {
    this.line(this.places(row, shape), 0.6 * SIZE.link * this.unit, palette.ground);
  }

  /** Lines across an extent, by shares of its length and of a spring's width. */
  along(row, shape, lines) {
    const [from, to] = this.places(row, shape);
    const angle = Math.atan2(from[1] - to[1], to[0] - from[0]);
    const length = Math.hypot(to[0] - from[0], to[1] - from[1]);
    const width = Math.min(SIZE.spring * this.unit, 0.2 * length);
    for (const line of lines) this.line(line.map(([u, v]) => this.turnedBy(from, angle, u * length, v * width)), 1.8, palette.ink);
  }

  spring(row, shape) {
    const peaks = Array.from({ length: 12 }, (_, half) => [0.15 + (0.7 * (half + 0.5)) / 12, half % 2 === 0 ? 1 : -1]);
    this.along(row, shape, [[[0, 0], [0.15, 0], ...peaks, [0.85, 0], [1, 0]]]);
  }

  /** A cylinder on the first end, a piston on the second. */
  damper(row, shape) {
    const [bottom, piston, top] = [0.32, 0.52, 0.68];
    const cylinder = [[top, 1], [bottom, 1], [bottom, -1], [top, -1]];
    this.along(row, shape, [[[0, 0], [bottom, 0]], cylinder, [[piston, 0.75], [piston, -0.75]], [[piston, 0], [1, 0]]]);
  }

  pin(row, at, colour) {
    const point = this.pointAt(row, at);
    this.disc(point, (SIZE.pin + 1) * this.unit, colour);
    this.disc(point, (SIZE.pin - 1.4) * this.unit, palette.card);
  }

  mass(row, at) {
    const c = this.context;
    const point = this.pointAt(row, at);
    const radius = SIZE.mass * this.unit;
    this.disc(point, radius, palette.ink);
    c.fillStyle = palette.card;
    for (const quarter of [0, 2]) {
      c.beginPath();
      c.moveTo(...point);
      c.arc(...point, radius - 1.6, (quarter * Math.PI) / 2, ((quarter + 1) * Math.PI) / 2);
      c.fill();
    }
  }

  circle(row, shape) {
    const [width, colour, at] = [0.6 * SIZE.link * this.unit, series(shape.colour), shape.first];
    if (this.view) {
      const points = ring(row.subarray(at, at + 3), row[at + 3], row.slice(at + 4, at + 7));
      this.line(points.map((point) => this.pointAt(point, 0)), width, colour);
      return;
    }
    const c = this.context;
    c.beginPath();
    c.arc(...this.pointAt(row, at), Math.abs(row[at + 2]) * this.scale, 0, 2 * Math.PI);
    c.lineWidth = width;
    c.strokeStyle = colour;
    c.stroke();
  }

  /** Where a slider is, and the angle of its guide on the sheet. */
  guided(row, { first }) {
    const point = this.pointAt(row, first);
    if (!this.view) return [point, row[first + 2]];
    const [right, up] = this.view.parts(...row.subarray(first + 3, first + 6));
    return [point, Math.atan2(up, right)];
  }

  /** Places given along and across a direction that is counter-clockwise, as in the mechanism. */
  turnedBy([x, y], angle, along, across) {
    const [sine, cosine] = [Math.sin(angle), Math.cos(angle)];
    return [x + along * cosine - across * sine, y - along * sine - across * cosine];
  }

  slider(row, shape) {
    const [point, angle] = this.guided(row, shape);
    const [a, b] = SIZE.slider.map((size) => size * this.unit);
    const corners = [[-a, -b], [a, -b], [a, b], [-a, b]].map(([u, v]) => this.turnedBy(point, angle, u, v));
    this.context.globalAlpha = 0.9;
    this.polygon(corners, palette.line, 1.8, palette.ink);
    this.context.globalAlpha = 1;
  }

  guide(row, shape) {
    const [point, angle] = this.guided(row, shape);
    const half = SIZE.guide * this.unit;
    this.line([-half, half].map((u) => this.turnedBy(point, angle, u, 0)), 1.2, palette.muted, [6, 5]);
  }

  ground(row, at) {
    const [x, y] = this.pointAt(row, at);
    const [half, height] = SIZE.ground.map((size) => size * this.unit);
    const [foot, side] = [y + height, half + 5];
    this.polygon([[x, y], [x + half, foot], [x - half, foot]], palette.grid, 1.6, palette.ground);
    this.line([[x - side, foot], [x + side, foot]], 1.6, palette.ground);
    for (let stroke = 1; stroke <= 6; stroke++) {
      const from = x - side + (2 * side * stroke) / 6;
      this.line([[from, foot], [from - 5, foot + 6]], 1.1, palette.ground);
    }
  }

  /** A declared trace has a colour of its own, as in the figures; others have that of their point's number. */
  colourOfTrace(index) {
    const { name } = this.points[index];
    const declared = run.drawing.shapes.find((shape) => shape.kind === "trace" && shape.points.includes(name));
    return declared ? declared.colour : index;
  }

  /** The whole way of a point, and a dot where it is. */
  trace(name, row) {
    const index = this.points.findIndex((point) => point.name === name);
    const { at } = this.points[index];
    if (!this.paths.has(name)) {
      const path = new Path2D();
      const steps = Math.max(1, Math.floor(times.length / 4000));
      let down = false;
      for (let sample = 0; sample < times.length; sample += steps) {
        const [x, y] = this.pointAt(drawn.subarray(sample * this.width), at);
        if (down) path.lineTo(x, y);
        else if (Number.isFinite(x + y)) path.moveTo(x, y);
        down = Number.isFinite(x + y);
      }
      this.paths.set(name, path);
    }
    const c = this.context;
    const colour = series(this.colourOfTrace(index));
    c.strokeStyle = colour;
    c.lineWidth = 1.6;
    c.globalAlpha = 0.75;
    c.stroke(this.paths.get(name));
    c.globalAlpha = 1;
    this.disc(this.pointAt(row, at), 3.5, colour);
  }

  /** An arrow from the point that a force acts at. */
  vector(vector, place) {
    const row = between(vector.numbers, 2 * DIMENSION, place, new Float64Array(2 * DIMENSION));
    const force = row.subarray(DIMENSION);
    const largest = this.largest[vector.kind];
    if (!row.every(Number.isFinite) || !(largest > 0)) return;
    const length = (0.24 * Math.min(...this.sheet) * this.vectorScale) / largest;
    const from = this.pointAt(row, 0);
    const [right, up] = this.view ? this.view.parts(...force) : force;
    const to = [from[0] + length * right, from[1] - length * up];
    const size = Math.hypot(to[0] - from[0], to[1] - from[1]);
    if (size < 1) return;
    const colour = palette[vector.kind];
    const [dx, dy] = [(to[0] - from[0]) / size, (to[1] - from[1]) / size];
    const head = Math.min(SIZE.arrow, size);
    const neck = [to[0] - head * dx, to[1] - head * dy];
    this.line([from, neck], 2.6, colour);
    this.polygon([to, [neck[0] - 0.45 * head * dy, neck[1] + 0.45 * head * dx], [neck[0] + 0.45 * head * dy, neck[1] - 0.45 * head * dx]], colour, 1, colour);
    this.text(`${vector.label} ${number(Math.hypot(...force), 4)} N`.trim(), [to[0] + 9 * dx, to[1] + 9 * dy], dx < -0.3 ? "right" : dx > 0.3 ? "left" : "center", colour);
  }

  text(text, [x, y], align, colour, size = 13) {
    const c = this.context;
    c.font = `500 ${size}px ${FONT}`;
    c.textAlign = align;
    c.textBaseline = "middle";
    c.lineWidth = 4;
    c.strokeStyle = palette.card;
    c.strokeText(text, x, y);
    c.fillStyle = colour;
    c.fillText(text, x, y);
  }

  names(row, shapes) {
    const seen = new Set(shapes.flatMap((shape) => shape.points));
    const middle = [this.sheet[0] / 2, this.sheet[1] / 2];
    for (const { name, at } of this.points) {
      if (!seen.has(name) || !/^[\p{L}\p{N}_']+$/u.test(name)) continue;
      const [x, y] = this.pointAt(row, at);
      const right = x >= middle[0] - 1;
      const apart = 13 * Math.max(this.unit, 0.8);
      this.text(name, [x + (right ? apart : -apart), y - apart], right ? "left" : "right", palette.ink, 13);
    }
  }

  /** A bar of round length, at the mechanism's middle in space, and where x, y and z point there. */
  drawScale() {
    const scale = this.scale * (this.view ? this.view.zoom : 1);
    if (this.view) this.drawAxes();
    const wanted = (0.2 * this.sheet[0]) / scale;
    const power = 10 ** Math.floor(Math.log10(wanted));
    const length = power * [5, 2, 1].find((digit) => digit * power <= wanted);
    const [x, y] = [16, this.sheet[1] - 16];
    const to = x + length * scale;
    this.line([[x, y - 5], [x, y], [to, y], [to, y - 5]], 1.4, palette.muted);
    const [value, unit] = length >= 1 || length < 1e-6 ? [length, "m"] : [length * 1000, "mm"];
    this.text(`${Number(value.toPrecision(3))} ${unit}`, [(x + to) / 2, y - 11], "center", palette.muted, 12);
  }

  drawAxes() {
    const [x, y] = [this.sheet[0] - 46, 50];
    ["x", "y", "z"].forEach((name, i) => {
      const [right, up] = this.view.parts(...[0, 1, 2].map((j) => (i === j ? 1 : 0)));
      this.line([[x, y], [x + 28 * right, y - 28 * up]], 1.6, palette.muted);
      this.text(name, [x + 38 * right, y - 38 * up], "center", palette.muted, 12);
    });
  }

  /** The name of the point next to a place on the canvas, if one is near. */
  nearest(x, y, time) {
    const row = this.rowAt(locate(time));
    const apart = ({ at }) => {
      const [px, py] = this.pointAt(row, at);
      return Math.hypot(px - x, py - y);
    };
    const best = this.points.map((point) => ({ name: point.name, apart: apart(point) })).sort((a, b) => a.apart - b.apart)[0];
    return best && best.apart < 16 ? best.name : null;
  }
}
