import { describe, expect, test } from '@jest/globals';
import { Matrix4, Plane, Ray as ThreeRay, Vector3 } from 'three';
import { createRandom } from '../../random.ts';
import { setFrustum } from '../../sessions/matrix.ts';
import { createMeeting, createRay, setRay } from '../ray.ts';
import { castAtDepth, type DepthImage } from './cast-depth.ts';

const WIDTH = 160;
const HEIGHT = 120;

/** A camera at 1.5 m that looks down a little, with rows from the top as recordings have them. */
const WORLD_FROM_VIEW = new Matrix4().makeRotationX(-0.5).setPosition(0.2, 1.5, 1);

function pictureOf(depthAlong: (ray: ThreeRay) => number): DepthImage {
  const picture: DepthImage = {
    meters: new Float32Array(WIDTH * HEIGHT),
    widthPx: WIDTH,
    heightPx: HEIGHT,
    uvFromViewUv: Float32Array.of(1, 0, 0, 0, -1, 0, 0, 1, 1),
    clipFromView: new Float32Array(16),
    worldFromView: new Float32Array(WORLD_FROM_VIEW.elements),
    frame: 3,
  };
  setFrustum(picture.clipFromView, -0.8, 0.8, -0.6, 0.6, 0.05, 100);
  for (let row = 0; row < HEIGHT; row++) {
    for (let column = 0; column < WIDTH; column++) {
      picture.meters[row * WIDTH + column] = depthAlong(rayThrough((column + 0.5) / WIDTH, 1 - (row + 0.5) / HEIGHT));
    }
  }
  return picture;
}

/** In world space, of a direction whose length is one meter of depth. */
function rayThrough(u: number, v: number): ThreeRay {
  const direction = new Vector3((2 * u - 1) * 0.8, (2 * v - 1) * 0.6, -1).applyMatrix4(new Matrix4().extractRotation(WORLD_FROM_VIEW));
  return new ThreeRay(new Vector3().setFromMatrixPosition(WORLD_FROM_VIEW), direction);
}

/** Depth of planes, the nearest first. */
function depthOf(...planes: readonly Plane[]): (ray: ThreeRay) => number {
  return (ray) => {
    const all = planes.map((plane) => -(plane.distanceToPoint(ray.origin) / plane.normal.dot(ray.direction))).filter((t) => t > 0);
    return all.length === 0 ? 0 : Math.min(...all);
  };
}

function cast(picture: DepthImage, from: Vector3, towards: Vector3) {
  const ray = createRay();
  setRay(ray, new Matrix4().lookAt(from, towards, new Vector3(0.1, 1, 0.3)).setPosition(from).elements);
  const meeting = createMeeting();
  if (!castAtDepth(meeting, ray, picture)) return null;
  const point = from.clone().addScaledVector(new Vector3(ray.dx, ray.dy, ray.dz), meeting.distanceM);
  return { point, normal: new Vector3(meeting.nx, meeting.ny, meeting.nz).normalize(), distanceM: meeting.distanceM };
}

const FLOOR = new Plane(new Vector3(0, 1, 0), 0);
const WALL = new Plane(new Vector3(0.2, 0, 1).normalize(), 2);

describe('a ray through a depth picture', () => {
  const picture = pictureOf(depthOf(FLOOR, WALL));

  test('from the eye meets planes to a millimeter, with their normals to half a degree', () => {
    const random = createRandom(1, 'eye');
    let seen = 0;
    for (let i = 0; i < 300; i++) {
      const ray = rayThrough(random.next(), random.next());
      const depth = depthOf(FLOOR, WALL)(ray);
      const truth = ray.at(depth, new Vector3());
      // Within a few samples of the edge, the window sees both.
      if (Math.abs(FLOOR.distanceToPoint(truth) - WALL.distanceToPoint(truth)) < 0.3) continue;
      const hit = cast(picture, ray.origin, truth);
      expect(hit?.point.distanceTo(truth)).toBeLessThan(0.001);
      const plane = Math.abs(FLOOR.distanceToPoint(truth)) < 0.001 ? FLOOR : WALL;
      expect(Math.abs(hit?.normal.dot(plane.normal) ?? 0)).toBeGreaterThan(Math.cos((0.5 * Math.PI) / 180));
      seen++;
    }
    expect(seen).toBeGreaterThan(150);
  });

  test('from a hand beside the eye meets the floor to a millimeter', () => {
    const random = createRandom(2, 'hand');
    const hand = new Vector3(0.5, 1.1, 0.8);
    for (let i = 0; i < 100; i++) {
      const truth = new Vector3(random.next() * 1.2 - 0.4, 0, -random.next() * 0.8 - 0.2);
      const hit = cast(picture, hand, truth);
      expect(hit?.point.distanceTo(truth)).toBeLessThan(0.001);
      expect(hit?.distanceM).toBeCloseTo(hand.distanceTo(truth), 3);
    }
  });

  test('meets nothing outside the view, behind the eye and where depth is unknown', () => {
    expect(cast(picture, new Vector3(0.2, 1.5, 1), new Vector3(0.2, 1.5, 3))).toBe(null);
    expect(cast(picture, new Vector3(0.2, 1.5, 1), new Vector3(9, 1.5, 1))).toBe(null);
    expect(
      cast(
        pictureOf(() => 0),
        new Vector3(0.2, 1.5, 1),
        new Vector3(0.2, 0, -0.5),
      ),
    ).toBe(null);
  });
});

test('a ray that passes behind an edge goes on, and meets what is seen behind it', () => {
  // A box 0.5 m in front of the view's middle; behind it the floor.
  const near = (ray: ThreeRay) => {
    const local = ray.direction.clone().applyMatrix4(new Matrix4().extractRotation(WORLD_FROM_VIEW).invert());
    return Math.abs(local.x / -local.z) < 0.1 ? 0.5 : depthOf(FLOOR)(ray);
  };
  const picture = pictureOf(near);
  // From far left of the box to far right of it, well behind it.
  const target = rayThrough(0.9, 0.3);
  const truth = target.at(depthOf(FLOOR)(target), new Vector3());
  const origin = rayThrough(0.05, 0.35).at(1, new Vector3());
  const hit = cast(picture, origin, truth);
  expect(hit?.point.distanceTo(truth)).toBeLessThan(0.002);
});
