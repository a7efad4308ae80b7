import { Vector3 } from 'three';
import type { MeshShape } from '../../volumes/mesh-shape.ts';
import { solve } from './solve.ts';
import { type TangentFrames, turnBetween } from './tangent-frames.ts';

/** Curvature of a mesh at its vertices, in one per unit of the mesh, positive where it is convex. */
export interface Curvature {
  /** Unit principal directions, three numbers each; the first is that of the curvature that is larger without its sign. */
  readonly first: Float64Array;
  readonly second: Float64Array;
  /** Principal curvatures. */
  readonly k1: Float64Array;
  readonly k2: Float64Array;
  /** Four numbers per vertex: how the curvature changes, in the frame of the principal directions: uuu, uuv, uvv, vvv. */
  readonly change: Float64Array;
}

const [t, b, n, own, u, v] = Array.from({ length: 6 }, () => new Vector3()) as [Vector3, Vector3, Vector3, Vector3, Vector3, Vector3];
const edges = [new Vector3(), new Vector3(), new Vector3()] as const;
const difference = new Vector3();

/**
 * Computes the curvature tensors of a mesh and their derivatives by least squares over the edges of each triangle, averaged at the vertices
 * by area: Rusinkiewicz, Estimating Curvatures and Their Derivatives on Triangle Meshes, 3DPVT 2004.
 *
 * @param positions Three numbers per welded vertex, in units of the mesh.
 */
export function curvatureOf({ triangles }: MeshShape, positions: Float32Array, frames: TangentFrames): Curvature {
  const count = positions.length / 3;
  const { normals, tangents, bitangents, areas, cornerAreas } = frames;
  // uu, uv, vv in the frame of each vertex.
  const tensors = new Float64Array(count * 3);
  eachTriangle(triangles, positions, (vertices, i) => {
    const rows: number[][] = [[], [], []];
    const sums = [0, 0, 0];
    let [uu, uv, vv] = [0, 0, 0];
    for (let k = 0; k < 3; k++) {
      const edge = edges[k] ?? t;
      const [from, to] = [vertices[(k + 1) % 3] ?? 0, vertices[(k + 2) % 3] ?? 0];
      difference.fromArray(normals, to * 3).sub(own.fromArray(normals, from * 3));
      const [x, y] = [edge.dot(t), edge.dot(b)];
      const [dx, dy] = [difference.dot(t), difference.dot(b)];
      uu += x * x;
      uv += x * y;
      vv += y * y;
      sums[0] = (sums[0] ?? 0) + dx * x;
      sums[1] = (sums[1] ?? 0) + dx * y + dy * x;
      sums[2] = (sums[2] ?? 0) + dy * y;
    }
    rows[0] = [uu, uv, 0];
    rows[1] = [uv, uu + vv, uv];
    rows[2] = [0, uv, vv];
    const tensor = solve(rows, sums);
    if (!tensor) return;
    for (let k = 0; k < 3; k++) {
      const vertex = vertices[k] ?? 0;
      const weight = (cornerAreas[i + k] ?? 0) / (areas[vertex] || 1);
      frameAt(vertex, normals, tangents, bitangents);
      const [a, c] = [inFace(u), inFace(v)];
      accumulate(tensors, vertex * 3, [quadratic(tensor, a, a), quadratic(tensor, a, c), quadratic(tensor, c, c)], weight);
    }
  });
  const curvature: Curvature = {
    first: new Float64Array(count * 3),
    second: new Float64Array(count * 3),
    k1: new Float64Array(count),
    k2: new Float64Array(count),
    change: new Float64Array(count * 4),
  };
  for (let vertex = 0; vertex < count; vertex++) diagonalize(vertex, tensors, frames, curvature);
  addChanges(triangles, positions, frames, curvature);
  return curvature;
}

/** Calls `visit` for each triangle with an area, with its frame in `t`, `b`, `n`. Edge k is opposite to corner k. */
function eachTriangle(triangles: Uint32Array, positions: Float32Array, visit: (vertices: readonly number[], first: number) => void): void {
  for (let i = 0; i < triangles.length; i += 3) {
    const vertices = [triangles[i] ?? 0, triangles[i + 1] ?? 0, triangles[i + 2] ?? 0];
    for (let k = 0; k < 3; k++) {
      const [from, to] = [vertices[(k + 1) % 3] ?? 0, vertices[(k + 2) % 3] ?? 0];
      edges[k]?.fromArray(positions, to * 3).sub(own.fromArray(positions, from * 3));
    }
    t.copy(edges[0]).normalize();
    n.crossVectors(edges[0], edges[1]);
    if (n.lengthSq() === 0) continue;
    n.normalize();
    b.crossVectors(n, t);
    visit(vertices, i);
  }
}

/** Puts the frame of a vertex, turned into the plane of the triangle, into `u` and `v`. */
function frameAt(vertex: number, normals: Float64Array, firsts: Float64Array, seconds: Float64Array): void {
  own.fromArray(normals, vertex * 3);
  // A triangle and the same one that is seen from the other side have one plane and one curvature.
  if (own.dot(n) < 0) own.negate();
  turnBetween(u.fromArray(firsts, vertex * 3), own, n);
  turnBetween(v.fromArray(seconds, vertex * 3), own, n);
}

const inFace = (vector: Vector3): readonly [number, number] => [vector.dot(t), vector.dot(b)];

function quadratic(
  [uu = 0, uv = 0, vv = 0]: readonly number[],
  [x, y]: readonly [number, number],
  [p, q]: readonly [number, number],
): number {
  return uu * x * p + uv * (x * q + y * p) + vv * y * q;
}

function accumulate(into: Float64Array, at: number, values: readonly number[], weight: number): void {
  for (const [c, value] of values.entries()) into[at + c] = (into[at + c] ?? 0) + value * weight;
}

function diagonalize(vertex: number, tensors: Float64Array, { tangents, bitangents }: TangentFrames, into: Curvature): void {
  const [uu = 0, uv = 0, vv = 0] = tensors.subarray(vertex * 3, vertex * 3 + 3);
  const middle = (uu + vv) / 2;
  const apart = Math.hypot((uu - vv) / 2, uv);
  // The angle of the larger curvature; that of the smaller one is a right angle farther.
  const larger = Math.atan2(uv, (uu - vv) / 2) / 2;
  const angle = middle >= 0 ? larger : larger + Math.PI / 2;
  into.k1[vertex] = middle >= 0 ? middle + apart : middle - apart;
  into.k2[vertex] = middle >= 0 ? middle - apart : middle + apart;
  const [cosine, sine] = [Math.cos(angle), Math.sin(angle)];
  u.fromArray(tangents, vertex * 3);
  v.fromArray(bitangents, vertex * 3);
  own
    .copy(u)
    .multiplyScalar(cosine)
    .addScaledVector(v, sine)
    .toArray(into.first, vertex * 3);
  own
    .copy(v)
    .multiplyScalar(cosine)
    .addScaledVector(u, -sine)
    .toArray(into.second, vertex * 3);
}

/** Section 4 of the paper: the same fit for the differences of tensors along edges. */
function addChanges(
  triangles: Uint32Array,
  positions: Float32Array,
  { normals, areas, cornerAreas }: TangentFrames,
  into: Curvature,
): void {
  const { first, second, k1, k2, change } = into;
  eachTriangle(triangles, positions, (vertices, i) => {
    const tensors = vertices.map((vertex) => {
      frameAt(vertex, normals, first, second);
      const [a, c] = [inFace(u), inFace(v)];
      const [one, two] = [k1[vertex] ?? 0, k2[vertex] ?? 0];
      return [one * a[0] * a[0] + two * c[0] * c[0], one * a[0] * a[1] + two * c[0] * c[1], one * a[1] * a[1] + two * c[1] * c[1]];
    });
    const sums = [0, 0, 0, 0];
    let [uu, uv, vv] = [0, 0, 0];
    for (let k = 0; k < 3; k++) {
      const edge = edges[k] ?? t;
      const [x, y] = [edge.dot(t), edge.dot(b)];
      const [from, to] = [tensors[(k + 1) % 3] ?? [], tensors[(k + 2) % 3] ?? []];
      const [d0 = 0, d1 = 0, d2 = 0] = to.map((value, c) => value - (from[c] ?? 0));
      uu += x * x;
      uv += x * y;
      vv += y * y;
      for (const [c, value] of [x * d0, y * d0 + 2 * x * d1, 2 * y * d1 + x * d2, y * d2].entries()) sums[c] = (sums[c] ?? 0) + value;
    }
    const rows = [
      [uu, uv, 0, 0],
      [uv, 2 * uu + vv, 2 * uv, 0],
      [0, 2 * uv, uu + 2 * vv, uv],
      [0, 0, uv, vv],
    ];
    const found = solve(rows, sums);
    if (!found) return;
    for (let k = 0; k < 3; k++) {
      const vertex = vertices[k] ?? 0;
      const weight = (cornerAreas[i + k] ?? 0) / (areas[vertex] || 1);
      frameAt(vertex, normals, first, second);
      const [a, c] = [inFace(u), inFace(v)];
      accumulate(change, vertex * 4, [cubic(found, a, a, a), cubic(found, a, a, c), cubic(found, a, c, c), cubic(found, c, c, c)], weight);
    }
  });
}

type Pair = readonly [number, number];

function cubic([uuu = 0, uuv = 0, uvv = 0, vvv = 0]: readonly number[], [a, b]: Pair, [c, d]: Pair, [e, f]: Pair): number {
  return uuu * a * c * e + uuv * (a * c * f + a * d * e + b * c * e) + uvv * (a * d * f + b * c * f + b * d * e) + vvv * b * d * f;
}
