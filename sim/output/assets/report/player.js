// Time: played, scrubbed, or looked at for a moment.

const SPEEDS = [1e-5, 2e-5, 5e-5, 1e-4, 2e-4, 5e-4, 0.001, 0.002, 0.005, 0.01, 0.02, 0.05, 0.1, 0.2, 0.5, 1, 2, 5, 10, 20, 50, 100, 1000];

const player = {
  ready: false,
  time: start,
  playing: false,
  repeat: true,
  speed: 1,
  looked: null,
  before: null,
  asked: false,
  /** What is done with each time shown. */
  shows: [],

  /** The time that everything shows. */
  shown() {
    return this.looked ?? this.time;
  },

  /** Goes to a time. */
  seek(time) {
    this.looked = null;
    this.time = Math.min(end, Math.max(start, time));
    this.refresh();
  },

  /** Shows a time until told otherwise, while nothing plays. */
  preview(time) {
    if (this.playing) return;
    this.looked = time;
    this.refresh();
  },

  /** To a neighbouring sample. */
  step(samples) {
    this.pause();
    const { index, share } = locate(this.time);
    let next = samples < 0 && share > 0 ? index : index + samples;
    // Events that change something have two samples at their time.
    while (samples < 0 && next > 0 && times[next] >= this.time) next -= 1;
    this.seek(times[Math.min(times.length - 1, Math.max(0, next))]);
  },

  play() {
    if (!(end > start)) return;
    if (this.time >= end) this.time = start;
    this.looked = null;
    this.playing = true;
    this.before = null;
    this.changed();
    requestAnimationFrame((now) => this.tick(now));
  },

  pause() {
    this.playing = false;
    this.changed();
  },

  toggle() {
    if (this.playing) this.pause();
    else this.play();
  },

  tick(now) {
    if (!this.playing) return;
    // A page that was in the background goes on where it was.
    if (this.before !== null) this.time += Math.min(0.1, (now - this.before) / 1000) * this.speed;
    this.before = now;
    if (this.time > end) {
      if (this.repeat) this.time = start + ((this.time - start) % (end - start));
      else {
        this.time = end;
        this.pause();
      }
    }
    this.render();
    requestAnimationFrame((next) => this.tick(next));
  },

  /** Shows the time again, once before the next frame. */
  refresh() {
    if (this.asked || this.playing) return;
    this.asked = true;
    requestAnimationFrame(() => {
      this.asked = false;
      this.render();
    });
  },

  render() {
    const time = this.shown();
    for (const show of this.shows) show(time);
  },

  changed() {
    document.getElementById("stage").classList.toggle("playing", this.playing);
    document.getElementById("play").setAttribute("aria-label", this.playing ? "Pause" : "Play");
  },
};

/** The speed at which the run, or its period, is seen in some four to ten seconds; real time if that is near. */
function fittingSpeed() {
  const span = run.period || end - start;
  const wanted = span / (run.period ? 3 : 6);
  if (wanted > 0.18 && wanted < 4) return 1;
  return SPEEDS.reduce((best, speed) => (Math.abs(Math.log(speed / wanted)) < Math.abs(Math.log(best / wanted)) ? speed : best));
}
