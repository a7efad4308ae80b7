import { BoxGeometry, type BufferGeometry, type PerspectiveCamera, Vector3 } from 'three';
import { mergeGeometries } from 'three/addons/utils/BufferGeometryUtils.js';
import type { LightItem } from '../../nodes/kit/scene-lists.ts';
import { createCasterStrokes } from '../../nodes/layer/shadow/strokes.ts';
import { lookingAt, objects, room, sun } from './scenes-kit.ts';
import { desk, type Shot, SIDES, SUN, shoot, stand, thing } from './shadow-kit.ts';

/** Strokes of the shadow of a box of 0.3 m on a desk, read at points of the desk. */

const { widthPx: WIDTH, heightPx: HEIGHT } = SIDES;
const ABOVE = lookingAt([0.2, 1.6, 0.01], [0.2, 0, 0], WIDTH / HEIGHT);
const TALL = [0.3, 0.6, 0.3] as const;

const BOX = new BoxGeometry(...TALL).translate(0, TALL[1] / 2, 0);

/** A table with one thick leg in its middle. Its cylinder contains the floor below it. */
const TABLE = mergeGeometries([
  new BoxGeometry(0.16, 0.7, 0.3).translate(0, 0.35, 0),
  new BoxGeometry(0.8, 0.04, 0.8).translate(0, 0.72, 0),
]);

/** A board with a slanted upper edge, of which a point is here. */
const SLANTED = { at: [0, 0.45, 0.1], along: [0, 0.5, -0.866] } as const;
const BOARD = new BoxGeometry(0.02, 0.4, 0.6)
  .translate(0, -0.2, 0)
  .rotateX(Math.PI / 6)
  .translate(...SLANTED.at);

function shadowOf(
  lights: readonly LightItem[],
  camera: PerspectiveCamera,
  contour = 0,
  shape: BufferGeometry = BOX,
  real: Pick<Shot, 'room'> = {},
): Uint8Array {
  const box = thing(shape);
  const sketch = createCasterStrokes({
    spacingPx: { value: 7 },
    turn: { value: 0.3 },
    contour: { value: contour },
    contactM: { value: 0.15 },
  });
  sketch.update([objects(box)]);
  const shot = {
    casters: [box],
    receivers: [desk()],
    lights,
    method: 'map',
    strength: 1,
    camera,
    strokes: sketch.strokes,
    ...real,
  } as const;
  return shoot(stand, shot);
}

/** Light from the left: the shadow lies on the right of the box, from x = 0.15 m to 0.66 m. */
const SIDEWARD = sun([-1, 1.2, 0], { shadow: SUN });
const ACROSS = sun([-1, 1.2, 0.0001], { shadow: SUN, radiance: 1e-4 });

/** Alpha at a point of the desk, from 0 to 1. */
function inkAt(pixels: Uint8Array, camera: PerspectiveCamera, x: number, z: number): number {
  const { x: u, y: v } = new Vector3(x, 0, z).project(camera);
  const at = (Math.floor((v * 0.5 + 0.5) * HEIGHT) * WIDTH + Math.floor((u * 0.5 + 0.5) * WIDTH)) * 4;
  return (pixels[at + 3] ?? 0) / 255;
}

function* places(fromX: number, toX: number): Generator<readonly [number, number]> {
  for (let x = fromX; x < toX; x += 0.003) for (let z = -0.12; z < 0.12; z += 0.003) yield [x, z];
}

/** Mean ink of an image between two distances from the middle. */
function meanInk(pixels: Uint8Array, fromX: number, toX: number): number {
  const all = [...places(fromX, toX)].map(([x, z]) => inkAt(pixels, ABOVE, x, z));
  return all.reduce((sum, ink) => sum + ink, 0) / all.length;
}

/** Mean ink in the shadow near the box and far from it, and beyond the shadow. */
export function density() {
  const pixels = shadowOf([SIDEWARD], ABOVE);
  return { near: meanInk(pixels, 0.18, 0.26), far: meanInk(pixels, 0.5, 0.6), beyond: meanInk(pixels, 0.72, 0.85) };
}

/** Mean ink in the shadow of a table under a light from above: at the foot of its leg, and below its top. */
export function belowTable() {
  const pixels = shadowOf([sun([-0.25, 1, 0], { shadow: SUN })], ABOVE, 0, TABLE);
  return { foot: meanInk(pixels, 0.085, 0.125), top: meanInk(pixels, 0.3, 0.4) };
}

/** Correlation of the ink at points of the desk, as seen by two cameras; and of the ink at the same pixels of both images. */
export function anchored() {
  const cameras = [
    lookingAt([0.5, 1.3, 0.5], [0.4, 0, 0], WIDTH / HEIGHT),
    lookingAt([0.25, 1.35, 0.45], [0.36, 0, 0.03], WIDTH / HEIGHT),
  ] as const;
  const [first, second] = cameras.map((camera) => shadowOf([SIDEWARD], camera));
  if (!first || !second) throw new Error('There are two images.');
  const points = [...places(0.25, 0.55)];
  const a = points.map(([x, z]) => inkAt(first, cameras[0], x, z));
  return {
    onDesk: correlation(
      a,
      points.map(([x, z]) => inkAt(second, cameras[1], x, z)),
    ),
    onScreen: correlation(
      a,
      points.map(([x, z]) => inkAt(second, cameras[0], x, z)),
    ),
  };
}

function correlation(a: readonly number[], b: readonly number[]): number {
  const mean = (values: readonly number[]): number => values.reduce((sum, value) => sum + value, 0) / values.length;
  const [meanA, meanB] = [mean(a), mean(b)];
  const dot = (u: readonly number[], mu: number, v: readonly number[], mv: number): number =>
    u.reduce((sum, value, i) => sum + (value - mu) * ((v[i] ?? 0) - mv), 0);
  return dot(a, meanA, b, meanB) / Math.sqrt(dot(a, meanA, a, meanA) * dot(b, meanB, b, meanB));
}

/** Direction of the strokes in the shadow of a light, radians from 0 to π, where it is the first light and where it is the second. */
export function directions(): readonly number[] {
  return [[SIDEWARD], [ACROSS, SIDEWARD]].map((lights) => {
    const pixels = shadowOf(lights, ABOVE);
    let [xx, xz, zz] = [0, 0, 0];
    const step = 0.004;
    for (const [x, z] of places(0.22, 0.55)) {
      const dx = inkAt(pixels, ABOVE, x + step, z) - inkAt(pixels, ABOVE, x - step, z);
      const dz = inkAt(pixels, ABOVE, x, z + step) - inkAt(pixels, ABOVE, x, z - step);
      xx += dx * dx;
      xz += dx * dz;
      zz += dz * dz;
    }
    // The main direction of the structure tensor is across the strokes.
    return (0.5 * Math.atan2(2 * xz, xx - zz) + 2 * Math.PI) % Math.PI;
  });
}

/** Ink at the border of the shadow, with and without a contour. */
export function borders(): readonly number[] {
  return [0, 1].map((contour) => {
    const pixels = shadowOf([SIDEWARD], ABOVE, contour);
    let ink = 0;
    let count = 0;
    for (let x = 0.25; x < 0.55; x += 0.004) {
      let most = 0;
      for (let z = 0.13; z < 0.17; z += 0.002) most = Math.max(most, inkAt(pixels, ABOVE, x, z));
      ink += most;
      count++;
    }
    return ink / count;
  });
}

/**
 * Real bars of a pixel's width near the camera hide every third column of the shadow: how many pixels of the other columns differ from
 * those without bars, of how many with ink.
 */
export function besideBars(): { readonly changed: number; readonly inked: number } {
  const isBar = (x: number): boolean => x % 3 === 0;
  const meters = Array.from({ length: WIDTH * HEIGHT }, (_, i) => (isBar(i % WIDTH) ? 0.3 : 0));
  const bars = room(stand.gl, WIDTH, HEIGHT, meters);
  const hidden = shadowOf([SIDEWARD], ABOVE, 1, BOX, { room: { depth: { views: [bars] }, toleranceM: { value: 0.05 } } });
  const free = shadowOf([SIDEWARD], ABOVE, 1);
  stand.gl.deleteTexture(bars.texture);
  let [changed, inked] = [0, 0];
  for (let i = 0; i < WIDTH * HEIGHT; i++) {
    if (isBar(i % WIDTH)) continue;
    if ((free[4 * i + 3] ?? 0) > 0) inked++;
    if (free[4 * i + 3] !== hidden[4 * i + 3]) changed++;
  }
  return { changed, inked };
}

/** How far the outer side of the contour of a slanted edge strays from a straight line, and the size of a texel of the map, in pixels. */
export function straying(): { readonly strayPx: number; readonly texelPx: number } {
  const mapSizePx = 128;
  const towards = [-1, 1.2, 0] as const;
  const drawn = shadowOf([sun(towards, { shadow: { ...SUN, mapSizePx, normalBiasM: 0 } })], ABOVE, 1, BOARD);
  const pxPerM = HEIGHT / (2 * 1.6 * Math.tan((ABOVE.fov * Math.PI) / 360));
  const onDesk = ({ x, y, z }: Vector3): Vector3 => new Vector3(x - (y / towards[1]) * towards[0], 0, z);
  const [from, to] = [-0.12, 0.12].map((t) => onDesk(new Vector3(...SLANTED.along).multiplyScalar(t).add(new Vector3(...SLANTED.at))));
  if (!from || !to) throw new Error('A line has two points.');
  const inward = new Vector3(to.z - from.z, 0, from.x - to.x).normalize();
  if (inward.x > 0) inward.negate();
  const strays = Array.from({ length: 80 }, (_, i) => {
    const on = from.clone().lerp(to, i / 79);
    const step = 0.1;
    for (let px = -20; px < 20; px += step) {
      const { x, z } = on.clone().addScaledVector(inward, px / pxPerM);
      if (smoothInkAt(drawn, x, z) > 0.5) return px;
    }
    throw new Error('There is no contour.');
  });
  const mean = strays.reduce((sum, px) => sum + px, 0) / strays.length;
  return { strayPx: Math.sqrt(strays.reduce((sum, px) => sum + (px - mean) ** 2, 0) / strays.length), texelPx: (2 / mapSizePx) * pxPerM };
}

/** Alpha at a point of the desk, interpolated between four pixels. */
function smoothInkAt(pixels: Uint8Array, x: number, z: number): number {
  const { x: u, y: v } = new Vector3(x, 0, z).project(ABOVE);
  const [column, row] = [(u * 0.5 + 0.5) * WIDTH - 0.5, (v * 0.5 + 0.5) * HEIGHT - 0.5];
  const [left, foot] = [Math.floor(column), Math.floor(row)];
  const [a, b] = [column - left, row - foot];
  const at = (dx: number, dy: number): number => (pixels[((foot + dy) * WIDTH + left + dx) * 4 + 3] ?? 0) / 255;
  return (1 - b) * ((1 - a) * at(0, 0) + a * at(1, 0)) + b * ((1 - a) * at(0, 1) + a * at(1, 1));
}

export function error(): number {
  return stand.gl.getError();
}
