import { readFile } from 'node:fs/promises';
import { join } from 'node:path';
import { describe, expect, test } from '@jest/globals';
import { decode } from 'fast-png';
import sharp from 'sharp';
import { Matrix4, PerspectiveCamera } from 'three';
import { readIsf } from '../../export/glsl/isf/read-isf.ts';
import { linkIsf } from '../../export/glsl/link/link-isf.ts';
import { drawPicture, made, PAGE, paint, toPage } from '../browser/glsl-kit.ts';
import { type Params, SHADERS } from '../browser/shader-library-kit.ts';
import { useModule } from '../support/browser.ts';
import type { RgbaImage } from '../support/image.ts';
import { describeWithData } from '../support/shared-data.ts';
import { blurred, contrast, flicker, HEIGHT, type Shot, shoot, WIDTH, walk } from './traced-room.ts';

const page = useModule(PAGE);
const FILE = 'filters/room-drawing.fs';
const shader = made(readIsf(SHADERS[FILE] ?? '', FILE));
const DEFAULTS: Params = Object.fromEntries(shader.inputs.map(({ name, default: value }) => [name, value as number | readonly number[]]));

async function drawn(shot: Shot, params: Params = {}): Promise<RgbaImage> {
  return drawPicture(page, {
    width: WIDTH,
    height: HEIGHT,
    passes: made(linkIsf(shader, { node: 'test' })),
    pictures: { inputImage: toPage(shot.picture) },
    depths: { room: { width: WIDTH, height: HEIGHT, values: shot.depth } },
    clipFromView: shot.camera.projectionMatrix.toArray(),
    worldFromView: shot.camera.matrixWorld.toArray(),
    params: { ...DEFAULTS, ...params },
  });
}

/** The same strokes on the screen instead: the room is a plane before the viewer that moves with them. */
const onScreen = (shot: Shot): Shot => ({
  ...shot,
  camera: Object.assign(shot.camera.clone(), { matrixWorld: new Matrix4() }),
  depth: shot.depth.map(() => 2),
});

/** Outlines follow the room anyway. */
const STROKES_ALONE = { lines: 0 };

describe.each([
  ['hatching', 0],
  ['charcoal', 1],
] as const)('%s', (_name, medium) => {
  test('stays on the surfaces during a walk, as no strokes on the screen do, and keeps its contrast, as no blurred strokes do', async () => {
    const shots = walk();
    const params = { ...STROKES_ALONE, medium };
    const sums = { room: 0, screen: 0 };
    let last: { readonly room: RgbaImage; readonly screen: RgbaImage } | null = null;
    let first: RgbaImage | null = null;
    for (const [i, shot] of shots.entries()) {
      const images = { room: await drawn(shot, params), screen: await drawn(onScreen(shot), params) };
      first ??= images.room;
      const before = shots[i - 1];
      if (before && last) {
        sums.room += flicker(before, last.room, shot, images.room);
        sums.screen += flicker(before, last.screen, shot, images.screen);
      }
      last = images;
    }
    if (!first || !last) throw new Error('The walk has no steps.');
    expect(sums.room).toBeLessThan(0.5 * sums.screen);
    expect(contrast(last.room)).toBeGreaterThan(0.8 * contrast(first));
    expect(contrast(blurred(last.room, 4))).toBeLessThan(0.8 * contrast(first));
  });

  test('a wall has the order of tones of the layer', async () => {
    const shot = shoot(0, 1.5, 0.6);
    const tones: number[] = [];
    for (const gray of [230, 180, 128, 80, 40]) {
      const flat = { ...shot, depth: shot.depth.map(() => 2), picture: paint(WIDTH, HEIGHT, () => [gray, gray, gray, 255]) };
      const image = await drawn(flat, { ...STROKES_ALONE, medium, brightness: 0 });
      tones.push(image.data.reduce((sum, value, i) => (i % 4 === 0 ? sum + value : sum), 0) / (WIDTH * HEIGHT));
    }
    expect(tones).toEqual([...tones].sort((a, b) => b - a));
    expect((tones[0] ?? 0) - (tones[4] ?? 0)).toBeGreaterThan(100);
  });
});

describeWithData('a recorded living room', 'captures/icl-livingroom', (folder) => {
  test('keeps its tones, by strokes, where the depth is measured', async () => {
    const [width, height] = [320, 240];
    const color = await sharp(join(folder, 'images/00000.jpg')).resize(width, height).ensureAlpha().raw().toBuffer();
    const millimeters = decode(await readFile(join(folder, 'depth/00000.png'))).data;
    // Every second sample of every second row, bottom row first.
    const values = Array.from({ length: 320 * 240 }, (_, i) => {
      const [x, y] = [2 * (i % 320), 2 * (239 - Math.floor(i / 320))];
      return (millimeters[y * 640 + x] ?? 0) / 1000;
    });
    const picture = { width, height, data: new Uint8Array(color) };
    // Focal length 525 px at 640 × 480.
    const camera = new PerspectiveCamera((2 * Math.atan(240 / 525) * 180) / Math.PI, width / height, 0.05, 50);
    camera.updateMatrixWorld(true);
    for (const medium of [0, 1]) {
      const image = await drawPicture(page, {
        width,
        height,
        passes: made(linkIsf(shader, { node: 'test' })),
        pictures: { inputImage: toPage(picture) },
        depths: { room: { width, height, values } },
        clipFromView: camera.projectionMatrix.toArray(),
        worldFromView: camera.matrixWorld.toArray(),
        params: { ...DEFAULTS, medium, smoothPx: 8, lines: 0 },
      });
      const [tones, drawnTones] = [blockMeans(picture, 20), blockMeans(image, 20)];
      expect(correlation(tones, drawnTones)).toBeGreaterThan(0.8);
      expect(contrast(image)).toBeGreaterThan(10);
    }
  });
});

/** Mean luma of each block of pixels. */
function blockMeans({ width, height, data }: RgbaImage, sidePx: number): number[] {
  const columns = width / sidePx;
  const sums = new Array<number>((columns * height) / sidePx).fill(0);
  for (let i = 0; i < width * height; i++) {
    const block = Math.floor(Math.floor(i / width) / sidePx) * columns + Math.floor((i % width) / sidePx);
    const luma = 0.2126 * (data[4 * i] ?? 0) + 0.7152 * (data[4 * i + 1] ?? 0) + 0.0722 * (data[4 * i + 2] ?? 0);
    sums[block] = (sums[block] ?? 0) + luma / sidePx ** 2;
  }
  return sums;
}

/** Correlation coefficient of two lists of equal length. */
function correlation(a: readonly number[], b: readonly number[]): number {
  const mean = (list: readonly number[]) => list.reduce((sum, x) => sum + x, 0) / list.length;
  const [meanA, meanB] = [mean(a), mean(b)];
  const cross = (p: readonly number[], q: readonly number[]) => p.reduce((sum, x, i) => sum + x * (q[i] ?? 0), 0) / p.length;
  const covariance = cross(a, b) - meanA * meanB;
  return covariance / Math.sqrt((cross(a, a) - meanA ** 2) * (cross(b, b) - meanB ** 2));
}
