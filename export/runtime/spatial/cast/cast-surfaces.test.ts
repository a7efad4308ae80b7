import { describe, expect, test } from '@jest/globals';
import { BoxGeometry, Matrix4, Mesh, Raycaster, Vector3 } from 'three';
import type { Ray } from '../../../../nodes/kit/hit-test.ts';
import type { DetectedMesh, DetectedPlane } from '../../../../nodes/kit/session.ts';
import { createRandom } from '../../random.ts';
import { createMeeting, createRay, setRay } from '../ray.ts';
import { castAtMesh } from './cast-mesh.ts';
import { castAtFloor, castAtPlane } from './cast-plane.ts';

function rayFrom(origin: readonly [number, number, number], towards: readonly [number, number, number]): Ray {
  const from = new Vector3(...origin);
  const ray = createRay();
  setRay(ray, new Matrix4().lookAt(from, new Vector3(...towards), new Vector3(0.1, 1, 0.2)).setPosition(from).elements);
  return ray;
}

function planeAt(matrix: Matrix4, outline = [-1, -1, 1, -1, 1, 1, -1, 1]): DetectedPlane {
  return {
    id: 'p',
    version: 0,
    label: 'table',
    orientation: 'other',
    worldFromSurface: new Float32Array(matrix.elements),
    outlineXZ: Float32Array.from(outline),
  };
}

describe('a ray and a plane', () => {
  test('meet where the formula says', () => {
    // From (0, 3, 4) towards the origin: 5 m to the plane y = 0, and 10/3 to the plane y = 1.
    const ray = rayFrom([0, 3, 4], [0, 0, 0]);
    const meeting = createMeeting();
    expect(castAtPlane(meeting, ray, planeAt(new Matrix4()))).toBe(true);
    expect(meeting.distanceM).toBeCloseTo(5, 6);
    expect(castAtPlane(meeting, ray, planeAt(new Matrix4().makeTranslation(0, 1, 1)))).toBe(true);
    expect(meeting.distanceM).toBeCloseTo(10 / 3, 6);
    expect([meeting.nx, meeting.ny, meeting.nz]).toEqual([0, 1, 0]);
  });

  test('do not meet behind the ray, along the plane or beside the outline', () => {
    const meeting = createMeeting();
    const floor = planeAt(new Matrix4());
    expect(castAtPlane(meeting, rayFrom([0, 1, 0], [0, 2, 0.01]), floor)).toBe(false);
    expect(castAtPlane(meeting, rayFrom([0, 1, 0], [1, 1, 0]), floor)).toBe(false);
    expect(castAtPlane(meeting, rayFrom([0, 1, 0], [1.1, 0, 0]), floor)).toBe(false);
    // In the notch of an L.
    const notched = planeAt(new Matrix4(), [-1, -1, 1, -1, 1, 0, 0, 0, 0, 1, -1, 1]);
    expect([
      castAtPlane(meeting, rayFrom([0.5, 1, 0.5], [0.5, 0, 0.5]), notched),
      castAtPlane(meeting, rayFrom([-0.5, 1, 0.5], [-0.5, 0, 0.5]), notched),
    ]).toEqual([false, true]);
  });

  test('meet on a wall with the wall’s normal', () => {
    const meeting = createMeeting();
    // Turned about x by a quarter: y of the plane is z of the world.
    const wall = planeAt(new Matrix4().makeRotationX(Math.PI / 2).setPosition(0, 1, -2));
    expect(castAtPlane(meeting, rayFrom([0.5, 1.2, 1], [0.5, 1.2, -1]), wall)).toBe(true);
    expect(meeting.distanceM).toBeCloseTo(3, 6);
    expect([meeting.nx, meeting.ny, meeting.nz].map((x) => Math.round(x * 1e6) / 1e6 + 0)).toEqual([0, 0, 1]);
  });
});

test('the floor is met within 20 m, from above', () => {
  const meeting = createMeeting();
  expect([castAtFloor(meeting, rayFrom([0, 1.6, 0], [0, 0, -1])), meeting.distanceM]).toEqual([
    true,
    expect.closeTo(Math.hypot(1.6, 1), 6),
  ]);
  expect(castAtFloor(meeting, rayFrom([0, 1.6, 0], [0, 1.5, -2]))).toBe(false);
  expect(castAtFloor(meeting, rayFrom([0, -1, 0], [0, -2, -1]))).toBe(false);
  expect(castAtFloor(meeting, rayFrom([0, 1, 0], [0, 2, -1]))).toBe(false);
});

test('a ray meets a mesh where three.js says, from all sides', () => {
  const geometry = new BoxGeometry(1, 2, 3);
  const matrix = new Matrix4().makeRotationY(0.7).setPosition(0.3, 0.4, -1);
  const three = new Mesh(geometry);
  three.matrixAutoUpdate = false;
  three.matrixWorld.copy(matrix);
  const mesh: DetectedMesh = {
    id: 'm',
    version: 0,
    label: '',
    worldFromSurface: new Float32Array(matrix.elements),
    positions: Float32Array.from(geometry.getAttribute('position').array),
    indices: Uint32Array.from(geometry.getIndex()?.array ?? []),
  };
  const random = createRandom(3, 'rays');
  const next = () => random.next() * 6 - 3;
  let hits = 0;
  for (let i = 0; i < 300; i++) {
    const from = [next(), next(), next()] as const;
    const to = [next() / 3, next() / 3, next() / 3 - 1] as const;
    const ray = rayFrom(from, to);
    const meeting = createMeeting();
    const met = castAtMesh(meeting, ray, mesh);
    const [expected] = new Raycaster(new Vector3(...from), new Vector3(ray.dx, ray.dy, ray.dz)).intersectObject(three);
    const inside = new Vector3(...from).applyMatrix4(matrix.clone().invert());
    // From within, three.js takes the back of a triangle for nothing.
    if (Math.abs(inside.x) < 0.5 && Math.abs(inside.y) < 1 && Math.abs(inside.z) < 1.5) continue;
    expect(met).toBe(expected !== undefined);
    if (!expected) continue;
    hits++;
    expect(meeting.distanceM).toBeCloseTo(expected.distance, 4);
    const normal = new Vector3(meeting.nx, meeting.ny, meeting.nz).normalize();
    expect(Math.abs(normal.dot((expected.face?.normal ?? new Vector3()).clone().transformDirection(matrix)))).toBeCloseTo(1, 4);
  }
  expect(hits).toBeGreaterThan(50);
});
