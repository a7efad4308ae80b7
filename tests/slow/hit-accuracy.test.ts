import { readFileSync } from 'node:fs';
import { join } from 'node:path';
import { describe, expect, test } from '@jest/globals';
import { decode } from 'fast-png';
import { Matrix4, Raycaster, Vector3 } from 'three';
import { addDepthNoise } from '../../export/emulator/depth/depth-noise.ts';
import { createRoom } from '../../export/emulator/rooms/room-source.ts';
import { createRandom } from '../../export/runtime/random.ts';
import { setFrustum } from '../../export/runtime/sessions/matrix.ts';
import { castAtDepth, type DepthImage } from '../../export/runtime/spatial/cast/cast-depth.ts';
import { createMeeting, createRay, setRay } from '../../export/runtime/spatial/ray.ts';
import '../support/dom-point.ts';
import { describeWithData } from '../support/shared-data.ts';

// Hit tests on room depth alone, against the geometry that the depth is of.

const WIDTH = 160;
const HEIGHT = 120;
/** Farther from the truth, another surface was hit. */
const WRONG_M = 0.1;

interface Score {
  readonly hits: number;
  /** How many of them are on flat surfaces, where normals are compared. */
  readonly flat: number;
  readonly missed: number;
  readonly wrong: number;
  readonly medianCm: number;
  readonly p95Cm: number;
  readonly normalMedianDeg: number;
  readonly normalP95Deg: number;
}

interface Truth {
  readonly point: Vector3;
  /** Null where the surface is not flat, so that it has no one normal. */
  readonly normal: Vector3 | null;
}

function pictureOf(meters: Float32Array, halfX: number, halfY: number, worldFromView: Matrix4): DepthImage {
  const picture: DepthImage = {
    meters,
    widthPx: WIDTH,
    heightPx: HEIGHT,
    uvFromViewUv: Float32Array.of(1, 0, 0, 0, -1, 0, 0, 1, 1),
    clipFromView: new Float32Array(16),
    worldFromView: new Float32Array(worldFromView.elements),
    frame: 0,
  };
  setFrustum(picture.clipFromView, -halfX, halfX, -halfY, halfY, 0.05, 100);
  return picture;
}

/** Of a point of a view, in world space; its length is that of 1 m along the view's axis. */
function directionAt(u: number, v: number, halfX: number, halfY: number, worldFromView: Matrix4): Vector3 {
  return new Vector3((2 * u - 1) * halfX, (2 * v - 1) * halfY, -1).applyMatrix4(new Matrix4().extractRotation(worldFromView));
}

function quantile(values: readonly number[], share: number): number {
  return [...values].sort((a, b) => a - b)[Math.floor(share * (values.length - 1))] ?? Number.NaN;
}

function scoreOf(
  rays: readonly { readonly origin: Vector3; readonly direction: Vector3; readonly truth: Truth; readonly picture: DepthImage }[],
): Score {
  const ray = createRay();
  const meeting = createMeeting();
  const errors: number[] = [];
  const angles: number[] = [];
  let missed = 0;
  let wrong = 0;
  for (const { origin, direction, truth, picture } of rays) {
    setRay(ray, new Matrix4().lookAt(new Vector3(), direction, new Vector3(0.01, 1, 0.02)).setPosition(origin).elements);
    if (!castAtDepth(meeting, ray, picture)) {
      missed++;
      continue;
    }
    const point = new Vector3(ray.dx, ray.dy, ray.dz).multiplyScalar(meeting.distanceM).add(origin);
    const errorM = point.distanceTo(truth.point);
    if (errorM > WRONG_M) wrong++;
    errors.push(100 * errorM);
    if (truth.normal && errorM <= WRONG_M) {
      const cosine = Math.abs(new Vector3(meeting.nx, meeting.ny, meeting.nz).normalize().dot(truth.normal));
      angles.push((Math.acos(Math.min(1, cosine)) * 180) / Math.PI);
    }
  }
  const rounded = (x: number) => Math.round(x * 100) / 100;
  return {
    hits: errors.length,
    flat: angles.length,
    missed: rounded(missed / rays.length),
    wrong: rounded(wrong / rays.length),
    medianCm: rounded(quantile(errors, 0.5)),
    p95Cm: rounded(quantile(errors, 0.95)),
    normalMedianDeg: rounded(quantile(angles, 0.5)),
    normalP95Deg: rounded(quantile(angles, 0.95)),
  };
}

/** What the issue of hit tests asks for. */
function expectAccuracy(score: Score): void {
  expect(score.medianCm).toBeLessThanOrEqual(1);
  expect(score.p95Cm).toBeLessThanOrEqual(4);
  expect(score.normalMedianDeg).toBeLessThanOrEqual(5);
  expect(score.normalP95Deg).toBeLessThanOrEqual(15);
  expect(score.missed).toBeLessThanOrEqual(0.02);
  expect(score.wrong).toBeLessThanOrEqual(0.02);
}

const HALF_X = 0.6;
const HALF_Y = (HALF_X * HEIGHT) / WIDTH;

/** Depth of a scanned room from where a visitor looks at its floor and furniture, with noise; rays through random points of the view. */
function castInRoom(name: string, noise: Parameters<typeof addDepthNoise>[1]): Score {
  const room = createRoom({ capture: JSON.parse(readFileSync(`node_modules/@iwer/sem/captures/${name}.json`, 'utf8')) });
  const raycaster = new Raycaster();
  const meet = (origin: Vector3, direction: Vector3) => {
    raycaster.set(origin, direction.clone().normalize());
    const [hit] = raycaster.intersectObject(room.solids, true);
    return hit?.point ?? null;
  };
  const rays: Parameters<typeof scoreOf>[0][number][] = [];
  [0, 1.5, 3, 4.5].forEach((yawRad, view) => {
    const worldFromView = new Matrix4().makeRotationY(yawRad).multiply(new Matrix4().makeRotationX(-0.5)).setPosition(0, 1.5, 0);
    const origin = new Vector3(0, 1.5, 0);
    const meters = new Float32Array(WIDTH * HEIGHT);
    for (let row = 0; row < HEIGHT; row++) {
      for (let column = 0; column < WIDTH; column++) {
        const direction = directionAt((column + 0.5) / WIDTH, 1 - (row + 0.5) / HEIGHT, HALF_X, HALF_Y, worldFromView);
        const hit = meet(origin, direction);
        meters[row * WIDTH + column] = hit ? hit.distanceTo(origin) / direction.length() : 0;
      }
    }
    addDepthNoise(meters, noise, `${name}/${view}`);
    const picture = pictureOf(meters, HALF_X, HALF_Y, worldFromView);
    const random = createRandom(view, name);
    for (let i = 0; i < 150; i++) {
      const [column, row] = [Math.floor(WIDTH * (0.05 + 0.9 * random.next())), Math.floor(HEIGHT * (0.05 + 0.9 * random.next()))];
      const directionOf = (x: number, y: number) => directionAt((x + 0.3) / WIDTH, 1 - (y + 0.7) / HEIGHT, HALF_X, HALF_Y, worldFromView);
      const at = (x: number, y: number) => meet(origin, directionOf(x, y));
      const direction = directionOf(column, row);
      const point = at(column, row);
      if (!point || point.distanceTo(origin) > 5) continue;
      rays.push({ origin, direction, truth: { point, normal: normalAt(at, column, row, 4) }, picture });
    }
  });
  room.dispose();
  return scoreOf(rays);
}

describe('hit tests on room depth of 160 × 120 samples', () => {
  test.each(['living_room', 'office_small'])('with the noise of a sensor, in %s', (name) => {
    expectAccuracy(castInRoom(name, { sigmaM: 0.01, sigmaPerM: 0.005, holes: 0.05, seed: 3 }));
  });
});

interface Recording {
  readonly width: number;
  readonly height: number;
  readonly intrinsics: { readonly fx: number; readonly fy: number; readonly cx: number; readonly cy: number };
  readonly frames: readonly { readonly depth: string; readonly cameraToWorld: readonly number[] }[];
}

describeWithData('hit tests on a recorded room', 'sessions/icl-livingroom', (folder) => {
  test('answer by every second frame what the frame after it shows', () => {
    const { width, height, intrinsics, frames } = JSON.parse(readFileSync(join(folder, 'session.json'), 'utf8')) as Recording;
    const { fx, fy, cx, cy } = intrinsics;
    const depthOf = (file: string) => decode(readFileSync(join(folder, file))).data as Uint16Array;
    const poseOf = (rows: readonly number[]) =>
      new Matrix4()
        .fromArray([...rows])
        .transpose()
        .multiply(new Matrix4().makeScale(1, -1, -1));
    const step = width / WIDTH;
    const rays: Parameters<typeof scoreOf>[0][number][] = [];
    for (let i = 0; i + 1 < frames.length; i += 4) {
      const [shown, held] = [frames[i], frames[i + 1]];
      if (!shown || !held) continue;
      const fine = depthOf(shown.depth);
      const meters = Float32Array.from({ length: WIDTH * HEIGHT }, (_, at) => {
        const x = Math.floor(((at % WIDTH) + 0.5) * step);
        const y = Math.floor((Math.floor(at / WIDTH) + 0.5) * step);
        return (fine[y * width + x] ?? 0) / 1000;
      });
      const picture = pictureOf(meters, 1, 1, poseOf(shown.cameraToWorld));
      // Sample (x, y) of the coarse grid is the pixel at its middle, whose center has whole coordinates.
      const u = (x: number) => ((x + 0.5) * step - 0.5 - cx) / fx;
      const v = (y: number) => ((y + 0.5) * step - 0.5 - cy) / fy;
      setFrustum(
        picture.clipFromView,
        u(-0.5) + 0.5 / fx,
        u(WIDTH - 0.5) + 0.5 / fx,
        -(v(HEIGHT - 0.5) + 0.5 / fy),
        -(v(-0.5) + 0.5 / fy),
        0.05,
        100,
      );
      const truthDepth = depthOf(held.depth);
      const pose = poseOf(held.cameraToWorld);
      const at = (x: number, y: number): Vector3 | null => {
        const depth = (truthDepth[y * width + x] ?? 0) / 1000;
        return depth > 0 ? new Vector3(((x - cx) / fx) * depth, (-(y - cy) / fy) * depth, -depth).applyMatrix4(pose) : null;
      };
      const origin = new Vector3().setFromMatrixPosition(pose);
      const random = createRandom(i, 'icl');
      for (let n = 0; n < 40; n++) {
        const x = Math.floor(width * (0.1 + 0.8 * random.next()));
        const y = Math.floor(height * (0.1 + 0.8 * random.next()));
        const point = at(x, y);
        if (!point) continue;
        rays.push({ origin, direction: point.clone().sub(origin), truth: { point, normal: normalAt(at, x, y, 12) }, picture });
      }
    }
    expectAccuracy(scoreOf(rays));
  });
});

/** Of the flat surface around a pixel, by points so many pixels away; null at edges and curves. */
function normalAt(at: (x: number, y: number) => Vector3 | null, x: number, y: number, reach: number): Vector3 | null {
  const [middle, left, right, up, down] = [at(x, y), at(x - reach, y), at(x + reach, y), at(x, y - reach), at(x, y + reach)];
  if (!middle || !left || !right || !up || !down) return null;
  const across = right.clone().sub(left);
  const along = down.clone().sub(up);
  const normal = new Vector3().crossVectors(across, along).normalize();
  const isFlat = [left, right, up, down].every((point) => Math.abs(point.clone().sub(middle).dot(normal)) < 0.006);
  return isFlat ? normal : null;
}
