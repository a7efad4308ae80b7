/**
 * Simplifies triangles by collapsing edges in the order of their quadric errors (Garland and Heckbert, Surface Simplification Using Quadric
 * Error Metrics, SIGGRAPH 1997). A vertex moves only to a neighbor, so the remaining vertices keep their skin and morph targets.
 *
 * Each pass sorts all edges once and collapses each vertex at most once, instead of keeping a heap: a mesh of 300,000 triangles takes 12
 * passes. A collapse that would turn a face over, make it a sliver, or pinch the surface, is left out: slivers have normals of rounding
 * errors, and so edges that look like creases. If none remains, as for leaves that hang together
 * nowhere, these rules are dropped, so that the smallest parts vanish first.
 *
 * @param triangles Three vertices per triangle.
 * @param positions Three numbers per vertex.
 * @param most Maximum number of triangles that remain.
 */
export function simplify(triangles: Uint32Array, positions: Float32Array, most: number): Uint32Array {
  const quadrics = quadricsOf(triangles, positions);
  let left = triangles;
  let isStrict = true;
  while (left.length > most * 3) {
    const fewer = collapseOnce(left, positions, quadrics, left.length / 3 - most, isStrict);
    // Passes that hardly change anything would never end.
    if (fewer.length > left.length * 0.99) isStrict = false;
    left = fewer;
  }
  return left;
}

/** Whether an edge of the triangles has no face on its other side. */
export function hasBorder(triangles: Uint32Array, vertexCount: number): boolean {
  const fan = fansOf(triangles, vertexCount);
  for (let i = 0; i < triangles.length; i++) if (!hasHalfEdge(triangles, fan, endOf(triangles, i), triangles[i] ?? 0)) return true;
  return false;
}

/** The vertex after a corner in its triangle. */
function endOf(triangles: Uint32Array, corner: number): number {
  return triangles[corner % 3 === 2 ? corner - 2 : corner + 1] ?? 0;
}

/** Numbers of a symmetric 4 × 4 matrix: xx, xy, xz, xw, yy, yz, yw, zz, zw, ww. */
const PARTS = 10;

/** Weight of the plane that holds a border in its place, relative to the square of the length of the border. */
const BORDER_WEIGHT = 10;

/** The least cosine between the normals of a face before and after a collapse. */
const LEAST_TURN = 0.25;

/** Twice the area relative to the square of the longest side, below which a face is a sliver. */
const SLIVER = 0.1;

/** Weight of the length of an edge in its error, to the fourth power as areas times squared distances: in planes, short edges go first. */
const LENGTH_WEIGHT = 1e-5;

type Triple = [number, number, number];

// Valid within one call.
const scratchNormal: Triple = [0, 0, 0];
const scratchMoved: Triple = [0, 0, 0];

function quadricsOf(triangles: Uint32Array, positions: Float32Array): Float64Array {
  const quadrics = new Float64Array((positions.length / 3) * PARTS);
  const fan = fansOf(triangles, positions.length / 3);
  const along: Triple = [0, 0, 0];
  for (let t = 0; t < triangles.length; t += 3) {
    const corners: Triple = [triangles[t] ?? 0, triangles[t + 1] ?? 0, triangles[t + 2] ?? 0];
    const area = normalOf(positions, ...corners, scratchNormal) / 2;
    for (const corner of corners) addPlane(quadrics, corner, scratchNormal, positions, corners[0], area);
    for (let c = 0; c < 3; c++) {
      const from = corners[c] ?? 0;
      const to = corners[(c + 1) % 3] ?? 0;
      if (hasHalfEdge(triangles, fan, to, from)) continue;
      for (let i = 0; i < 3; i++) along[i] = (positions[to * 3 + i] ?? 0) - (positions[from * 3 + i] ?? 0);
      const upright = cross(along, scratchNormal, scratchMoved);
      const squared = along[0] ** 2 + along[1] ** 2 + along[2] ** 2;
      if (upright === 0) continue;
      for (const corner of [from, to]) addPlane(quadrics, corner, scratchMoved, positions, from, BORDER_WEIGHT * squared);
    }
  }
  return quadrics;
}

/** Adds the plane through a point with a unit normal to the quadric of a vertex. */
function addPlane(quadrics: Float64Array, vertex: number, [x, y, z]: Triple, positions: Float32Array, point: number, weight: number): void {
  const at = point * 3;
  const w = -(x * (positions[at] ?? 0) + y * (positions[at + 1] ?? 0) + z * (positions[at + 2] ?? 0));
  const planes = [x * x, x * y, x * z, x * w, y * y, y * z, y * w, z * z, z * w, w * w];
  for (let i = 0; i < PARTS; i++) quadrics[vertex * PARTS + i] = (quadrics[vertex * PARTS + i] ?? 0) + weight * (planes[i] ?? 0);
}

/** Weighted squares of the distances from a position to the planes of a quadric. */
function errorAt(quadrics: Float64Array, vertex: number, positions: Float32Array, position: number): number {
  const x = positions[position * 3] ?? 0;
  const y = positions[position * 3 + 1] ?? 0;
  const z = positions[position * 3 + 2] ?? 0;
  const q = vertex * PARTS;
  const part = (i: number): number => quadrics[q + i] ?? 0;
  const error =
    part(0) * x * x +
    2 * (part(1) * x * y + part(2) * x * z + part(3) * x) +
    part(4) * y * y +
    2 * (part(5) * y * z + part(6) * y) +
    part(7) * z * z +
    2 * part(8) * z +
    part(9);
  // Rounding may make it negative.
  return Math.max(error, 0);
}

/** The triangles at each vertex: those of vertex i are in `triangles` from `start[i]` to before `start[i + 1]`, as offsets of their corners. */
interface Fans {
  readonly start: Uint32Array;
  readonly triangles: Uint32Array;
}

function fansOf(triangles: Uint32Array, count: number): Fans {
  const start = new Uint32Array(count + 1);
  for (const vertex of triangles) start[vertex + 1] = (start[vertex + 1] ?? 0) + 1;
  for (let i = 0; i < count; i++) start[i + 1] = (start[i + 1] ?? 0) + (start[i] ?? 0);
  const next = start.slice();
  const all = new Uint32Array(triangles.length);
  for (let i = 0; i < triangles.length; i++) {
    const vertex = triangles[i] ?? 0;
    const place = next[vertex] ?? 0;
    all[place] = i - (i % 3);
    next[vertex] = place + 1;
  }
  return { start, triangles: all };
}

/** Whether a triangle runs from one vertex to the other. */
function hasHalfEdge(triangles: Uint32Array, fan: Fans, from: number, to: number): boolean {
  for (let i = fan.start[from] ?? 0; i < (fan.start[from + 1] ?? 0); i++) {
    const t = fan.triangles[i] ?? 0;
    const corner = triangles[t] === from ? 0 : triangles[t + 1] === from ? 1 : 2;
    if (triangles[t + ((corner + 1) % 3)] === to) return true;
  }
  return false;
}

/** Collapses the edges with the smallest errors, each vertex at most once, until `wanted` triangles are gone. Returns the others. */
function collapseOnce(
  triangles: Uint32Array,
  positions: Float32Array,
  quadrics: Float64Array,
  wanted: number,
  isStrict: boolean,
): Uint32Array {
  const count = positions.length / 3;
  const fan = fansOf(triangles, count);
  const isBorder = new Uint8Array(count);
  const open: boolean[] = [];
  const errors = new Float32Array(triangles.length);
  for (let i = 0; i < triangles.length; i++) {
    const from = triangles[i] ?? 0;
    const to = endOf(triangles, i);
    if (!hasHalfEdge(triangles, fan, to, from)) {
      isBorder[from] = 1;
      isBorder[to] = 1;
      open[i] = true;
    }
    const error = errorAt(quadrics, from, positions, to) + errorAt(quadrics, to, positions, to);
    errors[i] = error + LENGTH_WEIGHT * squaredLength(positions, from, to) ** 2 || 0;
  }
  const onto = Uint32Array.from({ length: count }, (_, i) => i);
  const isTaken = new Uint8Array(count);
  const marks = new Uint32Array(count);
  let mark = 1;
  let gone = 0;
  for (const i of sorted(errors)) {
    if (gone >= wanted) break;
    const from = triangles[i] ?? 0;
    const to = endOf(triangles, i);
    if (isTaken[from] || isTaken[to]) continue;
    if (isStrict) {
      // A border keeps its place, and a surface does not grow together with it.
      if (isBorder[from] && !open[i]) continue;
      mark += 2;
      if (pinches(triangles, fan, onto, from, to, marks, mark) || turns(triangles, fan, positions, onto, from, to)) continue;
    }
    onto[from] = to;
    isTaken[from] = 1;
    isTaken[to] = 1;
    for (let part = 0; part < PARTS; part++)
      quadrics[to * PARTS + part] = (quadrics[to * PARTS + part] ?? 0) + (quadrics[from * PARTS + part] ?? 0);
    gone += open[i] ? 1 : 2;
  }
  const left: number[] = [];
  for (let t = 0; t < triangles.length; t += 3) {
    const [a, b, c] = [onto[triangles[t] ?? 0] ?? 0, onto[triangles[t + 1] ?? 0] ?? 0, onto[triangles[t + 2] ?? 0] ?? 0];
    if (a !== b && b !== c && c !== a) left.push(a, b, c);
  }
  return Uint32Array.from(left);
}

/** Indices in the order of their values, which are not negative: sorted by the upper bits of the numbers. */
function sorted(values: Float32Array): Uint32Array {
  const bits = new Uint32Array(values.buffer, values.byteOffset, values.length);
  const start = new Uint32Array(2 ** 15 + 1);
  const bucket = (i: number): number => (bits[i] ?? 0) >>> 16;
  for (let i = 0; i < bits.length; i++) start[bucket(i) + 1] = (start[bucket(i) + 1] ?? 0) + 1;
  for (let i = 0; i < 2 ** 15; i++) start[i + 1] = (start[i + 1] ?? 0) + (start[i] ?? 0);
  const order = new Uint32Array(bits.length);
  for (let i = 0; i < bits.length; i++) {
    const place = start[bucket(i)] ?? 0;
    order[place] = i;
    start[bucket(i)] = place + 1;
  }
  return order;
}

/**
 * Whether two vertices have more common neighbors than common faces: then their collapse would lay two parts of the surface onto each other.
 *
 * @param marks A number per vertex, changed by this function; no vertex has `mark` or the next number before the call.
 */
function pinches(
  triangles: Uint32Array,
  fan: Fans,
  onto: Uint32Array,
  from: number,
  to: number,
  marks: Uint32Array,
  mark: number,
): boolean {
  let shared = 0;
  for (let i = fan.start[from] ?? 0; i < (fan.start[from + 1] ?? 0); i++) {
    const t = fan.triangles[i] ?? 0;
    for (let c = 0; c < 3; c++) {
      const other = onto[triangles[t + c] ?? 0] ?? 0;
      marks[other] = mark;
      if (other === to) shared++;
    }
  }
  marks[from] = 0;
  marks[to] = 0;
  let common = 0;
  for (let i = fan.start[to] ?? 0; i < (fan.start[to + 1] ?? 0); i++) {
    const t = fan.triangles[i] ?? 0;
    for (let c = 0; c < 3; c++) {
      const other = onto[triangles[t + c] ?? 0] ?? 0;
      if (marks[other] !== mark) continue;
      marks[other] = mark + 1;
      common++;
    }
  }
  return common > shared;
}

/** Whether a face at a vertex would turn too far, or become a sliver, if the vertex moved onto another. */
function turns(triangles: Uint32Array, fan: Fans, positions: Float32Array, onto: Uint32Array, from: number, to: number): boolean {
  for (let i = fan.start[from] ?? 0; i < (fan.start[from + 1] ?? 0); i++) {
    const t = fan.triangles[i] ?? 0;
    const a = onto[triangles[t] ?? 0] ?? 0;
    const b = onto[triangles[t + 1] ?? 0] ?? 0;
    const c = onto[triangles[t + 2] ?? 0] ?? 0;
    // Faces that vanish cannot turn.
    if (a === to || b === to || c === to || a === b || b === c || c === a) continue;
    const area = normalOf(positions, a, b, c, scratchNormal);
    const [d, e, f] = [a === from ? to : a, b === from ? to : b, c === from ? to : c];
    const moved = normalOf(positions, d, e, f, scratchMoved);
    const thin = SLIVER * longest(positions, d, e, f);
    if (moved < thin && moved * longest(positions, a, b, c) <= area * longest(positions, d, e, f)) return true;
    const cosine = scratchNormal[0] * scratchMoved[0] + scratchNormal[1] * scratchMoved[1] + scratchNormal[2] * scratchMoved[2];
    if (area > 0 && cosine < LEAST_TURN) return true;
  }
  return false;
}

function squaredLength(positions: Float32Array, a: number, b: number): number {
  let sum = 0;
  for (let axis = 0; axis < 3; axis++) sum += ((positions[a * 3 + axis] ?? 0) - (positions[b * 3 + axis] ?? 0)) ** 2;
  return sum;
}

/** The square of the longest side of a triangle. */
function longest(positions: Float32Array, a: number, b: number, c: number): number {
  return Math.max(squaredLength(positions, a, b), squaredLength(positions, b, c), squaredLength(positions, c, a));
}

/** Sets the unit normal of a triangle and returns twice its area. */
function normalOf(positions: Float32Array, a: number, b: number, c: number, into: Triple): number {
  const from = (i: number, vertex: number): number => (positions[vertex * 3 + i] ?? 0) - (positions[a * 3 + i] ?? 0);
  return cross([from(0, b), from(1, b), from(2, b)], [from(0, c), from(1, c), from(2, c)], into);
}

/** Sets the unit vector along the cross product, 0 if there is none, and returns its length. */
function cross(a: Triple, b: Triple, into: Triple): number {
  const x = a[1] * b[2] - a[2] * b[1];
  const y = a[2] * b[0] - a[0] * b[2];
  const z = a[0] * b[1] - a[1] * b[0];
  const length = Math.hypot(x, y, z);
  const scale = length > 0 ? 1 / length : 0;
  into[0] = x * scale;
  into[1] = y * scale;
  into[2] = z * scale;
  return length;
}
