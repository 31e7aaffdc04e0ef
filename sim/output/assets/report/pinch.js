// Zooming curves by two fingers, on glass or on a touchpad.

/** A range of time in which two places show what two others showed before. */
function pinched([from, to], before, after) {
  const apart = Math.max(Math.abs(after[1] - after[0]), 0.02) * Math.sign(after[1] - after[0] || 1);
  const factor = (before[1] - before[0]) / apart;
  const min = from + (before[0] - after[0] * factor) * (to - from);
  return { min, max: min + factor * (to - from) };
}

/** Two fingers move and zoom what is below them; the touchpad's pinch, which is a wheel with Ctrl, zooms about the pointer. */
function pinchable(over) {
  const touches = new Map();
  const share = (event) => (event.clientX - over.getBoundingClientRect().left) / over.clientWidth;
  const range = () => (zoom ? [zoom.min, zoom.max] : [start, end]);
  over.addEventListener("pointerdown", (event) => event.pointerType === "touch" && touches.set(event.pointerId, share(event)));
  over.addEventListener("pointermove", (event) => {
    if (!touches.has(event.pointerId)) return;
    const before = [...touches.values()];
    touches.set(event.pointerId, share(event));
    if (touches.size === 2) zoomTo(pinched(range(), before, [...touches.values()]));
  });
  for (const lifted of ["pointerup", "pointercancel"]) over.addEventListener(lifted, (event) => touches.delete(event.pointerId));
  over.addEventListener("wheel", (event) => {
    if (!event.ctrlKey) return;
    event.preventDefault();
    const [from, to] = range();
    const [at, factor] = [share(event), Math.exp(0.01 * event.deltaY)];
    const min = from + at * (1 - factor) * (to - from);
    zoomTo({ min, max: min + factor * (to - from) });
  }, { passive: false });
}
