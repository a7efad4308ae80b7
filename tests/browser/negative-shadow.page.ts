import { PlaneGeometry, Vector3 } from 'three';
import { linearFromSrgb } from '../../nodes/kit/color-math.ts';
import type { DirectionalLightItem, ObjectItem } from '../../nodes/kit/scene-lists.ts';
import { MAX_GLOW_SPOTS, type ShadowGlow } from '../../nodes/kit/scene-look.ts';
import { addSpot } from '../../nodes/layer/negative-shadow/glow-spots.ts';
import { createStand, drawView, lights, lookingAt, objects, room, sun, translation, viewOf } from './scenes-kit.ts';
import { thing } from './shadow-kit.ts';

/** The light and the shadow of a plate, drawn to floats, so that nothing is rounded. */

const SIDE = 256;
const CAMERA = lookingAt([0, 3, 0.02], [0, 0, 0], 1);
/** Half a side of the plate, and its height above the floor. */
const HALF_M = 0.12;
const HEIGHT_M = 0.5;
const BASE = [0.055, 0.055, 0.055, 1] as const;

export type Surface = 'plane' | 'mesh' | 'depth' | 'noisy depth';
type Place = readonly [x: number, z: number];
type Towards = readonly [x: number, y: number, z: number];
/** Of a light: where it is, and its irradiance. */
export type Lamp = readonly [towards: Towards, irradiance: number];

const stand = createStand(SIDE, SIDE);
const { gl } = stand;
if (!gl.getExtension('EXT_color_buffer_float')) throw new Error('no floats to draw to');

const framebuffer = (() => {
  const made = gl.createFramebuffer();
  gl.bindFramebuffer(gl.FRAMEBUFFER, made);
  for (const [format, attachment] of [
    [gl.RGBA32F, gl.COLOR_ATTACHMENT0],
    [gl.DEPTH_COMPONENT24, gl.DEPTH_ATTACHMENT],
  ] as const) {
    const texture = gl.createTexture();
    gl.bindTexture(gl.TEXTURE_2D, texture);
    gl.texStorage2D(gl.TEXTURE_2D, 1, format, SIDE, SIDE);
    gl.framebufferTexture2D(gl.FRAMEBUFFER, attachment, gl.TEXTURE_2D, texture, 0);
  }
  return made;
})();

/** A plate above a place of the floor. */
const plate = ([x, z]: Place): ObjectItem =>
  thing(new PlaneGeometry(HALF_M * 2, HALF_M * 2).rotateX(-Math.PI / 2), { at: translation(x, HEIGHT_M, z) });

const isDepth = (surface: Surface): boolean => surface === 'depth' || surface === 'noisy depth';

/** Measured depth differs from the true one by up to 8 mm, another amount in each pixel. */
function noiseM(surface: Surface, i: number): number {
  const random = Math.abs(Math.sin(i * 12.9898) * 43758.5453) % 1;
  return surface === 'noisy depth' ? 0.016 * (random - 0.5) : 0;
}

/** A floor of one surface; that of a scan is uneven by 4 mm. */
function receivers(surface: Surface): ObjectItem[] {
  if (isDepth(surface)) return [];
  const steps = surface === 'mesh' ? 80 : 1;
  const geometry = new PlaneGeometry(4, 4, steps, steps).rotateX(-Math.PI / 2);
  const { position } = geometry.attributes;
  for (let i = 0; surface === 'mesh' && position && i < position.count; i++) position.setY(i, 0.004 * Math.sin(i * 12.9898));
  return [thing(geometry, { role: 'phantom', castsShadow: false })];
}

/** Where the floor is seen through a pixel, from the lower left. */
function floorAt(x: number, y: number): { readonly point: Vector3; readonly meters: number } {
  const eye = CAMERA.position;
  const ray = new Vector3(((x + 0.5) / SIDE) * 2 - 1, ((y + 0.5) / SIDE) * 2 - 1, 0.5).unproject(CAMERA).sub(eye).normalize();
  const far = -eye.y / ray.y;
  const along = new Vector3(0, 0, -1).transformDirection(CAMERA.matrixWorld).dot(ray);
  return { point: eye.clone().addScaledVector(ray, far), meters: far * along };
}

function lampOf([towards, irradiance]: Lamp): DirectionalLightItem {
  const shadow = { areaM: 3, mapSizePx: 1024, bias: 0, normalBiasM: 0.004 };
  return sun(towards, { radiance: irradiance, shadow });
}

/** Linear light of each pixel, from the lower left. */
function draw(surface: Surface, lamps: readonly Lamp[], strength: number, places: readonly Place[] = [[0, 0]]): Float32Array {
  const [casters, lightList] = [objects(...places.map(plate)), lights(...lamps.map(lampOf))];
  const glow: ShadowGlow = {
    on: true,
    color: { value: Float64Array.from(BASE) },
    border: { value: 0.02 },
    count: 0,
    places: new Float32Array(MAX_GLOW_SPOTS * 4),
    sizes: new Float32Array(MAX_GLOW_SPOTS * 4),
  };
  for (const [x, z] of places) {
    const cylinder = { baseWorld: Float32Array.of(x, 0, z), radiusM: HALF_M * Math.SQRT2, heightM: HEIGHT_M };
    for (const light of lightList.items) addSpot(glow, cylinder, light as DirectionalLightItem, { margin: 1, maxStretchM: 3 });
  }
  const meters = Array.from({ length: SIDE * SIDE }, (_, i) => floorAt(i % SIDE, Math.floor(i / SIDE)).meters + noiseM(surface, i));
  const depth = isDepth(surface) ? { room: { depth: { views: [room(gl, SIDE, SIDE, meters)] }, toleranceM: { value: 0.05 } } } : {};
  const maps = stand.backend.createShadowMaps([casters], [lightList]);
  const scene = stand.backend
    .serviceFor({ shadowMaps: maps, occlusion: null })
    .createScene({ kind: 'shadow-catcher', strength: { value: strength }, color: { value: Float64Array.of(0, 0, 0, 1) }, glow, ...depth });
  scene.update([objects(...receivers(surface))], [lightList]);
  maps.update();
  gl.bindFramebuffer(gl.FRAMEBUFFER, framebuffer);
  gl.disable(gl.SCISSOR_TEST);
  gl.colorMask(true, true, true, true);
  gl.depthMask(true);
  gl.clearColor(0, 0, 0, 0);
  gl.clear(gl.COLOR_BUFFER_BIT | gl.DEPTH_BUFFER_BIT);
  scene.draw(drawView(viewOf(CAMERA, { x: 0, y: 0, widthPx: SIDE, heightPx: SIDE }), framebuffer));
  const rgba = new Float32Array(SIDE * SIDE * 4);
  gl.bindFramebuffer(gl.FRAMEBUFFER, framebuffer);
  gl.readPixels(0, 0, SIDE, SIDE, gl.RGBA, gl.FLOAT, rgba);
  scene.dispose();
  maps.dispose();
  return Float32Array.from({ length: SIDE * SIDE }, (_, i) => linearFromSrgb(rgba[i * 4 + 1] ?? 0));
}

function pixelOf(x: number, z: number): number {
  const { x: u, y: v } = new Vector3(x, 0, z).project(CAMERA);
  return Math.floor((v * 0.5 + 0.5) * SIDE) * SIDE + Math.floor((u * 0.5 + 0.5) * SIDE);
}

/** The middle of the plate's shadow by a light. */
const shadowOf = ([x, y, z]: Towards): Place => [(-x / y) * HEIGHT_M, (-z / y) * HEIGHT_M];

/** Light in the middle of each lamp's shadow, as a part of the base; that beside the plate's foot; and the brightest outside all spots. */
export function parts(surface: Surface, lamps: readonly Lamp[], strength: number) {
  const light = draw(surface, lamps, strength);
  const base = linearFromSrgb(BASE[1]);
  return {
    shadows: lamps.map(([towards]) => (light[pixelOf(...shadowOf(towards))] ?? 0) / base),
    lit: (light[pixelOf(0.1, 0.1)] ?? 0) / base,
    outside: Math.max(...light.subarray(0, SIDE * 8), ...light.subarray(SIDE * (SIDE - 8))),
    error: gl.getError(),
  };
}

/** With two plates: light in the middle of the shadow of each, and beside the foot of each, as parts of the base. */
export function twoPlates(surface: Surface, lamp: Lamp, strength: number) {
  const places: readonly Place[] = [
    [-0.45, -0.2],
    [0.45, 0.2],
  ];
  const light = draw(surface, [lamp], strength, places);
  const base = linearFromSrgb(BASE[1]);
  const [dx, dz] = shadowOf(lamp[0]);
  return {
    shadows: places.map(([x, z]) => (light[pixelOf(x + dx, z + dz)] ?? 0) / base),
    lit: places.map(([x, z]) => (light[pixelOf(x + 0.1, z + 0.1)] ?? 0) / base),
    error: gl.getError(),
  };
}

/** The angle between a lamp and the way from the middle of its shadow, by all darkened pixels, to the plate. */
export function directionErrorDeg(surface: Surface, towards: Towards): number {
  const [dark, lit] = [draw(surface, [[towards, 1]], 1), draw(surface, [[towards, 1]], 0)];
  const middle = new Vector3();
  let weights = 0;
  for (let i = 0; i < lit.length; i++) {
    const weight = (lit[i] ?? 0) - (dark[i] ?? 0);
    if (weight <= 0) continue;
    middle.addScaledVector(floorAt(i % SIDE, Math.floor(i / SIDE)).point, weight);
    weights += weight;
  }
  const back = new Vector3(0, HEIGHT_M, 0).sub(middle.divideScalar(weights));
  return (back.angleTo(new Vector3(...towards)) * 180) / Math.PI;
}
