// The run: columns of numbers over common times, and numbers between them.

const run = JSON.parse(document.getElementById("run").textContent);

/** Little-endian floats from base64. */
function floats(text, Floats) {
  if (Uint8Array.fromBase64) return new Floats(Uint8Array.fromBase64(text).buffer);
  const letters = atob(text);
  const bytes = new Uint8Array(letters.length);
  for (let i = 0; i < letters.length; i++) bytes[i] = letters.charCodeAt(i);
  return new Floats(bytes.buffer);
}

const times = floats(run.times, Float64Array);
const sampleTimes = times;
const start = times[0];
const end = times[times.length - 1];

// What is shown for a time: itself, or a quantity that changes in proportion to it.
const abscissa = run.abscissa || { name: "t", unit: "s", label: "time [s]", from: start, rate: 1 };
const abscissaAt = (time) => abscissa.from + abscissa.rate * (time - start);
const timeAt = (value) => start + (value - abscissa.from) / abscissa.rate;

for (const column of run.columns) column.values = floats(column.values, Float32Array);
const drawn = floats(run.drawing.numbers, Float32Array);
const arrowTimes = floats(run.vector_times, Float64Array);
for (const vector of run.vectors) vector.numbers = floats(vector.numbers, Float32Array);

/** The last sample not after `time`, and the share of the way to the next. */
function locate(time, times = sampleTimes) {
  let low = 0;
  let high = times.length - 1;
  while (high - low > 1) {
    const middle = (low + high) >> 1;
    if (times[middle] <= time) low = middle;
    else high = middle;
  }
  if (time >= times[high]) return { index: high, share: 0 };
  const span = times[high] - times[low];
  return { index: low, share: span > 0 ? Math.max(0, (time - times[low]) / span) : 0 };
}

/** Numbers of a row of `width` at a place between samples. */
function between(numbers, width, { index, share }, row) {
  const from = index * width;
  const to = share > 0 ? from + width : from;
  for (let i = 0; i < width; i++) row[i] = numbers[from + i] + share * (numbers[to + i] - numbers[from + i]);
  return row;
}

/** The value of a column at a place between samples. */
function valueAt(column, { index, share }) {
  const value = column.values[index];
  return share > 0 ? value + share * (column.values[index + 1] - value) : value;
}
