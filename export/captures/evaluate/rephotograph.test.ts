import { expect, test } from '@jest/globals';
import type { CaptureView } from '../../../nodes/kit/capture.ts';
import { rephotograph } from './rephotograph.ts';

/** Turned about y by 40° and tilted, away from the origin. */
const [c, s, e, f] = [Math.cos(0.7), Math.sin(0.7), Math.cos(0.3), Math.sin(0.3)];
const POSE = [c, 0, -s, 0, s * f, e, c * f, 0, s * e, -f, c * e, 0, 2, 1.5, -1, 1];
const AROUND: CaptureView = {
  ...{ file: 'a.png', projection: 'equirectangular', widthPx: 128, heightPx: 64 },
  ...{ fxPx: 128 / (2 * Math.PI), fyPx: 64 / Math.PI, cxPx: 64, cyPx: 32, worldFromCamera: POSE },
};
const FLAT: CaptureView = { file: 'b.png', widthPx: 60, heightPx: 40, fxPx: 50, fyPx: 52, cxPx: 27, cyPx: 22, worldFromCamera: POSE };

type Vector = readonly [x: number, y: number, z: number];

/** A smooth color of each direction in the world, which is all that there is to see. */
function colorOf([x, y, z]: Vector): readonly number[] {
  return [x, y, z].map((axis, i) => Math.round(127.5 + 100 * Math.sin(3 * axis + i)));
}

function worldOf(m: readonly number[], ray: Vector): Vector {
  const along = [0, 1, 2].map((row) => ray.reduce((sum, value, axis) => sum + (m[4 * axis + row] ?? 0) * value, 0));
  const length = Math.hypot(...along);
  return along.map((value) => value / length) as unknown as Vector;
}

function image(
  widthPx: number,
  heightPx: number,
  rayAt: (x: number, y: number) => Vector,
  pose: readonly number[],
): Uint8Array<ArrayBuffer> {
  const pixels = new Uint8Array(4 * widthPx * heightPx);
  for (let i = 0; i < widthPx * heightPx; i++) {
    pixels.set([...colorOf(worldOf(pose, rayAt((i % widthPx) + 0.5, Math.floor(i / widthPx) + 0.5))), 255], 4 * i);
  }
  return pixels;
}

const pinhole = ({ widthPx, heightPx, fxPx, fyPx, cxPx, cyPx, worldFromCamera }: Omit<CaptureView, 'file'>) =>
  image(widthPx, heightPx, (x, y) => [(x - cxPx) / fxPx, (cyPx - y) / fyPx, -1], worldFromCamera);

/** What is ahead (−z) is in the center (docs/CAPTURE-FORMAT.md). */
const around = ({ widthPx, heightPx, worldFromCamera }: CaptureView) =>
  image(
    widthPx,
    heightPx,
    (x, y) => {
      const [longitude, latitude] = [2 * Math.PI * (x / widthPx - 0.5), Math.PI * (0.5 - y / heightPx)];
      return [Math.cos(latitude) * Math.sin(longitude), Math.sin(latitude), -Math.cos(latitude) * Math.cos(longitude)];
    },
    worldFromCamera,
  );

function directions() {
  const left: number[] = [];
  const capture = {
    views: [AROUND, FLAT],
    photo: async (index: number) => (index === 0 ? around(AROUND) : pinhole(FLAT)),
    leaveOut: (index: number) => left.push(index),
    draw: (_method: string, camera: Omit<CaptureView, 'file'>) => pinhole(camera),
  };
  return { capture, left };
}

test('a photograph is drawn by its own pinhole, a 360° photograph by six', async () => {
  const { capture, left } = directions();
  const flat = await (await rephotograph(capture, 1))('lumigraph');
  expect([flat.psnrDb, flat.ssim, flat.chromaError, flat.covered]).toEqual([Infinity, 1, 0, 1]);
  const whole = await (await rephotograph(capture, 0))('lumigraph');
  // Faces are sampled linearly.
  expect(whole.psnrDb).toBeGreaterThan(48);
  expect(whole.ssim).toBeGreaterThan(0.995);
  expect([whole.covered, whole.shown.length]).toEqual([1, 4 * 128 * 64]);
  expect(left).toEqual([1, 0]);
});

test('a pixel of a 360° photograph counts by the angle that it shows', async () => {
  const { capture } = directions();
  const withoutCap = (camera: Omit<CaptureView, 'file'>): Uint8Array<ArrayBuffer> => {
    const pixels = pinhole(camera);
    const { widthPx, fxPx, fyPx, cxPx, cyPx, worldFromCamera: m } = camera;
    for (let i = 0; i < pixels.length / 4; i++) {
      const ray: Vector = [((i % widthPx) + 0.5 - cxPx) / fxPx, (cyPx - Math.floor(i / widthPx) - 0.5) / fyPx, -1];
      const world = worldOf(m, ray);
      // Up along the axis of the camera, whose equator is the middle row.
      if (world.reduce((sum, value, axis) => sum + value * (POSE[4 + axis] ?? 0), 0) > Math.sin(Math.PI / 3))
        pixels.fill(0, 4 * i, 4 * i + 4);
    }
    return pixels;
  };
  const { covered } = await (await rephotograph({ ...capture, draw: (_method, camera) => withoutCap(camera) }, 0))('plain');
  // A cap of 30° around the pole: a sixth of the rows, but (1 − sin 60°) / 2 of all directions. Edges of the cap count as covered.
  expect(covered).toBeCloseTo(1 - (1 - Math.sin(Math.PI / 3)) / 2, 1);
});
