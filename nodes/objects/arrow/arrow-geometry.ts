import { BufferAttribute, BufferGeometry, DynamicDrawUsage } from 'three';

/** The number of sides of the round parts: enough to look round at arm's length. */
const SEGMENTS = 32;
/**
 * The number of rings of vertices: two for each of end cap, shaft, back of the head, and head. Parts share no vertices, because the edges
 * between them are sharp.
 */
const RINGS = 8;

/** Lengths along the arrow, and radii, meters. The shaft tapers so that it has the same width on the screen at both ends. */
export interface ArrowShape {
  lengthM: number;
  headLengthM: number;
  /** Radii of the shaft, at its start and at the head. */
  startRadiusM: number;
  neckRadiusM: number;
  headRadiusM: number;
}

/** Creates the shape of an arrow without size. */
export function createArrowShape(): ArrowShape {
  return { lengthM: 0, headLengthM: 0, startRadiusM: 0, neckRadiusM: 0, headRadiusM: 0 };
}

/** A closed arrow along y from the origin, with outward faces; `setArrowShape` writes its vertices. */
export function createArrowGeometry(): BufferGeometry {
  const geometry = new BufferGeometry();
  for (const name of ['position', 'normal']) {
    geometry.setAttribute(name, new BufferAttribute(new Float32Array(RINGS * SEGMENTS * 3), 3).setUsage(DynamicDrawUsage));
  }
  const indices: number[] = [];
  for (let lower = 0; lower < RINGS; lower += 2) {
    for (let i = 0; i < SEGMENTS; i++) {
      const a = lower * SEGMENTS + i;
      const b = lower * SEGMENTS + ((i + 1) % SEGMENTS);
      indices.push(a, b, a + SEGMENTS, b, b + SEGMENTS, a + SEGMENTS);
    }
  }
  geometry.setIndex(indices);
  return geometry;
}

/** Writes the vertices and bounds of an arrow. Allocates nothing after the first call. */
export function setArrowShape(geometry: BufferGeometry, shape: ArrowShape): void {
  const { lengthM, headLengthM, startRadiusM, neckRadiusM, headRadiusM } = shape;
  const neckM = lengthM - headLengthM;
  const positions = geometry.getAttribute('position').array as Float32Array;
  const normals = geometry.getAttribute('normal').array as Float32Array;
  writePair(positions, normals, 0, 0, 0, 0, startRadiusM);
  writePair(positions, normals, 2, 0, startRadiusM, neckM, neckRadiusM);
  writePair(positions, normals, 4, neckM, neckRadiusM, neckM, headRadiusM);
  writePair(positions, normals, 6, neckM, headRadiusM, lengthM, 0);
  geometry.getAttribute('position').needsUpdate = true;
  geometry.getAttribute('normal').needsUpdate = true;
  geometry.computeBoundingSphere();
  geometry.computeBoundingBox();
}

/** Writes two rings of vertices, with the normals of the cone between them. */
function writePair(
  positions: Float32Array,
  normals: Float32Array,
  ring: number,
  lowerYM: number,
  lowerRadiusM: number,
  upperYM: number,
  upperRadiusM: number,
): void {
  const along = upperYM - lowerYM;
  const outward = upperRadiusM - lowerRadiusM;
  const size = Math.hypot(along, outward) || 1;
  for (let i = 0; i < SEGMENTS; i++) {
    const angle = (2 * Math.PI * i) / SEGMENTS;
    const x = Math.sin(angle);
    const z = Math.cos(angle);
    const low = (ring * SEGMENTS + i) * 3;
    const high = low + SEGMENTS * 3;
    write(positions, low, x * lowerRadiusM, lowerYM, z * lowerRadiusM);
    write(positions, high, x * upperRadiusM, upperYM, z * upperRadiusM);
    write(normals, low, (x * along) / size, -outward / size, (z * along) / size);
    write(normals, high, (x * along) / size, -outward / size, (z * along) / size);
  }
}

function write(out: Float32Array, at: number, x: number, y: number, z: number): void {
  out[at] = x;
  out[at + 1] = y;
  out[at + 2] = z;
}
