import { mkdir, mkdtemp, rm, writeFile } from 'node:fs/promises';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { afterAll, beforeAll, expect, test } from '@jest/globals';
import { PerspectiveCamera, Vector3 } from 'three';
import type { CaptureDocument, CaptureView, Pinhole } from '../../nodes/kit/capture.ts';
import { paint } from '../browser/glsl-kit.ts';
import { useModule } from '../support/browser.ts';
import { encodeImage } from '../support/image.ts';
import type { Rephotograph } from './capture.page.ts';
import { BOXES, trace } from './traced-room.ts';

const base = await mkdtemp(join(tmpdir(), 'scrim-mixed-'));
afterAll(() => rm(base, { recursive: true, force: true }));
const page = useModule('tests/slow/capture.page.ts', { mounts: { '/captures/': base } });

const FOCAL_PX = 260;
const PERSPECTIVE: Pinhole = { widthPx: 320, heightPx: 240, fxPx: FOCAL_PX, fyPx: FOCAL_PX, cxPx: 160, cyPx: 120 };
const AROUND: Pinhole = {
  ...{ projection: 'equirectangular', widthPx: 768, heightPx: 384 },
  ...{ fxPx: 768 / (2 * Math.PI), fyPx: 384 / Math.PI, cxPx: 384, cyPx: 192 },
};

/** Through the center of a pixel from the top left, in the space of the camera. */
function rayThrough({ projection, fxPx, fyPx, cxPx, cyPx }: Pinhole, x: number, y: number): Vector3 {
  const [right, up] = [(x + 0.5 - cxPx) / fxPx, (cyPx - y - 0.5) / fyPx];
  if (projection === undefined) return new Vector3(right, up, -1);
  return new Vector3(Math.sin(right) * Math.cos(up), Math.sin(up), -Math.cos(right) * Math.cos(up));
}

/** A photograph of the room, which wears a pattern of waves, so that places that are off show. */
function photograph(file: string, lens: Pinhole, at: readonly [number, number, number]): { view: CaptureView; png: Uint8Array } {
  const camera = new PerspectiveCamera();
  camera.position.set(...at);
  camera.lookAt(0, 0.7, -1.3);
  camera.updateMatrixWorld(true);
  const picture = paint(lens.widthPx, lens.heightPx, (x, y) => {
    const ray = rayThrough(lens, x, y).transformDirection(camera.matrixWorld);
    const { m, gray } = trace(camera.position, ray);
    const met = camera.position.clone().addScaledVector(ray, m).multiplyScalar(9).toArray();
    const [red, green, blue] = met.map((along) => 255 * gray ** (1 / 2.2) * (0.8 + 0.2 * Math.sin(along)));
    return [red ?? 0, green ?? 0, blue ?? 0, 255];
  });
  return { view: { ...lens, file, worldFromCamera: camera.matrixWorld.elements }, png: encodeImage(picture) };
}

/** The faces of the boxes in squares of about a quarter of a meter. */
function meshOfRoom(): { readonly bytes: Uint8Array; readonly vertexCount: number; readonly triangleCount: number } {
  const positions: number[] = [];
  const indices: number[] = [];
  for (const [low, high] of BOXES) {
    for (let axis = 0; axis < 3; axis++) {
      const [u, v] = [(axis + 1) % 3, (axis + 2) % 3];
      const [columns, rows] = [u, v].map((side) => Math.ceil(((high[side] ?? 0) - (low[side] ?? 0)) / 0.25)) as [number, number];
      for (const end of [low, high]) {
        const first = positions.length / 3;
        for (let i = 0; i < (columns + 1) * (rows + 1); i++) {
          const along = new Vector3().setComponent(axis, end[axis] ?? 0);
          const parts = [(i % (columns + 1)) / columns, Math.floor(i / (columns + 1)) / rows];
          for (const [k, side] of [u, v].entries()) {
            along.setComponent(side, (low[side] ?? 0) + ((high[side] ?? 0) - (low[side] ?? 0)) * (parts[k] ?? 0));
          }
          positions.push(...along.toArray());
        }
        for (let i = 0; i < columns * rows; i++) {
          const corner = first + (i % columns) + Math.floor(i / columns) * (columns + 1);
          indices.push(corner, corner + 1, corner + columns + 1, corner + 1, corner + columns + 2, corner + columns + 1);
        }
      }
    }
  }
  const bytes = new Uint8Array(4 * (positions.length + indices.length));
  new Float32Array(bytes.buffer).set(positions);
  new Uint32Array(bytes.buffer).set(indices, positions.length);
  return { bytes, vertexCount: positions.length / 3, triangleCount: indices.length / 3 };
}

/** Between the two photographs of each kind. */
const TRUTH = photograph('truth.png', PERSPECTIVE, [0.3, 1.45, 0.5]);
const SIDES = [
  photograph('left.png', PERSPECTIVE, [-0.2, 1.4, 0.6]),
  photograph('right.png', PERSPECTIVE, [0.9, 1.5, 0.3]),
  photograph('near.png', AROUND, [0.4, 1.3, 0.2]),
  photograph('far.png', AROUND, [0.1, 1.6, 0.9]),
];

async function writeCapture(name: string, shots: typeof SIDES): Promise<void> {
  const folder = join(base, name);
  await mkdir(folder, { recursive: true });
  const { bytes, ...counts } = meshOfRoom();
  const views = [TRUTH, ...shots].map(({ view }) => view);
  const capture: CaptureDocument = { format: 'scrim-capture', version: 1, mesh: { file: 'mesh.bin', ...counts }, views };
  await writeFile(join(folder, 'capture.json'), JSON.stringify(capture));
  await writeFile(join(folder, 'mesh.bin'), bytes);
  for (const { view, png } of [TRUTH, ...shots]) await writeFile(join(folder, view.file), png);
}

beforeAll(async () => {
  await writeCapture('mixed', SIDES);
  await writeCapture('perspective', SIDES.slice(0, 2));
  await writeCapture('around', SIDES.slice(2));
});

test('perspective and 360° photographs of one capture together show a place as it is from between them', async () => {
  const shots: Rephotograph[] = [];
  for (const name of ['mixed', 'perspective', 'around']) {
    const shot = await page.call<Rephotograph>('rephotograph', `/captures/${name}/`, 0, ['lumigraph'], false);
    expect(shot.error).toBe(0);
    shots.push(shot);
  }
  const [mixed, perspective, around] = shots.map(({ psnr }) => psnr.lumigraph ?? Number.NaN) as [number, number, number];
  expect(shots[0]?.covered).toBeGreaterThan(0.999);
  expect(mixed).toBeGreaterThan(36);
  // Nearly as well as the better kind alone: each photograph is taken for what it is.
  expect(mixed).toBeGreaterThan(Math.max(perspective, around) - 3);
});
