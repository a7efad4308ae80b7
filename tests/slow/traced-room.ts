import { expect } from '@jest/globals';
import { PerspectiveCamera, Vector3 } from 'three';
import { flickerBetween, type Shot as MeasuredShot } from '../../export/score/flicker.ts';
import { meanOf } from '../../export/score/mean-of.ts';
import { contrastOf, type ImagePixels, lumaOf, smoothed } from '../../export/score/smooth.ts';
import { paint } from '../browser/glsl-kit.ts';
import type { RgbaImage } from '../support/image.ts';

/** Size of what it sees, pixels. */
export const [WIDTH, HEIGHT] = [240, 180];
const FOV_DEG = 55;

/** A box from one corner to the other, meters, with the gray of its faces. */
type Box = readonly [low: readonly number[], high: readonly number[], gray: number];

/** A room from inside, a table and a box on it. */
export const BOXES: readonly Box[] = [
  [[-2.5, 0, -3], [2.5, 2.6, 2], 0.75],
  [[-0.6, 0, -1.7], [0.5, 0.7, -0.9], 0.55],
  [[-0.1, 0.7, -1.5], [0.15, 1.0, -1.25], 0.35],
];
const LIGHT = new Vector3(0.4, 0.8, 0.45).normalize();

export interface Hit {
  /** Along the ray, whose z is -1 in view space: meters of depth. */
  readonly m: number;
  readonly gray: number;
}

/** What a ray meets first. */
export function trace(eye: Vector3, ray: Vector3): Hit {
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

/** A frame: where it was taken, what it shows and how far that is. */
export interface Shot {
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

/** What a camera at a point (meters) sees that looks at the table. */
export function shoot(x: number, y: number, z: number): Shot {
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

const scored = ({ width, height, data }: RgbaImage): ImagePixels => ({ widthPx: width, heightPx: height, pixels: data });

/** Mean of a square around each pixel. */
export function blurred(image: RgbaImage, radiusPx: number): RgbaImage {
  const mean = smoothed(lumaOf(scored(image)), image.width, image.height, radiusPx);
  return paint(image.width, image.height, (x, y) => {
    const value = mean[y * image.width + x] ?? 0;
    return [value, value, value, 255];
  });
}

/** Mean difference of the strokes from the tone around them, 0 to 255. */
export const contrast = (image: RgbaImage): number => contrastOf(scored(image), 6);

/** Mean difference of two images of a walk, where the earlier one is moved by the true motion; over what both see. */
export function flicker(before: Shot, imageBefore: RgbaImage, now: Shot, imageNow: RgbaImage): number {
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

/** A walk toward the table and to the left, of 17 cm per frame times `stride`. */
export const walk = (stride = 1) =>
  [0, 1, 2, 3].map((i) => shoot(0.5 - 0.08 * stride * i, 1.5 - 0.01 * stride * i, 0.6 - 0.15 * stride * i));
