// What the page carries, decoded, and what is computed from it: no drawing here.
"use strict";
const data = JSON.parse(document.getElementById("data").textContent);
const decode = (Type, text) => {
  const bytes = Uint8Array.from(atob(text), (c) => c.charCodeAt(0));
  return new Type(bytes.buffer, 0, bytes.length / Type.BYTES_PER_ELEMENT);
};
const points = decode(Float64Array, data.points);
const pointKind = decode(Uint8Array, data.pointKind);
const corners = decode(Int32Array, data.corners);
const cellKind = decode(Uint8Array, data.cellKind);
const cellFacet = decode(Int32Array, data.cellFacet);
const cellLine = decode(Int32Array, data.cellLine);
const slack = decode(Float64Array, data.slack);
const nearest = decode(Int32Array, data.nearest);
const shift = decode(Float64Array, data.shift);
const lineSets = { segments: decode(Int32Array, data.segments), hanging: decode(Int32Array, data.hanging), rows: decode(Int32Array, data.rows), chew: decode(Int32Array, data.chew) };
const ballVertex = decode(Int32Array, data.ballVertex), ballRadius = decode(Float64Array, data.ballRadius);
const cellCount = cellKind.length, pointCount = pointKind.length;
const pointKinds = ["vertex", "projection", "edge", "offset", "arc", "interior"], cellKinds = ["T", "S", "R", "C"];
const violated = new Set(data.violated);

// The cells by slack: violated ones first, those that nothing can come near last.
const bySlack = Int32Array.from({ length: cellCount }, (_, i) => i);
const key = (i) => (violated.has(i) ? -1e300 + i : Number.isNaN(slack[i]) ? Infinity : slack[i]);
const keys = Float64Array.from(bySlack, (i) => key(i));
bySlack.sort((a, b) => (keys[a] < keys[b] ? -1 : keys[a] > keys[b] ? 1 : a - b));
// The order of drawing, of the slider and of n and p: by slack, or by a lemma's; then those that it does not speak of come last.
const order = new Int32Array(cellCount), rank = new Int32Array(cellCount);
function orderBy(lemma) {
  order.set(lemma ? lemma.cells : bySlack);
  if (lemma) order.set(bySlack.filter((cell) => !lemma.places.has(cell)), lemma.cells.length);
  order.forEach((cell, i) => { rank[cell] = i; });
}
orderBy(undefined);

// Positions for drawing: the whole within the unit ball about the origin.
const low = [Infinity, Infinity, Infinity], high = [-Infinity, -Infinity, -Infinity];
for (let i = 0; i < points.length; ++i) {
  low[i % 3] = Math.min(low[i % 3], points[i]);
  high[i % 3] = Math.max(high[i % 3], points[i]);
}
const middle = pointCount ? low.map((v, k) => v / 2 + high[k] / 2) : [0, 0, 0];
const size = (pointCount && Math.hypot(...high.map((v, k) => v - low[k])) / 2) || 1;
const place = new Float32Array(points.length);
for (let i = 0; i < points.length; ++i) place[i] = (points[i] - middle[i % 3]) / size;

const at = (p) => [points[3 * p], points[3 * p + 1], points[3 * p + 2]];
const minus = (a, b) => [a[0] - b[0], a[1] - b[1], a[2] - b[2]];
const plus = (a, b) => [a[0] + b[0], a[1] + b[1], a[2] + b[2]];
const times = (s, a) => [s * a[0], s * a[1], s * a[2]];
const dot = (a, b) => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
const cross = (a, b) => [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]];
const normalised = (a) => times(1 / (Math.hypot(...a) || 1), a);

// The sphere of a cell, in the input's coordinates.
function sphereOf(cell) {
  const a = at(corners[3 * cell]), u = minus(at(corners[3 * cell + 1]), a), v = minus(at(corners[3 * cell + 2]), a), n = cross(u, v);
  let step = times(1 / (2 * dot(n, n)), plus(times(dot(v, v), cross(n, u)), times(dot(u, u), cross(v, n))));
  if (shift.length) step = plus(step, times(shift[cell], normalised(n)));
  return { centre: plus(a, step), radius: Math.hypot(...step) };
}

// The points nearest to a cell's sphere: [point, relative power], in floating point.
function nearestPoints(cell, count) {
  const { centre, radius } = sphereOf(cell), own = corners.subarray(3 * cell, 3 * cell + 3), best = [];
  for (let p = 0; p < pointCount; ++p) {
    if (own.includes(p)) continue;
    const power = (points[3 * p] - centre[0]) ** 2 + (points[3 * p + 1] - centre[1]) ** 2 + (points[3 * p + 2] - centre[2]) ** 2;
    if (best.length === count && power >= best[count - 1][1]) continue;
    best.push([p, power]);
    best.sort((a, b) => a[1] - b[1] || a[0] - b[0]);
    best.length = Math.min(best.length, count);
  }
  return best.map(([p, square]) => [p, square / radius ** 2 - 1]);
}

// When the strategy's last corner of a cell was placed.
const stageOfPoint = [0, 1, 1, 2, 3, 4];
const stages = ["vertices only", "points on segments", "protectors' points", "arc points", "Chew's points"];
const stageOf = (cell) => Math.max(...[0, 1, 2].map((k) => stageOfPoint[pointKind[corners[3 * cell + k]]]));

// Claimed lemmas: the slack of each cell (NaN: nothing is said of it), and the cells of which something is said, tightest first.
const lemmas = new Map(data.lemmas.map(({ id, slack: text }) => {
  const values = decode(Float64Array, text), cells = [];
  values.forEach((v, cell) => { if (!Number.isNaN(v)) cells.push(cell); });
  cells.sort((a, b) => values[a] - values[b] || a - b);
  const places = new Map(cells.map((cell, i) => [cell, i]));
  return [id, { values, cells, places }];
}));
