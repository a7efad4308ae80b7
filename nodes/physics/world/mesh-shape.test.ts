import { describe, expect, test } from '@jest/globals';
import { Vec3 } from 'cannon-es';
import { type BoxGeometry, IcosahedronGeometry, Matrix4, PlaneGeometry, Quaternion, Vector3 } from 'three';
import { ball, createLab, cube, turned } from '../../../tests/support/physics/lab.ts';
import type { BodyShape, Triple } from '../../kit/physics.ts';
import { MeshShape } from './mesh-shape.ts';

interface Triangles {
  readonly positionsM: Float32Array;
  readonly indices: Uint32Array;
}

function trianglesOf(geometry: IcosahedronGeometry | BoxGeometry | PlaneGeometry): Triangles {
  const positionsM = Float32Array.from(geometry.attributes.position?.array ?? []);
  const { index } = geometry;
  return { positionsM, indices: Uint32Array.from(index ? index.array : positionsM.slice(0, positionsM.length / 3).map((_, i) => i)) };
}

/** A square of 2 m that faces up, of so many squares along each side. */
const ground = (parts = 1): BodyShape => ({
  kind: 'mesh',
  ...trianglesOf(new PlaneGeometry(2, 2, parts, parts).rotateX(-Math.PI / 2) as PlaneGeometry),
});

describe('triangles of a body that nothing moves', () => {
  test.each([1, 40])('a ball and a box come to rest on a plane of %i² squares, within a millimeter, and sleep', (parts) => {
    const lab = createLab({ sleep: true });
    lab.add({ mode: 'static', shapes: [ground(parts)] }, { positionM: [0, 0.7, 0] });
    const one = lab.add({ shapes: ball(0.05), rollingM: 0.004 }, { positionM: [0.31, 1, 0.12] });
    const other = lab.add({ shapes: cube(0.1) }, { positionM: [-0.33, 1, -0.21], rotation: turned([0, 1, 0], 0.4) });
    lab.run(3);
    expect(Math.abs(lab.body(one).positionM[1] - 0.75)).toBeLessThan(1e-3);
    expect(Math.abs(lab.body(other).positionM[1] - 0.75)).toBeLessThan(1e-3);
    expect([lab.body(one).isAsleep, lab.body(other).isAsleep]).toEqual([true, true]);
  });

  test('the back of a triangle holds things as its front does', () => {
    const lab = createLab();
    lab.add({ mode: 'static', shapes: [ground()] }, { positionM: [0, 0.7, 0], rotation: turned([1, 0, 0], Math.PI) });
    const id = lab.add({ shapes: ball(0.05), rollingM: 0.004 }, { positionM: [0.31, 1, 0.12] });
    lab.run(2);
    expect(Math.abs(lab.body(id).positionM[1] - 0.75)).toBeLessThan(1e-3);
  });

  test('a ball at 30 m/s does not pass, and one that rolls crosses the edges between triangles without a bump', () => {
    const lab = createLab();
    lab.add({ mode: 'static', shapes: [ground(40)], friction: 0.5 }, { positionM: [0, 0.7, 0] });
    const fast = lab.add({ shapes: ball(0.03) }, { positionM: [0.52, 2.1, 0.52], velocity: [0, -30, 0] });
    const rolling = lab.add({ shapes: ball(0.05) }, { positionM: [-0.9, 0.75, 0.01], velocity: [1, 0, 0], spin: [0, 0, -20] });
    let highest = 0;
    lab.run(1, () => {
      highest = Math.max(highest, lab.body(rolling).positionM[1]);
      expect(lab.body(fast).positionM[1]).toBeGreaterThan(0.7);
    });
    expect(highest).toBeLessThan(0.7505);
    expect(lab.body(rolling).velocity[0]).toBeGreaterThan(0.98);
  });

  test('a box slides down a slope of 28° at a friction of 0.5 and holds on one of 25°', () => {
    const moved = [25, 28].map((degrees) => {
      const lab = createLab();
      const angleRad = (degrees * Math.PI) / 180;
      const rotation = turned([0, 0, 1], -angleRad);
      lab.add({ mode: 'static', shapes: [ground(20)], friction: 0.5 }, { rotation });
      const positionM: Triple = [0.05 * Math.sin(angleRad), 0.05 * Math.cos(angleRad), 0];
      const id = lab.add({ shapes: cube(0.1) }, { positionM, rotation });
      lab.run(2);
      return Math.hypot(...lab.body(id).positionM.map((x, i) => x - (positionM[i] ?? 0)));
    });
    expect(moved[0]).toBeLessThan(0.01);
    expect(moved[1]).toBeGreaterThan(0.1);
  });

  test('triangles with strange numbers are no obstacle, and no pose becomes NaN', () => {
    const lab = createLab();
    const strange: BodyShape = {
      kind: 'mesh',
      positionsM: Float32Array.of(0, 0, 0, 0, 0, 0, 0, 0, 0, 1, 0, 0, 2, 0, 0),
      indices: Uint32Array.of(0, 1, 2, 0, 3, 4, 7, 8, 9),
    };
    lab.add({ mode: 'static', shapes: [strange] }, {});
    lab.add({ mode: 'static', shapes: [{ kind: 'mesh', positionsM: new Float32Array(0), indices: new Uint32Array(0) }] }, {});
    const id = lab.add({ shapes: ball(0.05) }, { positionM: [0, 0.2, 0] });
    lab.run(1);
    expect(lab.body(id).positionM.every(Number.isFinite)).toBe(true);
    expect(lab.body(id).velocity[1]).toBeLessThan(-9);
  });
});

describe('the tree of a mesh', () => {
  test('finds the triangles that a search of all finds, and the same point of a ray', () => {
    const { positionsM, indices } = trianglesOf(new IcosahedronGeometry(0.5, 6));
    const shape = new MeshShape(positionsM, indices, new Vec3());
    const rotation = new Quaternion().setFromAxisAngle(new Vector3(0.6, 0.8, 0), 0.7);
    const place = new Vec3(0.3, -0.2, 0.4);
    shape.place(place, rotation as never);
    const world = new Matrix4().compose(new Vector3(place.x, place.y, place.z), rotation, new Vector3(1, 1, 1));
    const corner = (i: number) => new Vector3().fromArray(positionsM, 3 * (indices[i] ?? 0)).applyMatrix4(world);
    for (let k = 0; k < 20; k++) {
      const at = (axis: number) => Math.sin(k * 1.7 + axis * 2.1) * 0.6 + ([0.3, -0.2, 0.4][axis] ?? 0);
      const [min, max] = [new Vector3(at(0), at(1), at(2)), new Vector3(at(0) + 0.2, at(1) + 0.2, at(2) + 0.2)];
      shape.findNear(new Vec3(min.x, min.y, min.z), new Vec3(max.x, max.y, max.z));
      const found = new Set(shape.found);
      for (let i = 0; i < indices.length; i += 3) {
        const [a, b, c] = [corner(i), corner(i + 1), corner(i + 2)];
        const isIn = [a, b, c].some((p) => p.x > min.x && p.y > min.y && p.z > min.z && p.x < max.x && p.y < max.y && p.z < max.z);
        if (isIn) expect(found.has(i / 3)).toBe(true);
      }
    }
    // From outside towards the center, the distance is that of a sphere, but for the flatness of its triangles.
    const normal = new Vec3();
    const from = new Vec3(place.x + 2, place.y, place.z);
    expect(shape.cast(from, new Vec3(-1, 0, 0), 5, normal)).toBeCloseTo(1.5, 1);
    expect(normal.x).toBeGreaterThan(0.95);
    expect(shape.cast(from, new Vec3(1, 0, 0), 5, normal)).toBe(Number.POSITIVE_INFINITY);
    expect(shape.cast(from, new Vec3(-1, 0, 0), 1, normal)).toBe(Number.POSITIVE_INFINITY);
  });
});
