import { describe, expect, test } from '@jest/globals';
import { BoxGeometry, BufferGeometry, Float32BufferAttribute, PlaneGeometry, Ray, SphereGeometry, TorusKnotGeometry, Vector3 } from 'three';
import { createRandom } from '../../random.ts';
import { extrude, type LightPlace, maxExtrusion } from './extrude.ts';
import { createMeshShape, type MeshShape } from './mesh-shape.ts';

const shapeOf = (geometry: BufferGeometry): MeshShape => createMeshShape(geometry, () => true);

function placesOf(geometry: BufferGeometry, { vertices }: MeshShape): Float32Array {
  const { position } = geometry.attributes;
  return Float32Array.from([...vertices].flatMap((i) => [position?.getX(i) ?? 0, position?.getY(i) ?? 0, position?.getZ(i) ?? 0]));
}

/** Three sheets that share one edge. */
function fan(): BufferGeometry {
  const geometry = new BufferGeometry();
  geometry.setAttribute('position', new Float32BufferAttribute([0, -1, 0, 0, 1, 0, 1, 0, 0.1, -0.9, 0, 0.8, -1, 0, -0.7], 3));
  return geometry.setIndex([0, 1, 2, 0, 1, 3, 1, 0, 4]);
}

const MESHES: Readonly<Record<string, () => BufferGeometry>> = {
  'a box': () => new BoxGeometry(1, 1.2, 0.8),
  'a ball': () => new SphereGeometry(1, 12, 8),
  'a knot': () => new TorusKnotGeometry(0.7, 0.2, 32, 6),
  'a sheet': () => new PlaneGeometry(1.5, 1.5, 2, 2),
  'an open bowl': () => new SphereGeometry(1, 12, 8, 0, Math.PI * 2, 0.3, 1.2),
  'three sheets at one edge': fan,
};

/** Far enough to stand for infinity in what the tests look at. */
const FAR = 1e4;

/** Corners of what `extrude` wrote, three per triangle. */
function cornersOf(geometry: BufferGeometry, light: LightPlace): { corners: Vector3[]; indices: Uint32Array } {
  const shape = shapeOf(geometry);
  const places = placesOf(geometry, shape);
  const into = new Uint32Array(maxExtrusion(shape));
  const indices = into.subarray(0, extrude(shape, places, light, into));
  const count = shape.vertices.length;
  const corners = [...indices].map((i) => {
    const at = new Vector3().fromArray(places, (i % count) * 3);
    if (i < count) return at;
    const away = at
      .clone()
      .multiplyScalar(light.w)
      .sub(new Vector3(light.x, light.y, light.z))
      .normalize();
    return light.w > 0 ? at.addScaledVector(away, FAR) : away.multiplyScalar(FAR);
  });
  return { corners, indices };
}

describe.each(Object.entries(MESHES))('the shadow volume of %s', (_, make) => {
  test.each([0, 1])('has no border, for light with w %d', (w) => {
    const random = createRandom(w, 'border').next;
    const geometry = make();
    const count = shapeOf(geometry).vertices.length;
    for (let round = 0; round < 5; round++) {
      const light = { x: random() * 6 - 3, y: 3, z: random() * 6 - 3, w };
      const { indices } = cornersOf(geometry, light);
      // Light from infinity moves all vertices to one point.
      const name = (i: number): number => (w === 0 && i >= count ? count : i);
      const passes = new Map<string, number>();
      for (let i = 0; i < indices.length; i++) {
        const from = name(indices[i] ?? 0);
        const to = name(indices[i % 3 === 2 ? i - 2 : i + 1] ?? 0);
        const edge = from < to ? `${from} ${to}` : `${to} ${from}`;
        passes.set(edge, (passes.get(edge) ?? 0) + (from < to ? 1 : -1));
      }
      expect(indices.length).toBeGreaterThan(0);
      expect([...passes.values()].filter((sum) => sum !== 0)).toEqual([]);
    }
  });

  test.each([0, 1])('holds exactly the points that light with w %d does not reach', (w) => {
    const random = createRandom(w, 'points').next;
    const geometry = make();
    const light = { x: 0.7, y: 3.1, z: -1.3, w };
    const { corners } = cornersOf(geometry, light);
    let shadowed = 0;
    for (let round = 0; round < 120; round++) {
      const point = new Vector3(random() * 6 - 3, -1.5 - random() * 2, random() * 6 - 3);
      const dark = isBlocked(geometry, point, light);
      if (dark) shadowed++;
      expect(windings(corners, point) !== 0).toBe(dark);
    }
    expect(shadowed).toBeGreaterThan(3);
  });
});

/** Whether a triangle stands between a point and the light. */
function isBlocked(geometry: BufferGeometry, point: Vector3, light: LightPlace): boolean {
  const towards = new Vector3(light.x, light.y, light.z).addScaledVector(point, -light.w);
  const ray = new Ray(point, towards.normalize());
  const { position } = geometry.attributes;
  const index = geometry.index;
  const corner = (i: number): Vector3 => new Vector3().fromBufferAttribute(position as Float32BufferAttribute, index?.getX(i) ?? i);
  for (let i = 0; i < (index?.count ?? 0); i += 3) {
    if (ray.intersectTriangle(corner(i), corner(i + 1), corner(i + 2), false, new Vector3())) return true;
  }
  return false;
}

/** How often the surface goes around a point: passages of a ray, out less in, as a stencil counts them. */
function windings(corners: readonly Vector3[], point: Vector3): number {
  const ray = new Ray(point, new Vector3(0.3012, -0.4177, 0.8573).normalize());
  let count = 0;
  for (let i = 0; i < corners.length; i += 3) {
    const [a, b, c] = corners.slice(i, i + 3) as [Vector3, Vector3, Vector3];
    if (ray.intersectTriangle(a, b, c, true, new Vector3())) count--;
    else if (ray.intersectTriangle(a, c, b, true, new Vector3())) count++;
  }
  return count;
}
