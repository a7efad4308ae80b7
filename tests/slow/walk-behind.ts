import type { Browser } from 'playwright-core';
import { type BufferGeometry, DoubleSide, Matrix4, Quaternion, Ray, Vector3 } from 'three';
import { mergeGeometries } from 'three/examples/jsm/utils/BufferGeometryUtils.js';
import { MeshBVH } from 'three-mesh-bvh';
import { pixelAt, type RgbaImage } from '../support/image.ts';
import { type Eye, eyesOf } from '../xr/eyes.ts';
import { openXrPage } from '../xr/xr-page.ts';

/** Layer of both eyes, px. */
export const [WIDTH, HEIGHT] = [640, 320] as const;
const EYE_PX = WIDTH / 2;
/** Frames until the visitor stands where the images are taken: those of `enter`, and one that asks for the eyes. */
const FRAMES_BEFORE = 4;

/** Between frames of the page before its session: one takes a second and a half without a GPU. */
const RARELY_MS = 20_000;

/** Above all places. */
const FAR_AWAY = [0, 500, 0] as const;

/** A robot that walks in a captured place. Meters, in the space `local-floor`. */
export interface Walk {
  readonly head: { readonly position: readonly [number, number, number]; readonly pitchRad: number };
  /** Vertical field of view of each eye. */
  readonly fovYRad: number;
  readonly framesPerSecond: number;
  readonly footAt: (timeS: number) => Vector3;
  /** Of the model, which is 0.43 m tall. */
  readonly scale: number;
  readonly sun: { readonly azimuthRad: number; readonly elevationRad: number };
  /** What was photographed. */
  readonly surfaces: readonly BufferGeometry[];
}

/** What a visitor saw in one frame. */
export interface Seen {
  readonly timeS: number;
  readonly layer: RgbaImage;
}

/** Opens a page in the emulated headset, and takes the layer of both eyes in each of some frames, in which the robot has walked on. */
export async function walkPast(
  browser: Browser,
  url: string,
  walk: Walk,
  frames: number,
  /** Of the captures in the page, all of which are awaited. */
  photographs: number,
): Promise<{ readonly eyes: readonly Eye[]; readonly seen: readonly Seen[]; readonly errors: readonly string[] }> {
  const { fovYRad, framesPerSecond, head } = walk;
  const viewport = { width: WIDTH, height: HEIGHT };
  const xr = await openXrPage(browser, url, { device: 'headset', room: null, fovYRad, framesPerSecond }, viewport, '', RARELY_MS);
  // All of them, and what is made of them then. Without `polling`, Playwright looks once per frame of the page.
  await xr.page.waitForFunction(
    (count) => performance.getEntriesByType('resource').filter(({ name }) => /-\d{3}-\w+\.(?:jpg|avif)$/.test(name)).length >= count,
    photographs,
    { polling: 100 },
  );
  await xr.page.waitForLoadState('networkidle');
  // Nothing of the place is in sight of the first frames, at which no test looks.
  await xr.setPose({ position: FAR_AWAY, quaternion: [Math.SQRT1_2, 0, 0, Math.SQRT1_2] });
  await xr.enter();
  await xr.page.waitForLoadState('networkidle');
  await xr.setPose({ position: head.position, quaternion: [Math.sin(head.pitchRad / 2), 0, 0, Math.cos(head.pitchRad / 2)] });
  const eyes = await eyesOf(xr, WIDTH);
  const seen: Seen[] = [];
  for (let i = 0; i < frames; i++) {
    await xr.step();
    seen.push({ timeS: (FRAMES_BEFORE + i) / framesPerSecond, layer: await xr.readLayer() });
  }
  const { errors } = xr;
  await xr.close();
  return { eyes, seen, errors };
}

/** A point of the captured place that an eye sees in a pixel. */
interface Point {
  readonly at: Vector3;
  readonly normal: Vector3;
  /** Along the axis of the eye. */
  readonly depthM: number;
}

/** No part of the robot is farther from its axis, or higher, for a scale of 1; and a box in its middle that it fills. */
const OUTSIDE = { radiusM: 0.18, heightM: 0.45 } as const;
const INSIDE = { radiusM: 0.045, fromM: 0.15, toM: 0.28 } as const;
/** What shadow maps and their soft edges may be off by. */
const SHADOW_EDGE_M = 0.05;
/** Edges of photographs, and of what is drawn, are off by a pixel and a half. */
const EDGE_PX = 1.5;

/** The captured place as the eyes of a visitor see it, computed from its surfaces ray by ray. */
export class TrueView {
  readonly #walk: Walk;
  readonly #tree: MeshBVH;
  readonly #worldFromHead: Quaternion;
  readonly #towardsSun: Vector3;
  /** By the left border of the eye and the place in the layer: several images are judged by the same points. */
  readonly #points = new Map<string, Point | null>();

  constructor(walk: Walk) {
    this.#walk = walk;
    const whole = mergeGeometries(walk.surfaces.map((surface) => surface.clone().deleteAttribute('uv').deleteAttribute('normal')));
    this.#tree = new MeshBVH(whole);
    this.#worldFromHead = new Quaternion().setFromAxisAngle(new Vector3(1, 0, 0), walk.head.pitchRad);
    const { azimuthRad, elevationRad } = walk.sun;
    const level = Math.cos(elevationRad);
    this.#towardsSun = new Vector3(level * Math.sin(azimuthRad), Math.sin(elevationRad), level * Math.cos(azimuthRad));
  }

  /** Null where nothing was captured. */
  pointAt(eye: Eye, x: number, y: number): Point | null {
    const key = `${eye.left} ${x} ${y}`;
    let point = this.#points.get(key);
    if (point === undefined) {
      point = this.#castTo(eye, x, y);
      this.#points.set(key, point);
    }
    return point;
  }

  #castTo({ position, clipFromView, left, width }: Eye, x: number, y: number): Point | null {
    const [p0 = 1, , , , , p5 = 1, , , p8 = 0, p9 = 0] = clipFromView;
    const ahead = new Vector3(((2 * (x + 0.5 - left)) / width - 1 + p8) / p0, (1 - (2 * (y + 0.5)) / HEIGHT + p9) / p5, -1);
    const direction = ahead.applyQuaternion(this.#worldFromHead);
    const hit = this.#tree.raycastFirst(new Ray(new Vector3(...position), direction.clone().normalize()), DoubleSide);
    if (!hit?.face) return null;
    const normal = hit.face.normal.clone();
    if (normal.dot(direction) > 0) normal.negate();
    return { at: hit.point, normal, depthM: hit.distance / direction.length() };
  }

  /** Pixel of the layer and depth of a point for an eye. */
  project({ position, clipFromView, left, width }: Eye, at: Vector3): { readonly x: number; readonly y: number; readonly depthM: number } {
    const inView = at
      .clone()
      .sub(new Vector3(...position))
      .applyQuaternion(this.#worldFromHead.clone().invert());
    const { x, y } = inView.clone().applyMatrix4(new Matrix4().fromArray([...clipFromView]));
    return { x: left + (width * (x + 1)) / 2, y: (HEIGHT * (1 - y)) / 2, depthM: -inView.z };
  }

  /** Whether the light of a point must pass the robot, cannot, or neither is sure. */
  shadowOf({ at, normal }: Point, foot: Vector3): 'dark' | 'light' | 'unsure' {
    const { scale } = this.#walk;
    const probe = new Vector3();
    // Most rays pass far from the robot.
    const [sunX, sunZ] = [this.#towardsSun.x, this.#towardsSun.z];
    const nearest = Math.max(0, ((foot.x - at.x) * sunX + (foot.z - at.z) * sunZ) / (sunX * sunX + sunZ * sunZ));
    const reachM = OUTSIDE.radiusM * scale + SHADOW_EDGE_M;
    if (Math.hypot(at.x + nearest * sunX - foot.x, at.z + nearest * sunZ - foot.z) > reachM) return 'light';
    let isNear = false;
    for (let away = 0.02; away < 2.5; away += 0.02) {
      probe.copy(at).addScaledVector(this.#towardsSun, away).sub(foot);
      const axisM = Math.hypot(probe.x, probe.z);
      const { y } = probe;
      if (axisM < INSIDE.radiusM * scale && y > INSIDE.fromM * scale && y < INSIDE.toM * scale && normal.dot(this.#towardsSun) > 0.3)
        return 'dark';
      isNear ||= axisM < reachM && y > -SHADOW_EDGE_M && y < OUTSIDE.heightM * scale + SHADOW_EDGE_M;
    }
    return isNear ? 'unsure' : 'light';
  }

  /** Where the robot is for an eye: between the two depths. */
  robotDepths(eye: Eye, foot: Vector3): readonly [nearM: number, farM: number] {
    const { scale } = this.#walk;
    const ends = [0, OUTSIDE.heightM * scale].map((y) => this.project(eye, foot.clone().add(new Vector3(0, y, 0))).depthM);
    return [Math.min(...ends) - OUTSIDE.radiusM * scale, Math.max(...ends) + OUTSIDE.radiusM * scale];
  }

  awayFromSun(at: Vector3, foot: Vector3): number {
    return -at.clone().sub(foot).setY(0).dot(this.#towardsSun.clone().setY(0).normalize());
  }
}

/** Images of one frame by pages in which something is left out. */
export interface Images {
  /** Everything but a filter. */
  readonly whole: RgbaImage;
  /** The robot alone. */
  readonly robot: RgbaImage;
  /** The robot is not drawn, but its shadow is. */
  readonly shadow: RgbaImage;
  /** The place alone. */
  readonly place: RgbaImage;
}

export interface Findings {
  /** Pixels of the robot that are surely behind the place, and surely before it; and those that do not show the place, or the robot. */
  readonly hidden: number;
  readonly hiddenWrong: number;
  readonly visible: number;
  readonly visibleWrong: number;
  /** Pixels that the robot surely shades, those that it surely does not, and those that are not so. */
  readonly dark: number;
  readonly darkWrong: number;
  readonly light: number;
  readonly lightWrong: number;
  /** Darkened pixels, those of them higher than 0.3 m, and their mean distance from the robot away from the sun, meters. */
  readonly darkened: number;
  readonly darkenedOnTop: number;
  readonly darkenedAwayM: number;
}

/** Compares what an eye saw, in every second column and row, with what is truly before and behind the robot, and in its shadow. */
export function judge(view: TrueView, eye: Eye, foot: Vector3, { whole, robot, shadow, place }: Images): Findings {
  const found = { hidden: 0, hiddenWrong: 0, visible: 0, visibleWrong: 0, dark: 0, darkWrong: 0, light: 0, lightWrong: 0 };
  const darkened = { count: 0, onTop: 0, awayM: 0 };
  const [nearM, farM] = view.robotDepths(eye, foot);
  for (let y = 2; y < HEIGHT - 2; y += 2) {
    for (let x = eye.left + 2; x < eye.left + eye.width - 2; x += 2) {
      const isRobot = isOpaqueAround(robot, x, y);
      const point = view.pointAt(eye, x, y);
      if (isRobot) {
        const around = AROUND.map(([dx, dy]) => view.pointAt(eye, x + dx, y + dy)?.depthM ?? Infinity);
        if (around.every((depthM) => depthM < nearM)) {
          found.hidden++;
          if (difference(whole, shadow, x, y) > 3) found.hiddenWrong++;
        } else if (around.every((depthM) => depthM > farM)) {
          found.visible++;
          if (difference(whole, robot, x, y) > 6) found.visibleWrong++;
        }
      }
      if (!point || pixelAt(place, x, y)[3] !== 255) continue;
      const lost = brightness(place, x, y) - brightness(shadow, x, y);
      const isDarkened = lost > 12;
      if (isDarkened) {
        darkened.count++;
        if (point.at.y > 0.3) darkened.onTop++;
        darkened.awayM += view.awayFromSun(point.at, foot);
      }
      const light = view.shadowOf(point, foot);
      if (light === 'unsure') continue;
      const around = AROUND.map(([dx, dy]) => view.pointAt(eye, x + dx, y + dy));
      if (!around.every((other) => other && view.shadowOf(other, foot) === light)) continue;
      if (light === 'dark') {
        found.dark++;
        if (lost < 0.15 * brightness(place, x, y)) found.darkWrong++;
      } else {
        found.light++;
        if (difference(shadow, place, x, y) > 2) found.lightWrong++;
      }
    }
  }
  return { ...found, darkened: darkened.count, darkenedOnTop: darkened.onTop, darkenedAwayM: darkened.awayM / darkened.count };
}

/**
 * The part of the pixels of the left eye whose captured point has the same color for the right eye, at its place there, and at the same place
 * of the image.
 */
export function agreement(view: TrueView, [left, right]: readonly Eye[], { data, width, height }: RgbaImage) {
  if (!left || !right) throw new Error('There are not two eyes.');
  const image = { data, width, height };
  let [count, seen, unmoved] = [0, 0, 0];
  for (let y = 2; y < HEIGHT - 2; y += 2) {
    for (let x = 2; x < EYE_PX - 2; x += 2) {
      const point = view.pointAt(left, x, y);
      if (!point) continue;
      const there = view.project(right, point.at);
      const [column, row] = [Math.floor(there.x), Math.floor(there.y)];
      if (column < right.left + 2 || column >= WIDTH - 2 || row < 2 || row >= HEIGHT - 2) continue;
      // What only one eye sees is left out.
      if (Math.abs((view.pointAt(right, column, row)?.depthM ?? 0) - there.depthM) > 0.02) continue;
      count++;
      if (isLike(image, x, y, column, row)) seen++;
      if (isLike(image, x, y, x + EYE_PX, y)) unmoved++;
    }
  }
  return { count, seen: seen / count, unmoved: unmoved / count };
}

/** The mean place of the pixels of an eye in which two images differ. */
export function centerOfChange(eye: Eye, a: RgbaImage, b: RgbaImage): { readonly x: number; readonly y: number; readonly count: number } {
  let [x, y, count] = [0, 0, 0];
  for (let row = 0; row < HEIGHT; row++) {
    for (let column = eye.left; column < eye.left + eye.width; column++) {
      if (difference(a, b, column, row) <= 6) continue;
      x += column + 0.5;
      y += row + 0.5;
      count++;
    }
  }
  return { x: x / count, y: y / count, count };
}

const AROUND = [
  [0, 0],
  [EDGE_PX, 0],
  [-EDGE_PX, 0],
  [0, EDGE_PX],
  [0, -EDGE_PX],
] as const;

function isOpaqueAround(image: RgbaImage, x: number, y: number): boolean {
  return [-1, 0, 1].every((dy) => [-1, 0, 1].every((dx) => pixelAt(image, x + dx, y + dy)[3] === 255));
}

function isLike(image: RgbaImage, x: number, y: number, otherX: number, otherY: number): boolean {
  const [a, b] = [pixelAt(image, x, y), pixelAt(image, otherX, otherY)];
  return [0, 1, 2].every((c) => Math.abs((a[c] ?? 0) - (b[c] ?? 0)) <= 12);
}

function brightness(image: RgbaImage, x: number, y: number): number {
  const [red, green, blue] = pixelAt(image, x, y);
  return red + green + blue;
}

function difference(a: RgbaImage, b: RgbaImage, x: number, y: number): number {
  const [one, other] = [pixelAt(a, x, y), pixelAt(b, x, y)];
  return Math.max(...[0, 1, 2].map((c) => Math.abs((one[c] ?? 0) - (other[c] ?? 0))));
}
