import { mkdtemp, rm } from 'node:fs/promises';
import { tmpdir } from 'node:os';
import { join, resolve } from 'node:path';
import { afterAll, beforeAll, describe, expect, test } from '@jest/globals';
import { encode } from 'fast-png';
import { Matrix4, PerspectiveCamera, Vector3 } from 'three';
import { PAGE } from '../../tools/examples/paper/book.ts';
import { BOOK_AT, LYING, NEARING } from '../../tools/examples/paper/book-recipe.ts';
import { useBrowser } from '../support/browser.ts';
import { pixelAt, type RgbaImage } from '../support/image.ts';
import { writeProject } from '../support/project-kit.ts';
import { renderLayers } from '../support/render-layers.ts';

const BOOK = resolve(import.meta.dirname, '../../examples/the-world-in-the-book');
const [WIDTH, HEIGHT, FOCAL_PX] = [160, 120, 133];
const GRAY = 128;
/** Distances of the eyes from the middle of the book, in meters: a walk towards it in steps of 5 cm. */
const WALK = Array.from({ length: 26 }, (_, i) => 1.55 - 0.05 * i);

const chromium = useBrowser();
let base = '';
const frames: Record<'inside' | 'open' | 'night' | 'enter', RgbaImage[]> = { inside: [], open: [], night: [], enter: [] };

beforeAll(async () => {
  base = await mkdtemp(join(tmpdir(), 'scrim-book-'));
  const session = join(base, 'session');
  await writeProject(session, { 'session.json': JSON.stringify(walk()), 'gray.png': grayImage() });
  const layers = await renderLayers(chromium.browser, {
    ...{ project: BOOK, session, widthPx: WIDTH, heightPx: HEIGHT, frames: WALK.length },
    layers: Object.keys(frames).map((name) => `${name}-f13.layer`),
  });
  for (const name of Object.keys(frames) as (keyof typeof frames)[]) frames[name].push(...(layers.get(`${name}-f13.layer`) ?? []));
});
afterAll(() => rm(base, { recursive: true, force: true }));

function grayImage(): Uint8Array {
  return encode({ width: WIDTH, height: HEIGHT, channels: 3, depth: 8, data: new Uint8Array(WIDTH * HEIGHT * 3).fill(GRAY) });
}

/** The eyes look at the book, along a line that is perpendicular to its pages. */
function cameraAt(distanceM: number): PerspectiveCamera {
  const camera = new PerspectiveCamera((2 * Math.atan(HEIGHT / 2 / FOCAL_PX) * 180) / Math.PI, WIDTH / HEIGHT, 0.05, 50);
  const away = new Vector3(0, 1, 0).transformDirection(worldFromBook()).multiplyScalar(distanceM);
  camera.position.set(...BOOK_AT).add(away);
  camera.lookAt(...BOOK_AT);
  camera.updateMatrixWorld();
  return camera;
}

function worldFromBook(): Matrix4 {
  const [x, y, z] = LYING.rotationRad;
  return new Matrix4()
    .makeRotationY(y)
    .multiply(new Matrix4().makeRotationX(x))
    .multiply(new Matrix4().makeRotationZ(z))
    .setPosition(...BOOK_AT);
}

function walk() {
  const color = { widthPx: WIDTH, heightPx: HEIGHT, intrinsics: { fxPx: FOCAL_PX, fyPx: FOCAL_PX, cxPx: WIDTH / 2, cyPx: HEIGHT / 2 } };
  return {
    format: 'scrim-session',
    version: 1,
    title: 'Walk',
    color,
    frameRateHz: 10,
    frames: WALK.map((distanceM, i) => ({
      timeS: i / 10,
      color: 'gray.png',
      worldFromCamera: cameraAt(distanceM).matrixWorld.toArray(),
    })),
  };
}

/** Pixels of the mask that show the world, as a share of all, and how many of them are outside of the open book. */
function shown(i: number): { readonly share: number; readonly outside: number } {
  const mask = frames.inside[i];
  if (!mask) throw new Error(`There is no frame ${i}.`);
  const clipFromBook = new Matrix4()
    .multiplyMatrices(cameraAt(WALK[i] ?? 0).projectionMatrix, cameraAt(WALK[i] ?? 0).matrixWorldInverse)
    .multiply(worldFromBook());
  // The leaf reaches as far above the pages as these are wide.
  const corners = [-1, 1].flatMap((x) =>
    [-1, 1].flatMap((z) => [0, PAGE.widthM].map((y) => new Vector3(x * PAGE.widthM, y, (z * PAGE.heightM) / 2).applyMatrix4(clipFromBook))),
  );
  const [xs, ys] = [corners.map(({ x }) => ((x + 1) / 2) * WIDTH), corners.map(({ y }) => ((1 - y) / 2) * HEIGHT)];
  let [count, outside] = [0, 0];
  for (let y = 0; y < HEIGHT; y++) {
    for (let x = 0; x < WIDTH; x++) {
      if (pixelAt(mask, x, y)[3] < 128) continue;
      count++;
      if (x < Math.min(...xs) - 1 || x > Math.max(...xs) + 1 || y < Math.min(...ys) - 1 || y > Math.max(...ys) + 1) outside++;
    }
  }
  return { share: count / (WIDTH * HEIGHT), outside };
}

/** By what factor the light of the room changes blue by red, at what is behind the world in the left page: the median of some points. */
function coolness(i: number): number {
  const [night, open] = [frames.night[i], frames.open[i]];
  if (!night || !open) throw new Error(`There is no frame ${i}.`);
  const camera = cameraAt(WALK[i] ?? 0);
  const factors = [-0.16, -0.12, -0.08].flatMap((x) =>
    [-0.06, 0, 0.06].map((z) => {
      const at = new Vector3(x, 0, z).applyMatrix4(worldFromBook()).project(camera);
      const [after, before] = [night, open].map((image) => {
        const [r, , b] = pixelAt(image, Math.floor(((at.x + 1) / 2) * WIDTH), Math.floor(((1 - at.y) / 2) * HEIGHT));
        return b / r;
      });
      return (after ?? Number.NaN) / (before ?? Number.NaN);
    }),
  );
  return factors.sort((a, b) => a - b)[4] ?? Number.NaN;
}

describe('the world in the book', () => {
  test('shows far away in the pages of the book only, and around them the room is unchanged', () => {
    for (const [i, distanceM] of WALK.entries()) {
      if (distanceM < NEARING.light.farM) continue;
      const { share, outside } = shown(i);
      expect({ outside, few: share < 0.3, some: share > 0.05 }).toEqual({ outside: 0, few: true, some: true });
      expect(pixelAt(frames.enter[i] as RgbaImage, 2, 2).slice(0, 3)).toEqual([GRAY, GRAY, GRAY]);
    }
  });

  test('fills what one sees when one is near, but for the leaf that turns before it', () => {
    const shares = WALK.map((_, i) => shown(i).share);
    expect(shares.at(-1)).toBeGreaterThan(0.8);
    expect(shares.filter((share, i) => share < (shares[i - 1] ?? 0) - 0.1)).toEqual([]);
  });

  test('turns the light of the room colder with each step, smoothly, and from nothing', () => {
    const cool = WALK.map((_, i) => coolness(i));
    const steps = cool.slice(1).map((value, i) => value - (cool[i] ?? 0));
    const total = (cool.at(-1) ?? 0) - (cool[0] ?? 0);
    expect(cool.filter((_, i) => (WALK[i] ?? 0) > NEARING.light.farM)).toEqual(WALK.filter((m) => m > NEARING.light.farM).map(() => 1));
    expect(total).toBeGreaterThan(0.25);
    // A step of 8 bits is 0.02.
    expect(Math.min(...steps)).toBeGreaterThanOrEqual(-0.02);
    console.info(`blue by red: ${cool.map((value) => value.toFixed(2)).join(' ')}`);
    expect(Math.max(...steps) / total).toBeLessThan(0.18);
  });

  test('has its own light: its pixels do not change with the light of the room', () => {
    const far = WALK.findIndex((distanceM) => distanceM < NEARING.light.farM);
    const near = WALK.length - 1;
    // The sky above the horizon, in the upper part of a window and of the whole view.
    const sky = [frames.enter[far], frames.enter[near]].map((image) => {
      let best: readonly number[] = [0, 0, 0];
      for (let y = 0; y < HEIGHT; y++)
        for (let x = 0; x < WIDTH; x++) {
          const pixel = pixelAt(image as RgbaImage, x, y);
          if (pixel[2] - pixel[0] > (best[2] ?? 0) - (best[0] ?? 0)) best = pixel;
        }
      return best;
    });
    expect(sky[1]?.map((value, c) => Math.abs(value - (sky[0]?.[c] ?? 0)) <= 6)).toEqual([true, true, true, true]);
  });
});
