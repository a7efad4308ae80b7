import { Vector3 } from 'three';
import type { MeshShape } from '../../volumes/mesh-shape.ts';
import type { Curvature } from './curvature.ts';
import { type TangentFrames, turnBetween } from './tangent-frames.ts';

/**
 * How far the field looks for the direction of the surface, as a part of the radius of the mesh: bends that are smaller do not turn
 * strokes.
 */
const SMOOTHING = 0.12;

/** Weight of the level direction against a certain one: it decides only where nothing near bends. */
const LEVEL_WEIGHT = 0.002;

/** A surface that bends by this difference of curvatures, in one per radius of the mesh, is half certain. */
const HALF_CERTAIN = 1;

/**
 * The strokes of a level surface run along its cuts with planes across this axis, which no face of most models has as its normal. The
 * technique Hatching has the same, for its mapping Level.
 */
export const LEVEL_AXIS = [0.12, 1, 0.16] as const;

const levelAxis = new Vector3(...LEVEL_AXIS).normalize();

/** The system is solved to this part of its right side, or for this number of steps; more changes directions by less than a degree. */
const PRECISION = 1e-3;
const MAX_STEPS = 150;

const normal = new Vector3();
const other = new Vector3();
const tangent = new Vector3();

/**
 * Computes a smooth field of directions on a mesh that follow the curvature: at each vertex the direction in which the surface bends most,
 * as far as it bends more in one direction than across it, else what the vertices around have. Directions count with 180° symmetry. The
 * field minimizes the differences along edges plus those to the curvature, weighted by how certain that is: Knöppel, Crane, Pinkall,
 * Schröder, Globally Optimal Direction Fields, SIGGRAPH 2013, section 3.3, with n = 2. Where nothing bends, the direction is level.
 *
 * @param positions Three numbers per welded vertex.
 * @returns A unit tangent per vertex, three numbers each; its sign has no meaning.
 */
export function directionField(shape: MeshShape, positions: Float32Array, frames: TangentFrames, curvature: Curvature): Float32Array {
  const count = positions.length / 3;
  const scale = radiusOf(positions);
  const links = linksOf(shape, positions, frames);
  const diagonal = new Float64Array(count);
  const right = new Float64Array(count * 2);
  const field = new Float64Array(count * 2);
  for (let i = 0; i < links.weights.length; i++) {
    for (const vertex of [links.ends[i * 2] ?? 0, links.ends[i * 2 + 1] ?? 0])
      diagonal[vertex] = (diagonal[vertex] ?? 0) + (links.weights[i] ?? 0);
  }
  for (let vertex = 0; vertex < count; vertex++) {
    const data = (frames.areas[vertex] ?? 0) / (SMOOTHING * scale) ** 2;
    const wanted = wantedAt(vertex, frames, curvature, scale);
    const weight = Math.hypot(wanted[0], wanted[1]);
    diagonal[vertex] = (diagonal[vertex] ?? 0) + data * (weight + LEVEL_WEIGHT) + Number.EPSILON;
    for (let c = 0; c < 2; c++) {
      const level = levelAt(vertex, frames)[c] ?? 0;
      right[vertex * 2 + c] = data * ((wanted[c] ?? 0) + LEVEL_WEIGHT * level);
      field[vertex * 2 + c] = wanted[c] ?? 0;
    }
  }
  solveField(links, diagonal, right, field);
  const directions = new Float32Array(positions.length);
  for (let vertex = 0; vertex < count; vertex++) {
    const found = [field[vertex * 2] ?? 0, field[vertex * 2 + 1] ?? 0] as const;
    setDirection(directions, vertex, frames, Math.hypot(...found) > 1e-9 ? found : levelAt(vertex, frames));
  }
  return directions;
}

/** The level directions of a mesh: unit tangents, three numbers each. */
export function levelField(frames: TangentFrames): Float32Array {
  const directions = new Float32Array(frames.normals.length);
  for (let vertex = 0; vertex < directions.length / 3; vertex++) setDirection(directions, vertex, frames, levelAt(vertex, frames));
  return directions;
}

/** Writes the tangent of half the angle of a complex number. */
function setDirection(
  into: Float32Array,
  vertex: number,
  { tangents, bitangents }: TangentFrames,
  [x, y]: readonly [number, number],
): void {
  const angle = Math.atan2(y, x) / 2;
  tangent.fromArray(tangents, vertex * 3).multiplyScalar(Math.cos(angle));
  tangent.addScaledVector(other.fromArray(bitangents, vertex * 3), Math.sin(angle)).toArray(into, vertex * 3);
}

function radiusOf(positions: Float32Array): number {
  normal.set(0, 0, 0);
  for (let at = 0; at < positions.length; at += 3) normal.add(other.fromArray(positions, at));
  normal.divideScalar(Math.max(positions.length / 3, 1));
  let farthest = 0;
  for (let at = 0; at < positions.length; at += 3) farthest = Math.max(farthest, normal.distanceTo(other.fromArray(positions, at)));
  return farthest || 1;
}

/** The direction at a vertex as a complex number with twice its angle in the frame of the vertex, as long as `length`. */
function doubled(vertex: number, { tangents, bitangents }: TangentFrames, direction: Vector3, length: number): readonly [number, number] {
  const [x, y] = [direction.dot(other.fromArray(tangents, vertex * 3)), direction.dot(other.fromArray(bitangents, vertex * 3))];
  const square = x * x + y * y;
  return square === 0 ? [0, 0] : [((x * x - y * y) / square) * length, ((2 * x * y) / square) * length];
}

/** The direction in which the surface bends most; its length is how certain that is, from 0 to 1. */
function wantedAt(vertex: number, frames: TangentFrames, { first, k1, k2 }: Curvature, scale: number): readonly [number, number] {
  // Where a saddle bends as much one way as the other, neither is the direction of the form.
  const apart = (Math.abs(k1[vertex] ?? 0) - Math.abs(k2[vertex] ?? 0)) * scale;
  return doubled(vertex, frames, tangent.fromArray(first, vertex * 3), apart / (apart + HALF_CERTAIN));
}

function levelAt(vertex: number, frames: TangentFrames): readonly [number, number] {
  tangent.crossVectors(levelAxis, normal.fromArray(frames.normals, vertex * 3));
  return doubled(vertex, frames, tangent, tangent.length());
}

/** The edges of a mesh, and how directions turn along them. */
interface Links {
  /** Two vertices per edge. */
  readonly ends: Uint32Array;
  readonly weights: Float64Array;
  /** Per edge a complex number: twice the angle from the frame of the second vertex to that of the first. */
  readonly turns: Float64Array;
}

function linksOf({ edges, uses, usesOf, triangles }: MeshShape, positions: Float32Array, frames: TangentFrames): Links {
  const count = edges.length / 2;
  const weights = new Float64Array(count);
  const turns = new Float64Array(count * 2);
  for (let i = 0; i < count; i++) {
    const [from, to] = [edges[i * 2] ?? 0, edges[i * 2 + 1] ?? 0];
    let cotangents = 0;
    for (const use of uses.subarray(usesOf[i], usesOf[i + 1])) {
      const triangle = (Math.abs(use) - 1) * 3;
      const opposite = [0, 1, 2].map((c) => triangles[triangle + c] ?? 0).find((vertex) => vertex !== from && vertex !== to) ?? from;
      normal.fromArray(positions, opposite * 3);
      tangent.fromArray(positions, from * 3).sub(normal);
      other.fromArray(positions, to * 3).sub(normal);
      const cosine = tangent.dot(other);
      cotangents += cosine / Math.max(tangent.cross(other).length(), 1e-30);
    }
    // Finite elements; obtuse and thin triangles would give weights below zero or beyond measure.
    weights[i] = Math.min(Math.max(cotangents / 2, 0.05), 20);
    normal.fromArray(frames.normals, to * 3);
    turnBetween(tangent.fromArray(frames.tangents, to * 3), normal, other.fromArray(frames.normals, from * 3));
    const turn = doubled(from, frames, tangent, 1);
    turns.set(turn, i * 2);
  }
  return { ends: edges, weights, turns };
}

/** Conjugate gradients with the diagonal as preconditioner (Hestenes and Stiefel 1952). The system is Hermitian and positive definite. */
function solveField(links: Links, diagonal: Float64Array, right: Float64Array, field: Float64Array): void {
  const size = field.length;
  const residual = new Float64Array(size);
  const step = new Float64Array(size);
  const image = new Float64Array(size);
  multiply(links, diagonal, field, image);
  let goal = 0;
  let rho = 0;
  for (let i = 0; i < size; i++) {
    residual[i] = (right[i] ?? 0) - (image[i] ?? 0);
    step[i] = (residual[i] ?? 0) / (diagonal[i >> 1] || 1);
    rho += (residual[i] ?? 0) * (step[i] ?? 0);
    goal += (right[i] ?? 0) ** 2 / (diagonal[i >> 1] || 1);
  }
  for (let steps = 0; steps < MAX_STEPS && rho > goal * PRECISION ** 2; steps++) {
    multiply(links, diagonal, step, image);
    let curve = 0;
    for (let i = 0; i < size; i++) curve += (step[i] ?? 0) * (image[i] ?? 0);
    const length = rho / curve;
    let next = 0;
    for (let i = 0; i < size; i++) {
      field[i] = (field[i] ?? 0) + length * (step[i] ?? 0);
      residual[i] = (residual[i] ?? 0) - length * (image[i] ?? 0);
      next += (residual[i] ?? 0) ** 2 / (diagonal[i >> 1] || 1);
    }
    for (let i = 0; i < size; i++) step[i] = (residual[i] ?? 0) / (diagonal[i >> 1] || 1) + (next / rho) * (step[i] ?? 0);
    rho = next;
  }
}

function multiply({ ends, weights, turns }: Links, diagonal: Float64Array, from: Float64Array, into: Float64Array): void {
  for (let i = 0; i < from.length; i++) into[i] = (diagonal[i >> 1] ?? 0) * (from[i] ?? 0);
  for (let i = 0; i < weights.length; i++) {
    const [a, b] = [(ends[i * 2] ?? 0) * 2, (ends[i * 2 + 1] ?? 0) * 2];
    const [x, y, weight] = [turns[i * 2] ?? 0, turns[i * 2 + 1] ?? 0, weights[i] ?? 0];
    const [ax, ay, bx, by] = [from[a] ?? 0, from[a + 1] ?? 0, from[b] ?? 0, from[b + 1] ?? 0];
    into[a] = (into[a] ?? 0) - weight * (x * bx - y * by);
    into[a + 1] = (into[a + 1] ?? 0) - weight * (y * bx + x * by);
    into[b] = (into[b] ?? 0) - weight * (x * ax + y * ay);
    into[b + 1] = (into[b + 1] ?? 0) - weight * (x * ay - y * ax);
  }
}
