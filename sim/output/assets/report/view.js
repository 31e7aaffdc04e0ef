// How space is seen: from a place that the reader takes around the mechanism, with z upwards.

class View {
  /** A view of a ball. */
  constructor(centre, radius) {
    this.centre = centre;
    this.radius = radius;
    this.reset();
  }

  /** Where the figures look from, too. */
  reset() {
    [this.azimuth, this.elevation, this.zoom] = [-1.05, 0.4, 1];
  }

  turn(azimuth, elevation) {
    this.azimuth += azimuth;
    this.elevation = Math.min(Math.PI / 2, Math.max(-Math.PI / 2, this.elevation + elevation));
  }

  magnify(factor) {
    this.zoom = Math.min(20, Math.max(0.2, this.zoom * factor));
  }

  /** The parts of a vector to the right, upwards and towards the eye. */
  parts(x, y, z) {
    const [sa, ca, se, ce] = [Math.sin(this.azimuth), Math.cos(this.azimuth), Math.sin(this.elevation), Math.cos(this.elevation)];
    const ahead = ca * x + sa * y;
    return [ca * y - sa * x, ce * z - se * ahead, ce * ahead + se * z];
  }

  /** Where a point is on a sheet through the centre, in metres from there. */
  place(x, y, z) {
    const [right, up, near] = this.parts(x - this.centre[0], y - this.centre[1], z - this.centre[2]);
    const eye = 6 * this.radius;
    const size = (this.zoom * eye) / Math.max(eye - near, 0.1 * eye);
    return [right * size, up * size];
  }

  /** How near the eye a point is. */
  nearness(x, y, z) {
    return this.parts(x, y, z)[2];
  }
}

/** Points of a circle in space by centre, radius and normal. */
function ring([x, y, z], radius, normal) {
  const unit = (v) => v.map((part) => part / Math.hypot(...v));
  const cross = (a, b) => [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]];
  const n = unit(normal);
  const least = n.map(Math.abs).indexOf(Math.min(...n.map(Math.abs)));
  const u = unit(cross(n, [0, 1, 2].map((i) => (i === least ? 1 : 0))));
  const v = cross(n, u);
  return Array.from({ length: 91 }, (_, step) => {
    const [c, s] = [Math.cos((Math.PI * step) / 45), Math.sin((Math.PI * step) / 45)];
    return [x, y, z].map((part, i) => part + radius * (c * u[i] + s * v[i]));
  });
}

/** Lets the reader turn what is drawn on a canvas by dragging, and come nearer by the wheel or two fingers. */
function turnable(canvas, view, changed) {
  canvas.style.touchAction = "none";
  canvas.style.cursor = "grab";
  const fingers = new Map();
  const apart = () => {
    const [a, b] = [...fingers.values()];
    return Math.hypot(a[0] - b[0], a[1] - b[1]);
  };
  canvas.addEventListener("pointerdown", (event) => {
    fingers.set(event.pointerId, [event.clientX, event.clientY]);
    canvas.setPointerCapture(event.pointerId);
  });
  canvas.addEventListener("pointermove", (event) => {
    const before = fingers.get(event.pointerId);
    if (!before) return;
    const width = fingers.size === 2 ? apart() : 0;
    fingers.set(event.pointerId, [event.clientX, event.clientY]);
    if (fingers.size === 2) view.magnify(apart() / width);
    else view.turn((before[0] - event.clientX) / 150, (event.clientY - before[1]) / 150);
    changed();
  });
  for (const end of ["pointerup", "pointercancel"]) canvas.addEventListener(end, (event) => fingers.delete(event.pointerId));
  canvas.addEventListener("wheel", (event) => {
    event.preventDefault();
    view.magnify(Math.exp(-event.deltaY / 500));
    changed();
  }, { passive: false });
}
