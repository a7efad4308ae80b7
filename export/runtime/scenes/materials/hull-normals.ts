import { BufferAttribute, type BufferGeometry, Vector3 } from 'three';

const NAME = 'scrimHullNormal';

/** Maximum length of a hull normal; between faces that fold back on each other it would be unlimited. */
const LONGEST = 2;

// Valid within one iteration.
const scratchCorners = [new Vector3(), new Vector3(), new Vector3()] as const;
const scratchEdge = new Vector3();
const scratchOther = new Vector3();
const scratchFace = new Vector3();

/**
 * Adds the attribute `scrimHullNormal` to a geometry, once. Moving a vertex along its hull normal moves all adjacent faces outward by one.
 * Vertices at equal positions share it, so that the hull has no gaps at hard edges. Faces are weighted by their angle at the vertex
 * (Thürmer and Wüthrich 1998), so the result does not depend on how a flat side is triangulated.
 */
export function ensureHullNormals(geometry: BufferGeometry): void {
  const { position } = geometry.attributes;
  if (!position || geometry.attributes[NAME]) return;
  const placeOf = findPlaces(position.count, (i, into) => into.fromBufferAttribute(position, i));
  const sums = new Float32Array(position.count * 3);
  eachCorner(geometry, (vertex, normal, weight) => {
    const at = (placeOf[vertex] ?? 0) * 3;
    for (let c = 0; c < 3; c++) sums[at + c] = (sums[at + c] ?? 0) + normal.getComponent(c) * weight;
  });
  // Distance by which the mean direction moves each face; the vector is scaled by its inverse.
  const facing = new Float32Array(position.count);
  const weights = new Float32Array(position.count);
  eachCorner(geometry, (vertex, normal, weight) => {
    const place = placeOf[vertex] ?? 0;
    scratchOther.fromArray(sums, place * 3).normalize();
    facing[place] = (facing[place] ?? 0) + weight * normal.dot(scratchOther);
    weights[place] = (weights[place] ?? 0) + weight;
  });
  const outward = new Float32Array(position.count * 3);
  for (let i = 0; i < position.count; i++) {
    const place = placeOf[i] ?? 0;
    const mean = (facing[place] ?? 0) / (weights[place] || 1);
    scratchFace.fromArray(sums, place * 3).normalize();
    scratchFace.multiplyScalar(Math.min(1 / Math.max(mean, 1 / LONGEST), LONGEST)).toArray(outward, i * 3);
  }
  geometry.setAttribute(NAME, new BufferAttribute(outward, 3));
}

/** Returns, for each vertex, the index of the first vertex at the same position. */
function findPlaces(count: number, read: (index: number, into: Vector3) => void): Uint32Array {
  const first = new Map<string, number>();
  const places = new Uint32Array(count);
  for (let i = 0; i < count; i++) {
    read(i, scratchEdge);
    const key = `${scratchEdge.x},${scratchEdge.y},${scratchEdge.z}`;
    const known = first.get(key) ?? i;
    if (known === i) first.set(key, i);
    places[i] = known;
  }
  return places;
}

function eachCorner(geometry: BufferGeometry, visit: (vertex: number, normal: Vector3, angle: number) => void): void {
  const { index } = geometry;
  const { position } = geometry.attributes;
  if (!position) return;
  const count = index?.count ?? position.count;
  for (let i = 0; i + 2 < count; i += 3) {
    const vertices = [0, 1, 2].map((corner) => index?.getX(i + corner) ?? i + corner);
    for (let corner = 0; corner < 3; corner++) scratchCorners[corner]?.fromBufferAttribute(position, vertices[corner] ?? 0);
    const [a, b, c] = scratchCorners;
    scratchFace.crossVectors(scratchEdge.subVectors(b, a), scratchOther.subVectors(c, a)).normalize();
    if (scratchFace.lengthSq() === 0) continue;
    for (let corner = 0; corner < 3; corner++) {
      const here = scratchCorners[corner] ?? a;
      const next = scratchCorners[(corner + 1) % 3] ?? a;
      const last = scratchCorners[(corner + 2) % 3] ?? a;
      const angle = scratchEdge.subVectors(next, here).angleTo(scratchOther.subVectors(last, here));
      visit(vertices[corner] ?? 0, scratchFace, angle);
    }
  }
}
