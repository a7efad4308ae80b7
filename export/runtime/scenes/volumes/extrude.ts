import type { MeshShape } from './mesh-shape.ts';

/** A light in the local space of a mesh: a position with `w` 1, or the direction towards it with `w` 0. */
export interface LightPlace {
  readonly x: number;
  readonly y: number;
  readonly z: number;
  readonly w: number;
}

/** Maximum number of indices that `extrude` writes for a mesh. */
export function maxExtrusion({ triangles }: MeshShape): number {
  // Two caps per triangle, and one side of two triangles per use of an edge.
  return 8 * triangles.length;
}

// Valid within one call; grows to the largest mesh.
let scratchWeight = new Int8Array(0);

/**
 * Computes the shadow volume of a mesh: a closed surface of triangles that face outward. Vertex i is in place; vertex i + n, where n is the
 * number of welded vertices, is the same vertex moved from the light to infinity.
 *
 * The near cap consists of the triangles that face the light, the sides start at their outline, and the far cap closes the volume;
 * directional lights need none, because all points at infinity coincide. A mesh with borders or inconsistent triangles has no inside: there
 * all triangles count, each oriented towards the light, and an edge gets as many sides as its triangles do not cancel out. The volume may
 * then count twice, which is still a shadow. (Bergeron 1986, “A general version of Crow's shadow volumes”.)
 *
 * @param positions Three numbers per welded vertex.
 * @param into Receives the indices; `maxExtrusion` is its maximum length.
 * @returns Number of indices written.
 */
export function extrude(shape: MeshShape, positions: Float32Array, light: LightPlace, into: Uint32Array): number {
  const { triangles, edges, usesOf, uses } = shape;
  weigh(shape, positions, light);
  const away = shape.vertices.length;
  const hasFarCap = light.w > 0;
  let n = 0;
  for (let i = 0; i < triangles.length; i += 3) {
    const weight = scratchWeight[i / 3] ?? 0;
    if (weight === 0) continue;
    const a = triangles[i] ?? 0;
    const b = triangles[i + (weight > 0 ? 1 : 2)] ?? 0;
    const c = triangles[i + (weight > 0 ? 2 : 1)] ?? 0;
    into[n++] = a;
    into[n++] = b;
    into[n++] = c;
    if (!hasFarCap) continue;
    into[n++] = a + away;
    into[n++] = c + away;
    into[n++] = b + away;
  }
  for (let e = 0; e + 1 < usesOf.length; e++) {
    let sides = 0;
    for (let u = usesOf[e] ?? 0; u < (usesOf[e + 1] ?? 0); u++) {
      const use = uses[u] ?? 0;
      const weight = scratchWeight[Math.abs(use) - 1] ?? 0;
      sides += use > 0 ? weight : -weight;
    }
    if (sides === 0) continue;
    // Opposite to the direction in which triangles of the cap traverse the edge.
    const from = edges[e * 2 + (sides > 0 ? 1 : 0)] ?? 0;
    const to = edges[e * 2 + (sides > 0 ? 0 : 1)] ?? 0;
    for (let i = Math.abs(sides); i > 0; i--) {
      into[n++] = from;
      into[n++] = to;
      into[n++] = to + away;
      if (!hasFarCap) continue;
      into[n++] = from;
      into[n++] = to + away;
      into[n++] = from + away;
    }
  }
  return n;
}

/** Writes to `scratchWeight` how each triangle counts: 1 if it faces the light, else 0, or -1 if the mesh has no inside. */
function weigh({ triangles, closed }: MeshShape, positions: Float32Array, light: LightPlace): void {
  const count = triangles.length / 3;
  if (scratchWeight.length < count) scratchWeight = new Int8Array(count);
  for (let t = 0; t < count; t++) {
    const a = (triangles[t * 3] ?? 0) * 3;
    const b = (triangles[t * 3 + 1] ?? 0) * 3;
    const c = (triangles[t * 3 + 2] ?? 0) * 3;
    const ax = positions[a] ?? 0;
    const ay = positions[a + 1] ?? 0;
    const az = positions[a + 2] ?? 0;
    const ux = (positions[b] ?? 0) - ax;
    const uy = (positions[b + 1] ?? 0) - ay;
    const uz = (positions[b + 2] ?? 0) - az;
    const vx = (positions[c] ?? 0) - ax;
    const vy = (positions[c + 1] ?? 0) - ay;
    const vz = (positions[c + 2] ?? 0) - az;
    const facing =
      (uy * vz - uz * vy) * (light.x - ax * light.w) +
      (uz * vx - ux * vz) * (light.y - ay * light.w) +
      (ux * vy - uy * vx) * (light.z - az * light.w);
    scratchWeight[t] = facing > 0 ? 1 : closed ? 0 : -1;
  }
}
