import { type Material, Mesh, MeshLambertMaterial, MeshStandardMaterial, PlaneGeometry, SphereGeometry } from 'three';
import type { LoadedEnvironment } from '../../export/runtime/scene-backend.ts';
import type { EnvironmentLightItem, LightItem, ObjectItem } from '../../nodes/kit/scene-lists.ts';
import type { SceneLook } from '../../nodes/kit/scene-look.ts';
import { writeHdr } from '../../tools/examples/write-hdr.ts';
import { writeExr } from '../support/write-exr.ts';
import {
  createStand,
  difference,
  drawView,
  HEIGHT,
  item,
  lights,
  lookingAt,
  objects,
  pixel,
  type Stand,
  viewOf,
  WIDTH,
} from './scenes-kit.ts';

const SIZE = { widthPx: 32, heightPx: 16 };
const SHADE: SceneLook = { kind: 'shaded', ambient: { value: 1 } };

let made: Stand | null = null;

/** One for all tests: each context compiles its own shaders. */
function sharedStand(): Stand {
  made ??= createStand();
  return made;
}

type Rgb = readonly [number, number, number];

/** A panorama as a function of the direction, sampled at the middle of each pixel, top row first. */
function paint(color: (x: number, y: number, z: number) => Rgb): number[] {
  const { widthPx, heightPx } = SIZE;
  const rgb: number[] = [];
  for (let row = 0; row < heightPx; row++) {
    const elevation = Math.PI * (0.5 - (row + 0.5) / heightPx);
    for (let column = 0; column < widthPx; column++) {
      // The middle lies ahead, towards -z; right of it is +x.
      const azimuth = 2 * Math.PI * ((column + 0.5) / widthPx - 0.5);
      rgb.push(...color(Math.sin(azimuth) * Math.cos(elevation), Math.sin(elevation), -Math.cos(azimuth) * Math.cos(elevation)));
    }
  }
  return rgb;
}

const hdr = (rgb: number[]): ArrayBuffer => writeHdr(SIZE.widthPx, SIZE.heightPx, rgb).buffer;
const exr = (rgb: number[]): ArrayBuffer => writeExr(SIZE.widthPx, SIZE.heightPx, rgb).buffer;

function surround(environment: LoadedEnvironment | null, more: Partial<EnvironmentLightItem> = {}): EnvironmentLightItem {
  return { key: 'sky', kind: 'environment', environment, intensity: 1, rotationRad: 0, visible: false, ...more };
}

/** A white matt plane, 1 m, that faces a direction, and its picture from there: the middle pixel. */
function facing(stand: Stand, towards: Rgb, lamps: readonly LightItem[]): number[] {
  const plane = new Mesh(new PlaneGeometry(), new MeshLambertMaterial());
  plane.lookAt(...towards);
  const [x, y, z] = towards;
  return middle(shoot(stand, [item(plane)], lamps, lookingAt([x, y, z || 1e-4], [0, 0, 0])));
}

function shoot(
  stand: Stand,
  receivers: readonly ObjectItem[],
  lamps: readonly LightItem[],
  camera = lookingAt([0, 0, 1.2], [0, 0, 0]),
): Uint8Array {
  const { backend, layer } = stand;
  const scene = backend.serviceFor({ shadowMaps: null, occlusion: null }).createScene(SHADE);
  scene.update([objects(...receivers)], [lights(...lamps)]);
  layer.clear();
  scene.draw(drawView(viewOf(camera), layer.framebuffer));
  const pixels = layer.pixels();
  scene.dispose();
  return pixels;
}

const middle = (pixels: Uint8Array): number[] => pixel(pixels, WIDTH / 2, HEIGHT / 2);
const ball = (material: Material = new MeshLambertMaterial()): ObjectItem => item(new Mesh(new SphereGeometry(0.5, 48, 32), material));

/** Reds of all pixels of a white matt ball: the least and the greatest. */
export async function furnace() {
  const stand = sharedStand();
  const reds = async (bytes: ArrayBuffer, more: Partial<EnvironmentLightItem> = {}): Promise<[number, number]> => {
    const environment = await stand.backend.loadEnvironment(bytes);
    const pixels = shoot(stand, [ball()], [surround(environment, more)]);
    const seen = pixels.filter((_, i) => i % 4 === 0 && pixels[i + 3] === 255);
    environment.dispose();
    return [Math.min(...seen), Math.max(...seen)];
  };
  const half = paint(() => [0.5, 0.5, 0.5]);
  const canvas = new OffscreenCanvas(SIZE.widthPx, SIZE.heightPx);
  const context = canvas.getContext('2d');
  if (!context) throw new Error('no canvas');
  context.fillStyle = 'rgb(100 100 100)';
  context.fillRect(0, 0, SIZE.widthPx, SIZE.heightPx);
  return {
    hdr: await reds(hdr(half)),
    exr: await reds(exr(half)),
    png: await reds(await (await canvas.convertToBlob()).arrayBuffer()),
    twice: await reds(hdr(half), { intensity: 1.5 }),
    error: stand.gl.getError(),
  };
}

/** Light from the right half of the sky alone: the reds of planes that face it, are turned away, or lie across. */
export async function brightSide() {
  const stand = sharedStand();
  const environment = await stand.backend.loadEnvironment(hdr(paint((x) => (x > 0 ? [0.8, 0.8, 0.8] : [0, 0, 0]))));
  const red = (towards: Rgb, rotationRad = 0): number | undefined => facing(stand, towards, [surround(environment, { rotationRad })])[0];
  const result = {
    right: red([1, 0, 0]),
    left: red([-1, 0, 0]),
    up: red([0, 1, 0]),
    front: red([0, 0, 1]),
    // A quarter turn to the left seen from above brings the light from +x to -z.
    turnedBack: red([0, 0, -1], Math.PI / 2),
    turnedRight: red([1, 0, 0], Math.PI / 2),
    turnedFront: red([0, 0, 1], Math.PI / 2),
  };
  environment.dispose();
  return { ...result, error: stand.gl.getError() };
}

/** Red ahead, green to the right, blue behind, white to the left; dark above 45 degrees, bright gray below. */
const QUARTERS = (x: number, y: number, z: number): Rgb => {
  if (y > 0.71) return [0.1, 0.1, 0.1];
  if (y < -0.71) return [0.6, 0.6, 0.6];
  if (Math.abs(x) < Math.abs(z)) return z < 0 ? [1, 0, 0] : [0, 0, 1];
  return x > 0 ? [0, 1, 0] : [1, 1, 1];
};

const DIRECTIONS: Readonly<Record<string, Rgb>> = {
  ahead: [0, 0, -1],
  right: [1, 0, 0],
  behind: [0, 0, 1],
  left: [-1, 0, 0],
  up: [0.001, 1, 0],
  down: [0.001, -1, 0],
};

/** What is seen of the panorama itself in each direction, and in a mirror that faces each. */
export async function directions(rotationRad: number) {
  const stand = sharedStand();
  const environment = await stand.backend.loadEnvironment(hdr(paint(QUARTERS)));
  const backdrop: Record<string, number[]> = {};
  const mirror: Record<string, number[]> = {};
  for (const [name, [x, y, z]] of Object.entries(DIRECTIONS)) {
    const lamp = surround(environment, { visible: true, rotationRad });
    backdrop[name] = middle(shoot(stand, [], [lamp], lookingAt([3, 2, 1], [3 + x, 2 + y, 1 + z])));
    const chrome = new Mesh(new PlaneGeometry(), new MeshStandardMaterial({ metalness: 1, roughness: 0 }));
    chrome.lookAt(x, y, z);
    mirror[name] = middle(shoot(stand, [item(chrome)], [surround(environment, { rotationRad })], lookingAt([x, y, z], [0, 0, 0])));
  }
  // Behind objects, not before them; and the layer's depth stays empty there.
  const before = middle(shoot(stand, [ball()], [surround(environment, { visible: true }), surround(null)]));
  environment.dispose();
  return { backdrop, mirror, before, error: stand.gl.getError() };
}

/** The same panorama from both formats: pixels of a rough and a smooth ball that differ by more than 1. */
export async function bothFormats() {
  const stand = sharedStand();
  const rgb = paint((x, y, z) => [Math.max(0, x) * 3, 0.3 + 0.2 * y, z > 0.8 ? 20 : 0.05]);
  // HDR keeps 8 bits, so both are given what those 8 bits hold.
  const rounded = rgb.map((value, i) => {
    const base = i - (i % 3);
    const exponent = Math.floor(Math.log2(Math.max(rgb[base] ?? 0, rgb[base + 1] ?? 0, rgb[base + 2] ?? 0))) + 1;
    return (Math.floor((value * 256) / 2 ** exponent) * 2 ** exponent) / 256;
  });
  const pictures: Uint8Array[] = [];
  for (const bytes of [hdr(rounded), exr(rounded)]) {
    const environment = await stand.backend.loadEnvironment(bytes);
    for (const roughness of [0.15, 0.5, 1]) {
      pictures.push(shoot(stand, [ball(new MeshStandardMaterial({ roughness, metalness: 1 }))], [surround(environment)]));
    }
    environment.dispose();
  }
  const differences = [0, 1, 2].map((i) => difference(pictures[i] ?? new Uint8Array(), pictures[i + 3] ?? new Uint8Array()));
  return { differences, bright: Math.max(...(pictures[0] ?? [])), error: stand.gl.getError() };
}

/** What each broken file is refused with. */
export async function refusals() {
  const { backend } = sharedStand();
  const refusal = (bytes: ArrayBuffer): Promise<string> =>
    backend.loadEnvironment(bytes).then(
      () => 'taken',
      (error: Error) => error.message,
    );
  const good = paint(() => [1, 1, 1]);
  const text = (value: string): ArrayBuffer => new TextEncoder().encode(value).buffer as ArrayBuffer;
  return {
    cutHdr: await refusal(hdr(good).slice(0, 900)),
    cutExr: await refusal(exr(good).slice(0, 900)),
    hugeHdr: await refusal(text('#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y 50000 +X 100000\n')),
    turned: await refusal(text('#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n+X 16 -Y 32\n')),
    tiny: await refusal(writeHdr(1, 1, [1, 1, 1]).buffer),
    noise: await refusal(new Uint8Array(500).fill(7).buffer),
    empty: await refusal(new ArrayBuffer(0)),
  };
}

/** Infinite and broken pixels do not spread: the rest of the sky still lights. */
export async function infinities() {
  const stand = sharedStand();
  const rgb = paint(() => [0.5, 0.5, 0.5]);
  rgb[100] = Number.NaN;
  rgb[200] = Number.NEGATIVE_INFINITY;
  const environment = await stand.backend.loadEnvironment(exr(rgb));
  const red = facing(stand, [0, 0, 1], [surround(environment)])[0];
  environment.dispose();
  return red;
}

/** GPU objects before panoramas were there, and after they are gone. */
export async function leaks() {
  const stand = sharedStand();
  const receivers = [ball()];
  const draw = async (): Promise<void> => {
    const environment = await stand.backend.loadEnvironment(hdr(paint(QUARTERS)));
    shoot(stand, receivers, [surround(environment, { visible: true })]);
    environment.dispose();
  };
  await draw();
  const before = stand.backend.counts();
  await draw();
  await draw();
  return { before, after: stand.backend.counts() };
}
