import { readFile } from 'node:fs/promises';
import { join } from 'node:path';
import { describe, expect, test } from '@jest/globals';
import { decode } from 'fast-png';
import sharp from 'sharp';
import { Matrix4, PerspectiveCamera } from 'three';
import { readIsf } from '../../export/glsl/isf/read-isf.ts';
import { linkIsf } from '../../export/glsl/link/link-isf.ts';
import { lumaOf, smoothed } from '../../export/score/smooth.ts';
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
  const { width, height } = shot.picture;
  return drawPicture(page, {
    width,
    height,
    passes: made(linkIsf(shader, { node: 'test' })),
    pictures: { inputImage: toPage(shot.picture) },
    depths: { room: { width, height, values: shot.depth } },
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

  test('bends around a ball without chevrons', async () => {
    for (const [yaw, pitch] of [
      [0.7, 0.35],
      [1.2, 0.8],
    ] as const) {
      expect(chevrons(await drawn(shootBall(yaw, pitch), { ...STROKES_ALONE, medium }))).toBeLessThan(0.035);
    }
  });

  test('draws strokes on a wall as clear, whatever the direction in which the session began', async () => {
    const [straight, oblique] = [
      await drawn(shootWall(0), { ...STROKES_ALONE, medium }),
      await drawn(shootWall(Math.PI / 4), { ...STROKES_ALONE, medium }),
    ];
    expect(contrast(oblique) / contrast(straight)).toBeGreaterThan(0.85);
  });
});

const BALL = { widthPx: 480, heightPx: 360, fovDeg: 40, radiusM: 0.4, awayM: 1.5 };

/** A gray ball at the origin before nothing, seen from a point at two angles around it, radians. */
function shootBall(yaw: number, pitch: number): Shot {
  const { widthPx, heightPx, fovDeg, radiusM, awayM } = BALL;
  const camera = new PerspectiveCamera(fovDeg, widthPx / heightPx, 0.05, 50);
  camera.position.setFromSphericalCoords(awayM, Math.PI / 2 - pitch, yaw);
  camera.lookAt(0, 0, 0);
  camera.updateMatrixWorld(true);
  const depth = Array.from({ length: widthPx * heightPx }, (_, i) => {
    const [x, y] = fromMiddle(i);
    const a = (x * x + y * y) * (Math.tan((fovDeg * Math.PI) / 360) / (heightPx / 2)) ** 2 + 1;
    const root = awayM ** 2 - a * (awayM ** 2 - radiusM ** 2);
    return root > 0 ? (awayM - Math.sqrt(root)) / a : 0;
  });
  return { camera, depth, picture: paint(widthPx, heightPx, () => [130, 130, 130, 255]) };
}

/** Pixels from the middle of the image of the ball to the center of one of its pixels. */
function fromMiddle(i: number): readonly [number, number] {
  const { widthPx, heightPx } = BALL;
  return [(i % widthPx) + 0.5 - widthPx / 2, Math.floor(i / widthPx) + 0.5 - heightPx / 2];
}

/** Share of the pairs of places on the ball, 16 px apart, between which the direction of the strokes differs by more than 45°. */
function chevrons(image: RgbaImage): number {
  const { width, height } = image;
  const luma = lumaOf({ widthPx: width, heightPx: height, pixels: image.data });
  const { fovDeg, radiusM, awayM } = BALL;
  const ballPx = (radiusM / Math.sqrt(awayM ** 2 - radiusM ** 2) / Math.tan((fovDeg * Math.PI) / 360)) * (height / 2);
  const onBall = luma.map((_, i) => (Math.hypot(...fromMiddle(i)) < ballPx - 6 ? 1 : 0));
  // The structure tensor, as the direction of the gradient at twice its angle: opposite gradients are those of one stroke.
  const tensor = (product: (gx: number, gy: number) => number) =>
    smoothed(
      luma.map((_, i) =>
        onBall[i] ? product((luma[i + 1] ?? 0) - (luma[i - 1] ?? 0), (luma[i + width] ?? 0) - (luma[i - width] ?? 0)) : 0,
      ),
      width,
      height,
      7,
    );
  const [cos, sin] = [tensor((gx, gy) => gx * gx - gy * gy), tensor((gx, gy) => 2 * gx * gy)];
  let [pairs, apart] = [0, 0];
  for (const step of [16, 16 * width]) {
    for (let i = 0; i + step < luma.length; i++) {
      if (!onBall[i] || !onBall[i + step]) continue;
      pairs++;
      // Twice 45° is a right angle.
      if ((cos[i] ?? 0) * (cos[i + step] ?? 0) + (sin[i] ?? 0) * (sin[i + step] ?? 0) < 0) apart++;
    }
  }
  return apart / pairs;
}

/** A gray wall 2 m before a viewer who looks at it, turned from the axes of the session by an angle, radians. */
function shootWall(yaw: number): Shot {
  const shot = shoot(0, 1.5, 0.6);
  const camera = shot.camera.clone();
  camera.rotation.set(0, yaw, 0);
  camera.updateMatrixWorld(true);
  return { camera, depth: shot.depth.map(() => 2), picture: paint(WIDTH, HEIGHT, () => [130, 130, 130, 255]) };
}

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
      // By a few strokes per block, the tone of one drawing varies by chance: the correlation by 0.06.
      const drawings = [];
      for (const turn of [-0.5, 0.2, 0.7, 1.2]) {
        const image = await drawPicture(page, {
          width,
          height,
          passes: made(linkIsf(shader, { node: 'test' })),
          pictures: { inputImage: toPage(picture) },
          depths: { room: { width, height, values } },
          clipFromView: camera.projectionMatrix.toArray(),
          worldFromView: camera.matrixWorld.toArray(),
          params: { ...DEFAULTS, medium, turn, smoothPx: 8, lines: 0 },
        });
        expect(contrast(image)).toBeGreaterThan(10);
        drawings.push(correlation(blockMeans(picture, 20), blockMeans(image, 20)));
      }
      expect(mean(drawings)).toBeGreaterThan(0.8);
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

const mean = (list: readonly number[]) => list.reduce((sum, x) => sum + x, 0) / list.length;

/** Correlation coefficient of two lists of equal length. */
function correlation(a: readonly number[], b: readonly number[]): number {
  const [meanA, meanB] = [mean(a), mean(b)];
  const cross = (p: readonly number[], q: readonly number[]) => p.reduce((sum, x, i) => sum + x * (q[i] ?? 0), 0) / p.length;
  const covariance = cross(a, b) - meanA * meanB;
  return covariance / Math.sqrt((cross(a, a) - meanA ** 2) * (cross(b, b) - meanB ** 2));
}
