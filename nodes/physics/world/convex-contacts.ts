import { Vec3 } from 'cannon-es';
import type { ContactList } from './contact.ts';
import type { HullEdge, HullFace, HullShape } from './hull-shape.ts';
import type { RigidBody } from './rigid-body.ts';

/** An edge pair is chosen over a face only if it is better by this much; otherwise resting boxes would alternate between both. */
const EDGE_BIAS_M = 5e-4;
const MAX_POINTS = 4;

/** A point of a contact polygon with its distance from the reference face. */
interface ClipPoint {
  x: number;
  y: number;
  z: number;
  gapM: number;
}

// Filled and read within one call.
const scratchCross = new Vec3();
const scratchP = new Vec3();
const scratchQ = new Vec3();
let polygon: ClipPoint[] = [];
let clipped: ClipPoint[] = [];
const pool: ClipPoint[] = [];
let pooled = 0;
const chosen: ClipPoint[] = [];

/**
 * Contacts of two convex polyhedra by the separating-axis test over faces and those edge pairs that form a face of the Minkowski
 * difference (Gregorius, “The Separating Axis Test between Convex Polyhedra”, GDC 2013). A face contact has up to four points.
 *
 * @param marginM Polyhedra that are farther apart have no contacts.
 */
export function collideHulls(a: RigidBody, hullA: HullShape, b: RigidBody, hullB: HullShape, marginM: number, out: ContactList): void {
  const faceA = bestFace(hullA, hullB);
  const gapA = bestGapM;
  if (!faceA || gapA > marginM) return;
  const faceB = bestFace(hullB, hullA);
  const gapB = bestGapM;
  if (!faceB || gapB > marginM) return;
  const edgeGapM = bestEdgePair(hullA, hullB);
  if (edgeGapM > marginM) return;
  if (bestEdgeA && bestEdgeB && edgeGapM > Math.max(gapA, gapB) + EDGE_BIAS_M) {
    const { x, y, z } = edgeNormal;
    closestPoints(bestEdgeA, bestEdgeB);
    out.add(a, b, scratchP.x, scratchP.y, scratchP.z, x, y, z, edgeGapM);
    return;
  }
  // The same face as long as both are about as good.
  if (gapA >= gapB - EDGE_BIAS_M) addFaceContacts(a, faceA, b, hullB, false, marginM, out);
  else addFaceContacts(b, faceB, a, hullA, true, marginM, out);
}

let bestGapM = 0;

/** Finds the face of `hull` in front of which `other` is farthest away, and writes that distance to `bestGapM`. */
function bestFace(hull: HullShape, other: HullShape): HullFace | null {
  let best: HullFace | null = null;
  bestGapM = Number.NEGATIVE_INFINITY;
  for (const face of hull.faces) {
    const { normal } = face;
    let least = Number.POSITIVE_INFINITY;
    for (const { x, y, z } of other.vertices) {
      const d = normal.x * x + normal.y * y + normal.z * z;
      if (d < least) least = d;
    }
    const gapM = least - face.offset;
    if (gapM > bestGapM) {
      bestGapM = gapM;
      best = face;
    }
  }
  return best;
}

let bestEdgeA: HullEdge | null = null;
let bestEdgeB: HullEdge | null = null;
const edgeNormal = new Vec3();

function bestEdgePair(hullA: HullShape, hullB: HullShape): number {
  let best = Number.NEGATIVE_INFINITY;
  bestEdgeA = null;
  bestEdgeB = null;
  for (const edgeA of hullA.edges) {
    const a = edgeA.left.normal;
    const b = edgeA.right.normal;
    // Direction of the edge up to its length: b × a.
    const bax = b.y * a.z - b.z * a.y;
    const bay = b.z * a.x - b.x * a.z;
    const baz = b.x * a.y - b.y * a.x;
    for (const edgeB of hullB.edges) {
      const c = edgeB.left.normal;
      const d = edgeB.right.normal;
      // The arcs of both edges cross on the Gauss map of the difference, where the normals of b are reversed.
      const cba = -(c.x * bax + c.y * bay + c.z * baz);
      const dba = -(d.x * bax + d.y * bay + d.z * baz);
      if (cba * dba >= 0) continue;
      const dcx = d.y * c.z - d.z * c.y;
      const dcy = d.z * c.x - d.x * c.z;
      const dcz = d.x * c.y - d.y * c.x;
      const adc = a.x * dcx + a.y * dcy + a.z * dcz;
      const bdc = b.x * dcx + b.y * dcy + b.z * dcz;
      if (adc * bdc >= 0 || cba * bdc <= 0) continue;
      edgeA.to.vsub(edgeA.from, scratchP);
      edgeB.to.vsub(edgeB.from, scratchQ);
      scratchP.cross(scratchQ, scratchCross);
      const length = scratchCross.length();
      // Nearly parallel edges: a face tells more.
      if (length < 1e-3 * scratchP.length() * scratchQ.length()) continue;
      scratchCross.scale(1 / length, scratchCross);
      const { from } = edgeA;
      const { center } = hullA;
      let { x, y, z } = scratchCross;
      if (x * (from.x - center.x) + y * (from.y - center.y) + z * (from.z - center.z) < 0) {
        x = -x;
        y = -y;
        z = -z;
      }
      const gapM = x * (edgeB.from.x - from.x) + y * (edgeB.from.y - from.y) + z * (edgeB.from.z - from.z);
      if (gapM <= best) continue;
      best = gapM;
      bestEdgeA = edgeA;
      bestEdgeB = edgeB;
      edgeNormal.set(x, y, z);
    }
  }
  return best;
}

/** Writes the points at which two lines are closest to `scratchP` (on a) and `scratchQ` (on b). */
function closestPoints(a: HullEdge, b: HullEdge): void {
  const ux = a.to.x - a.from.x;
  const uy = a.to.y - a.from.y;
  const uz = a.to.z - a.from.z;
  const vx = b.to.x - b.from.x;
  const vy = b.to.y - b.from.y;
  const vz = b.to.z - b.from.z;
  const wx = a.from.x - b.from.x;
  const wy = a.from.y - b.from.y;
  const wz = a.from.z - b.from.z;
  const uu = ux * ux + uy * uy + uz * uz;
  const uv = ux * vx + uy * vy + uz * vz;
  const vv = vx * vx + vy * vy + vz * vz;
  const uw = ux * wx + uy * wy + uz * wz;
  const vw = vx * wx + vy * wy + vz * wz;
  const determinant = uu * vv - uv * uv;
  const s = determinant > 0 ? clamp01((uv * vw - vv * uw) / determinant) : 0.5;
  const t = determinant > 0 ? clamp01((uu * vw - uv * uw) / determinant) : 0.5;
  scratchP.set(a.from.x + s * ux, a.from.y + s * uy, a.from.z + s * uz);
  scratchQ.set(b.from.x + t * vx, b.from.y + t * vy, b.from.z + t * vz);
}

function clamp01(x: number): number {
  return Math.min(Math.max(x, 0), 1);
}

/**
 * Adds the contacts of two faces: clips the face of `other` that faces `reference` against the sides of `reference`.
 *
 * @param deepestM Points that are deeper behind `reference` have no contact.
 */
export function addFaceContacts(
  owner: RigidBody,
  reference: HullFace,
  other: RigidBody,
  otherHull: HullShape,
  isReversed: boolean,
  marginM: number,
  out: ContactList,
  deepestM = Number.POSITIVE_INFINITY,
): void {
  const n = reference.normal;
  const incident = opposite(otherHull, n);
  if (!incident) return;
  pooled = 0;
  polygon.length = 0;
  for (const { x, y, z } of incident.corners) polygon.push(clipPoint(x, y, z));
  const { corners } = reference;
  for (let i = 0; i < corners.length && polygon.length > 0; i++) {
    const from = corners[i];
    const to = corners[(i + 1) % corners.length];
    if (!from || !to) continue;
    // The plane through the edge, along the normal, with its normal outwards.
    const px = (to.y - from.y) * n.z - (to.z - from.z) * n.y;
    const py = (to.z - from.z) * n.x - (to.x - from.x) * n.z;
    const pz = (to.x - from.x) * n.y - (to.y - from.y) * n.x;
    clip(px, py, pz, px * from.x + py * from.y + pz * from.z);
  }
  let count = 0;
  for (const point of polygon) {
    point.gapM = point.x * n.x + point.y * n.y + point.z * n.z - reference.offset;
    if (point.gapM <= marginM && point.gapM >= -deepestM) polygon[count++] = point;
  }
  polygon.length = count;
  choosePoints(n);
  for (const { x, y, z, gapM } of chosen) {
    if (isReversed) out.add(other, owner, x, y, z, -n.x, -n.y, -n.z, gapM);
    else out.add(owner, other, x - gapM * n.x, y - gapM * n.y, z - gapM * n.z, n.x, n.y, n.z, gapM);
  }
}

function opposite(hull: HullShape, normal: Vec3): HullFace | null {
  let best: HullFace | null = null;
  let least = Number.POSITIVE_INFINITY;
  for (const face of hull.faces) {
    const d = face.normal.dot(normal);
    if (d < least) {
      least = d;
      best = face;
    }
  }
  return best;
}

function clipPoint(x: number, y: number, z: number): ClipPoint {
  let point = pool[pooled++];
  if (!point) {
    point = { x, y, z, gapM: 0 };
    pool.push(point);
  }
  point.x = x;
  point.y = y;
  point.z = z;
  return point;
}

/** Keeps the part of the polygon with p · x ≤ offset (Sutherland and Hodgman, 1974). */
function clip(px: number, py: number, pz: number, offset: number): void {
  clipped.length = 0;
  let before = polygon[polygon.length - 1];
  if (!before) return;
  let beforeM = px * before.x + py * before.y + pz * before.z - offset;
  for (const point of polygon) {
    const m = px * point.x + py * point.y + pz * point.z - offset;
    if (beforeM <= 0 !== m <= 0) {
      const t = beforeM / (beforeM - m);
      clipped.push(
        clipPoint(before.x + t * (point.x - before.x), before.y + t * (point.y - before.y), before.z + t * (point.z - before.z)),
      );
    }
    if (m <= 0) clipped.push(point);
    before = point;
    beforeM = m;
  }
  [polygon, clipped] = [clipped, polygon];
}

/**
 * Reduces the polygon to at most four points: the deepest, the one farthest from it, and those that span the largest area to both sides.
 */
function choosePoints(n: Vec3): void {
  chosen.length = 0;
  if (polygon.length <= MAX_POINTS) {
    chosen.push(...polygon);
    return;
  }
  const deepest = most((p) => -p.gapM);
  if (!deepest) return;
  const far = most((p) => (p.x - deepest.x) ** 2 + (p.y - deepest.y) ** 2 + (p.z - deepest.z) ** 2);
  if (!far) return;
  const ex = far.x - deepest.x;
  const ey = far.y - deepest.y;
  const ez = far.z - deepest.z;
  const side = (p: ClipPoint): number => {
    const qx = p.x - deepest.x;
    const qy = p.y - deepest.y;
    const qz = p.z - deepest.z;
    return n.x * (ey * qz - ez * qy) + n.y * (ez * qx - ex * qz) + n.z * (ex * qy - ey * qx);
  };
  const left = most(side);
  const right = most((p) => -side(p));
  chosen.push(deepest, far);
  if (left && side(left) > 0) chosen.push(left);
  if (right && side(right) < 0) chosen.push(right);
}

function most(value: (point: ClipPoint) => number): ClipPoint | null {
  let best: ClipPoint | null = null;
  let highest = Number.NEGATIVE_INFINITY;
  for (const point of polygon) {
    const v = value(point);
    if (v > highest) {
      highest = v;
      best = point;
    }
  }
  return best;
}
