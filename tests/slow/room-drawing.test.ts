import { readFile } from 'node:fs/promises';
import { join } from 'node:path';
import { describe, expect, test } from '@jest/globals';
import { decode } from 'fast-png';
import sharp from 'sharp';
import { Matrix4, PerspectiveCamera, Vector3 } from 'three';
import { readIsf } from '../../export/glsl/isf/read-isf.ts';
import { linkIsf } from '../../export/glsl/link/link-isf.ts';
import { flickerBetween, type Shot as MeasuredShot } from '../../export/score/flicker.ts';
import { meanOf } from '../../export/score/mean-of.ts';
import { contrastOf, type ImagePixels, lumaOf, smoothed } from '../../export/score/smooth.ts';
import { drawPicture, made, PAGE, paint, toPage } from '../browser/glsl-kit.ts';
import { type Params, SHADERS } from '../browser/shader-library-kit.ts';
import { useModule } from '../support/browser.ts';
import type { RgbaImage } from '../support/image.ts';
import { describeWithData } from '../support/shared-data.ts';

const page = useModule(PAGE);
const FILE = 'filters/room-drawing.fs';
const [WIDTH, HEIGHT] = [240, 180];
const FOV_DEG = 55;

/** A box from one corner to the other, meters, with the gray of its faces. */
type Box = readonly [low: readonly number[], high: readonly number[], gray: number];

/** A room from inside, a table and a box on it. */
const BOXES: readonly Box[] = [
  [[-2.5, 0, -3], [2.5, 2.6, 2], 0.75],
  [[-0.6, 0, -1.7], [0.5, 0.7, -0.9], 0.55],
  [[-0.1, 0.7, -1.5], [0.15, 1.0, -1.25], 0.35],
];
const LIGHT = new Vector3(0.4, 0.8, 0.45).normalize();

interface Hit {
  /** Along the ray, whose z is -1 in view space: meters of depth. */
  readonly m: number;
  readonly gray: number;
}

function trace(eye: Vector3, ray: Vector3): Hit {
  let best: Hit = { m: Infinity, gray: 0 };
  BOXES.forEach(([low, high, gray], i) => {
    const [e, r] = [eye.toArray(), ray.toArray()];
    let [enter, leave] = [-Infinity, Infinity];
    let [enterAxis, leaveAxis] = [0, 0];
    for (let axis = 0; axis < 3; axis++) {
      const a = ((low[axis] ?? 0) - (e[axis] ?? 0)) / (r[axis] || 1e-9);
      const b = ((high[axis] ?? 0) - (e[axis] ?? 0)) / (r[axis] || 1e-9);
      if (Math.min(a, b) > enter) [enter, enterAxis] = [Math.min(a, b), axis];
      if (Math.max(a, b) < leave) [leave, leaveAxis] = [Math.max(a, b), axis];
    }
    if (enter > leave) return;
    const inside = i === 0;
    const m = inside ? leave : enter;
    if (m <= 0 || m >= best.m) return;
    const axis = inside ? leaveAxis : enterAxis;
    const normal = new Vector3().setComponent(axis, -Math.sign(r[axis] ?? 1));
    best = { m, gray: gray * (0.35 + 0.65 * Math.max(0, normal.dot(LIGHT))) };
  });
  return best;
}

interface Shot {
  readonly camera: PerspectiveCamera;
  readonly picture: RgbaImage;
  /** Bottom row first. */
  readonly depth: readonly number[];
}

const TAN_HALF = Math.tan(((FOV_DEG / 2) * Math.PI) / 180);

/** The point at 1 m of depth behind the center of a pixel from the top left, view space. */
function rayThrough(x: number, y: number): Vector3 {
  return new Vector3((((x + 0.5) / WIDTH) * 2 - 1) * TAN_HALF * (WIDTH / HEIGHT), (1 - ((y + 0.5) / HEIGHT) * 2) * TAN_HALF, -1);
}

/** What a camera sees that looks at the table. */
function shoot(x: number, y: number, z: number): Shot {
  const camera = new PerspectiveCamera(FOV_DEG, WIDTH / HEIGHT, 0.05, 50);
  camera.position.set(x, y, z);
  camera.lookAt(0, 0.7, -1.3);
  camera.updateMatrixWorld(true);
  const hits = Array.from({ length: WIDTH * HEIGHT }, (_, i) => {
    const away = rayThrough(i % WIDTH, HEIGHT - 1 - Math.floor(i / WIDTH)).applyMatrix4(camera.matrixWorld);
    return trace(camera.position, away.sub(camera.position));
  });
  return {
    camera,
    picture: paint(WIDTH, HEIGHT, (px, py) => {
      const gray = 255 * (hits[(HEIGHT - 1 - py) * WIDTH + px]?.gray ?? 0) ** (1 / 2.2);
      return [gray, gray, gray, 255];
    }),
    depth: hits.map(({ m }) => m),
  };
}

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

const scored = ({ width, height, data }: RgbaImage): ImagePixels => ({ widthPx: width, heightPx: height, pixels: data });

/** Mean of a square around each pixel. */
function blurred(image: RgbaImage, radiusPx: number): RgbaImage {
  const mean = smoothed(lumaOf(scored(image)), image.width, image.height, radiusPx);
  return paint(image.width, image.height, (x, y) => {
    const value = mean[y * image.width + x] ?? 0;
    return [value, value, value, 255];
  });
}

/** Mean difference of the strokes from the tone around them, 0 to 255. */
const contrast = (image: RgbaImage): number => contrastOf(scored(image), 6);

/** Mean difference of two images of a walk, where the earlier one is moved by the true motion; over what both see. */
function flicker(before: Shot, imageBefore: RgbaImage, now: Shot, imageNow: RgbaImage): number {
  const sum = flickerBetween(measured(before), scored(imageBefore), measured(now), scored(imageNow));
  expect(sum.count).toBeGreaterThan(WIDTH * HEIGHT * 0.7);
  return meanOf([sum]);
}

const FOCAL_PX = HEIGHT / 2 / TAN_HALF;

/** Depth with rows from the top. */
function measured({ camera, depth }: Shot): MeasuredShot {
  const depthM = depth.map((_, i) => depth[(HEIGHT - 1 - Math.floor(i / WIDTH)) * WIDTH + (i % WIDTH)] ?? 0);
  const lens = { fxPx: FOCAL_PX, fyPx: FOCAL_PX, cxPx: WIDTH / 2, cyPx: HEIGHT / 2 };
  return { widthPx: WIDTH, heightPx: HEIGHT, camera: lens, worldFromCamera: camera.matrixWorld.elements, depthM };
}

/** A walk toward the table and to the left. */
const walk = () => [0, 1, 2, 3].map((i) => shoot(0.5 - 0.08 * i, 1.5 - 0.01 * i, 0.6 - 0.15 * i));
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
