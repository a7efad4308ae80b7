import { readFileSync } from 'node:fs';
import { describe, expect, test } from '@jest/globals';
import {
  BufferGeometry,
  CylinderGeometry,
  Float32BufferAttribute,
  Mesh,
  PlaneGeometry,
  SphereGeometry,
  TorusGeometry,
  Vector3,
} from 'three';
import type { TechniqueView } from '../../../../../nodes/kit/technique-view.ts';
import { createMeshShape } from '../../volumes/mesh-shape.ts';
import { restVertices } from '../../volumes/pose-vertices.ts';
import { curvatureOf } from './curvature.ts';
import { createCurvatureNeeds } from './curvature-needs.ts';
import { directionField, LEVEL_AXIS } from './direction-field.ts';
import { ensureDirections } from './mesh-directions.ts';
import { tangentFrames } from './tangent-frames.ts';

/** Curvatures and directions of shapes against their formulas. */

function measured(geometry: BufferGeometry) {
  const shape = createMeshShape(geometry, () => true);
  const positions = restVertices(new Mesh(geometry), shape);
  const frames = tangentFrames(shape, positions);
  const curvature = curvatureOf(shape, positions, frames);
  const directions = directionField(shape, positions, frames, curvature);
  return Array.from({ length: positions.length / 3 }, (_, i) => ({
    at: new Vector3().fromArray(positions, i * 3),
    normal: new Vector3().fromArray(frames.normals, i * 3),
    first: new Vector3().fromArray(curvature.first, i * 3),
    second: new Vector3().fromArray(curvature.second, i * 3),
    k1: curvature.k1[i] ?? Number.NaN,
    k2: curvature.k2[i] ?? Number.NaN,
    change: [...curvature.change.subarray(i * 4, i * 4 + 4)],
    direction: new Vector3().fromArray(directions, i * 3),
  }));
}

/** Degrees between two lines. */
const between = (a: Vector3, b: Vector3): number =>
  (Math.acos(Math.min(Math.abs(a.dot(b)) / (a.length() * b.length()), 1)) * 180) / Math.PI;
const worst = (values: readonly number[]): number => Math.max(...values);

/** A sheet bent to a graph over x and y, without its border, where less is known. */
function graph(height: (x: number, y: number) => number): ReturnType<typeof measured> {
  const sheet = new PlaneGeometry(2, 2, 40, 40);
  const { position } = sheet.attributes;
  if (!position) throw new Error('no positions');
  for (let i = 0; i < position.count; i++) position.setZ(i, height(position.getX(i), position.getY(i)));
  return measured(sheet).filter(({ at }) => Math.abs(at.x) < 0.8 && Math.abs(at.y) < 0.8);
}

/** A mesh with a second triangle of the opposite orientation on each of its triangles. */
function doubled(geometry: BufferGeometry): BufferGeometry {
  const index = [...(geometry.index?.array ?? [])];
  return geometry.setIndex([...index, ...[...index].reverse()]);
}

describe('curvature', () => {
  test('of a sphere is the same everywhere and in all directions, and does not change', () => {
    const points = measured(new SphereGeometry(2, 64, 48)).filter(({ at }) => Math.abs(at.y) < 1.8);
    for (const { k1, k2, change } of points) {
      expect(Math.abs(k1 - 0.5)).toBeLessThan(0.02);
      expect(Math.abs(k2 - 0.5)).toBeLessThan(0.02);
      expect(worst(change.map(Math.abs))).toBeLessThan(0.02);
    }
  });

  test('of a cylinder is that of its circle, across its axis; seen from inside it is negative', () => {
    const cylinder = new CylinderGeometry(0.5, 0.5, 2, 48, 24, true);
    const points = measured(cylinder).filter(({ at }) => Math.abs(at.y) < 0.9);
    for (const { k1, k2, first } of points) {
      expect(Math.abs(k1 - 2)).toBeLessThan(0.03);
      expect(Math.abs(k2)).toBeLessThan(0.03);
      expect(Math.abs(first.y)).toBeLessThan(0.03);
    }
    const inside = measured(cylinder.scale(-1, 1, 1)).filter(({ at }) => Math.abs(at.y) < 0.9);
    expect(worst(inside.map(({ k1 }) => Math.abs(k1 + 2)))).toBeLessThan(0.03);
  });

  test('of a torus, with its directions and its change, is that of the formula', () => {
    const [radius, tube] = [1, 0.4];
    for (const { at, k1, k2, first, second, change } of measured(new TorusGeometry(radius, tube, 40, 96))) {
      const around = Math.hypot(at.x, at.y);
      const cosine = (around - radius) / tube;
      expect(Math.abs(k1 - 1 / tube)).toBeLessThan(0.03);
      expect(Math.abs(k2 - cosine / around)).toBeLessThan(0.03);
      expect(Math.abs(first.dot(new Vector3(-at.y, at.x, 0)) / around)).toBeLessThan(0.02);
      // Along the tube's circle only the other curvature changes: d/ds of cos(φ) / (R + r cos φ) with s = r φ.
      const sine = at.z / tube;
      const slope = (-sine * radius) / (tube * around * around);
      const upward = new Vector3((-sine * at.x) / around, (-sine * at.y) / around, cosine);
      const sign = Math.sign(first.dot(upward));
      const [uuu = 0, uuv = 0, uvv = 0, vvv = 0] = change;
      expect(Math.abs(uvv - sign * slope)).toBeLessThan(0.12);
      expect(worst([uuu, uuv, vvv].map(Math.abs))).toBeLessThan(0.12);
      expect(Math.abs(second.dot(upward))).toBeLessThan(0.02);
    }
  });

  test('of a saddle has a sign of its own along each of its directions', () => {
    const [middle] = graph((x, y) => 0.6 * x * x - 0.2 * y * y).filter(({ at }) => Math.hypot(at.x, at.y) < 0.01);
    // The surface rises along x, so it is concave as seen from above.
    expect(middle?.k1).toBeCloseTo(-1.2, 1);
    expect(middle?.k2).toBeCloseTo(0.4, 1);
    expect(between(middle?.first ?? new Vector3(), new Vector3(1, 0, 0))).toBeLessThan(1);
  });
});

describe('what techniques read of a mesh', () => {
  /** A technique that reads both, with inputs that turn each off at 0. */
  function reader(values: Record<'radial' | 'along', { value: number }>): TechniqueView {
    return {
      version: 1,
      key: 'test',
      vertex: '',
      fragment: 's.along s.radial',
      passes: [{ side: 'object' }],
      uniforms: Object.entries(values).map(([name, view]) => ({ name, kind: 'number', view })),
      unread: [
        { name: 'radial', uniform: 'radial', values: [0] },
        { name: 'along', uniform: 'along', values: [0, 1] },
      ],
      images: [],
    };
  }
  const bent = (): Mesh => new Mesh(new CylinderGeometry(0.5, 0.5, 2, 24, 12, true).rotateZ(1));
  const alongOf = ({ geometry }: Mesh): readonly number[] => [...(geometry.attributes.scrimAlong?.array ?? [])];

  test('is computed when they first read it', () => {
    const [mesh, twin] = [bent(), bent()];
    const values = { radial: { value: 0 }, along: { value: 1 } };
    const needs = createCurvatureNeeds();
    needs.add(mesh, reader(values));
    needs.sweep();
    needs.update();
    expect(mesh.geometry.attributes.scrimCurvature).toBeUndefined();
    const level = alongOf(mesh);
    values.radial.value = 0.5;
    needs.update();
    expect(mesh.geometry.attributes.scrimCurvature?.count).toBe(mesh.geometry.attributes.position?.count);
    expect(alongOf(mesh)).toEqual(level);
    values.along.value = 2;
    needs.update();
    ensureDirections(twin, true);
    expect(alongOf(mesh)).toEqual(alongOf(twin));
    expect(alongOf(mesh)).not.toEqual(level);
  });

  test('is level and flat for meshes of more than 200,000 triangles', () => {
    // Most of its triangles are one point.
    const large = (): Mesh => {
      const mesh = bent();
      return new Mesh(mesh.geometry.setIndex([...(mesh.geometry.index?.array ?? []), ...new Array<number>(600_000).fill(0)]));
    };
    const [mesh, twin] = [large(), large()];
    createCurvatureNeeds().add(mesh, reader({ radial: { value: 1 }, along: { value: 2 } }));
    ensureDirections(twin, false);
    expect(alongOf(mesh)).toEqual(alongOf(twin));
    expect(mesh.geometry.attributes.scrimCurvature?.array.some((value) => value !== 0)).toBe(false);
  });
});

describe('the direction field', () => {
  test('follows the circle of a cylinder and the tube of a torus, within a few degrees', () => {
    const cylinder = measured(new CylinderGeometry(0.5, 0.5, 2, 48, 24, true));
    expect(worst(cylinder.map(({ at, direction }) => between(direction, new Vector3(-at.z, 0, at.x))))).toBeLessThan(2);
    const torus = measured(new TorusGeometry(1, 0.4, 24, 64));
    const across = torus.map(({ at, direction }) => 90 - between(direction, new Vector3(-at.y, at.x, 0)));
    expect(worst(across)).toBeLessThan(3);
  });

  test('follows the stronger direction of a saddle', () => {
    const saddle = graph((x, y) => 0.6 * x * x - 0.2 * y * y);
    expect(worst(saddle.map(({ direction }) => between(new Vector3(direction.x, direction.y, 0), new Vector3(1, 0, 0))))).toBeLessThan(10);
  });

  test('is level and smooth on a sphere, which has no direction of its own', () => {
    const points = measured(new SphereGeometry(1, 48, 32)).filter(({ at }) => Math.abs(at.y) < 0.8);
    expect(worst(points.map(({ direction }) => Math.abs(direction.y)))).toBeLessThan(0.45);
    expect(worst(points.map(({ direction, normal }) => Math.abs(direction.dot(normal))))).toBeLessThan(1e-5);
  });

  test('is carried into a flat part from where the surface bends', () => {
    // A sheet that is rolled up at one of its sides.
    const rolled = graph((x) => (x > 0.2 ? (x - 0.2) ** 2 : 0));
    expect(worst(rolled.map(({ direction }) => between(new Vector3(direction.x, direction.y, 0), new Vector3(1, 0, 0))))).toBeLessThan(5);
  });

  test('of a mesh with each triangle twice, once for either side, is that of one side', () => {
    const once = measured(new TorusGeometry(1, 0.4, 24, 64));
    const twice = measured(doubled(new TorusGeometry(1, 0.4, 24, 64)));
    expect(worst(twice.map(({ normal }, i) => between(normal, once[i]?.normal ?? new Vector3())))).toBeLessThan(0.1);
    expect(worst(twice.map(({ direction }, i) => between(direction, once[i]?.direction ?? new Vector3())))).toBeLessThan(1);
    expect(worst(twice.map(({ k1 }, i) => Math.abs(k1 - (once[i]?.k1 ?? 0))))).toBeLessThan(1e-3);
  });

  test('is level about the same axis as the mapping Level of Hatching', () => {
    const text = readFileSync(new URL('../../../../../shader-library/techniques/hatching.glsl', import.meta.url), 'utf8');
    const [, axis = ''] = /LEVEL_AXIS = vec3\((.*)\);/.exec(text) ?? [];
    expect(axis.split(',').map(Number)).toEqual([...LEVEL_AXIS]);
  });

  test('has a direction where triangles have no area at rest', () => {
    const closed = new BufferGeometry().setAttribute('position', new Float32BufferAttribute([0, 0, 0, 1, 0, 0, 2, 0, 0], 3));
    for (const { normal, direction } of measured(closed.setIndex([0, 1, 2]))) {
      expect(normal.length()).toBeCloseTo(1);
      expect(direction.length()).toBeCloseTo(1);
    }
  });

  test('is the same in each run, and does not see a seam of texture coordinates', () => {
    const torus = (): readonly Vector3[] => measured(new TorusGeometry(1, 0.4, 12, 24)).map(({ direction }) => direction);
    expect(torus()).toEqual(torus());
    // The torus of three.js has a seam along each circle: 25 × 13 vertices, of which 24 × 12 differ.
    expect(torus()).toHaveLength(24 * 12);
  });
});
