import {
  BoxGeometry,
  type BufferGeometry,
  DataTexture,
  type Material,
  Matrix4,
  Mesh,
  MeshBasicMaterial,
  MeshLambertMaterial,
  NearestFilter,
  type PerspectiveCamera,
  PlaneGeometry,
  RGBAFormat,
  SphereGeometry,
} from 'three';
import type { LightShadow } from '../../nodes/kit/light-shadow.ts';
import type { LightItem, ObjectItem, ObjectList } from '../../nodes/kit/scene-lists.ts';
import type { SceneLook } from '../../nodes/kit/scene-look.ts';
import type { Writable } from '../../nodes/kit/value-views.ts';
import {
  createStand,
  drawView,
  type ItemOptions,
  item,
  lights,
  loadUrl,
  lookingAt,
  midStride,
  objects,
  pixel,
  project,
  type Stand,
  sun,
  translation,
  viewOf,
} from './scenes-kit.ts';

/** From above and the front; a pixel of the floor is about 1.5 cm. */
const CAMERA = lookingAt([0, 2, 1.2], [0, 0, 0]);

/** As the light's node sets it by default. */
const SHADOW: LightShadow = { areaM: 5, mapSizePx: 2048, bias: 0, normalBiasM: (2.5 * 5) / 2048 };

function slab(geometry: BufferGeometry, options: ItemOptions & { material?: Material } = {}): ObjectItem {
  return item(new Mesh(geometry, options.material ?? new MeshLambertMaterial()), options);
}

const floorGeometry = (): BufferGeometry => new PlaneGeometry(8, 8).rotateX(-Math.PI / 2);
const phantomFloor = (): ObjectItem => slab(floorGeometry(), { role: 'phantom', castsShadow: false });
/** 0.4 m square, 0.5 m above the floor, lying flat. */
const plateGeometry = (): BufferGeometry => new PlaneGeometry(0.4, 0.4).rotateX(-Math.PI / 2);
const plate = (options: ItemOptions & { material?: Material } = {}): ObjectItem =>
  slab(plateGeometry(), { at: translation(0, 0.5, 0), ...options });

interface Shot {
  readonly casters: readonly ObjectItem[];
  readonly receivers: readonly ObjectItem[];
  readonly suns: readonly LightItem[];
  readonly look?: SceneLook;
  readonly camera?: PerspectiveCamera;
  /** Draws without the maps. */
  readonly withoutMaps?: boolean;
}

const CATCH: SceneLook = { kind: 'shadow-catcher', strength: { value: 0.5 }, color: { value: Float64Array.of(0, 0, 0, 1) } };
const SHADE: SceneLook = { kind: 'shaded', ambient: { value: 0 } };

/** One frame as the player draws it: scene and maps updated, then the view. */
function shoot({ backend, layer }: Stand, shot: Shot): Uint8Array {
  const casters: ObjectList = objects(...shot.casters);
  const lightList = lights(...shot.suns);
  const maps = shot.withoutMaps ? null : backend.createShadowMaps([casters], [lightList]);
  const scene = backend.serviceFor({ shadowMaps: maps, occlusion: null }).createScene(shot.look ?? CATCH);
  scene.update([objects(...shot.receivers)], [lightList]);
  maps?.update();
  layer.clear();
  scene.draw(drawView(viewOf(shot.camera ?? CAMERA), layer.framebuffer));
  const pixels = layer.pixels();
  scene.dispose();
  maps?.dispose();
  return pixels;
}

/** The picture's value at points of the floor. */
function onFloor(pixels: Uint8Array, points: Readonly<Record<string, readonly [number, number]>>): Record<string, number[]> {
  return Object.fromEntries(Object.entries(points).map(([name, [x, z]]) => [name, pixel(pixels, ...project(CAMERA, [x, 0, z]))]));
}

/** The plate's shadow at light from the left, (-1, 1, 0): moved by its height to the right, from x 0.3 to 0.7. */
const POINTS = {
  middle: [0.5, 0],
  inNear: [0.34, 0],
  inFar: [0.66, 0.16],
  outNear: [0.26, 0],
  outFar: [0.74, 0.16],
  besideIt: [0.5, 0.24],
  underIt: [0, 0],
  towardsTheLight: [-0.5, 0],
} as const;

export function geometry() {
  const stand = createStand();
  const suns = [sun([-1, 1, 0], { shadow: SHADOW })];
  const caught = shoot(stand, { casters: [plate()], receivers: [phantomFloor(), plate()], suns });
  const floor = slab(floorGeometry());
  const shaded = shoot(stand, { casters: [plate(), floor], receivers: [floor], suns, look: SHADE });
  const lit = shoot(stand, { casters: [], receivers: [floor], suns, look: SHADE });
  // Where the floor is darker than without shadows, and nowhere brighter.
  const red = (pixels: Uint8Array, at: number): number => pixels[at] ?? 0;
  let both = 0;
  let either = 0;
  let brighter = 0;
  for (let at = 0; at < caught.length; at += 4) {
    const inCatcher = (caught[at + 3] ?? 0) > 64;
    const inScene = red(shaded, at) < red(lit, at) / 2;
    if (inCatcher && inScene) both++;
    if (inCatcher || inScene) either++;
    if (red(shaded, at) > red(lit, at) + 1) brighter++;
  }
  return {
    catcher: onFloor(caught, POINTS),
    scene: onFloor(shaded, POINTS),
    agreement: both / either,
    brighter,
    error: stand.gl.getError(),
  };
}

/** Pixels that a surface without anything above it darkens by itself. */
export function acne() {
  const stand = createStand();
  const ball = slab(new SphereGeometry(0.3, 32, 24), { at: translation(0, 0.3, 0) });
  const floor = slab(floorGeometry());
  const result: Record<string, number> = {};
  for (const elevation of [10, 30, 60, 90]) {
    const radians = (elevation * Math.PI) / 180;
    const suns = [sun([0, Math.sin(radians), Math.cos(radians)], { shadow: SHADOW })];
    const shadowed = shoot(stand, { casters: [floor], receivers: [floor], suns, look: SHADE });
    const plain = shoot(stand, { casters: [floor], receivers: [floor], suns, look: SHADE, withoutMaps: true });
    result[`floor at ${elevation}`] = darker(shadowed, plain);
    const ballShadowed = shoot(stand, { casters: [ball], receivers: [ball], suns, look: SHADE });
    const ballPlain = shoot(stand, { casters: [ball], receivers: [ball], suns, look: SHADE, withoutMaps: true });
    result[`ball at ${elevation}`] = darker(ballShadowed, ballPlain, 60);
    const phantom = slab(floorGeometry(), { role: 'phantom', castsShadow: true });
    const caught = shoot(stand, { casters: [phantom], receivers: [phantom], suns });
    result[`phantom at ${elevation}`] = caught.filter((value, i) => i % 4 === 3 && value > 0).length;
  }
  return { ...result, error: stand.gl.getError() };
}

/** Pixels brighter than `from` that became darker by more than a step of 8 bits. */
function darker(picture: Uint8Array, than: Uint8Array, from = 0): number {
  let count = 0;
  for (let at = 0; at < picture.length; at += 4) if ((than[at] ?? 0) > from && (picture[at] ?? 0) < (than[at] ?? 0) - 1) count++;
  return count;
}

/** A box on the floor: alpha of its shadow at these distances from its foot, meters. */
export function contact() {
  const stand = createStand();
  const camera = lookingAt([0.5, 0.35, 0.5], [0.2, 0, 0]);
  const box = slab(new BoxGeometry(0.3, 0.3, 0.3), { at: translation(0, 0.15, 0) });
  const caught = shoot(stand, { casters: [box], receivers: [phantomFloor()], suns: [sun([-1, 1, 0], { shadow: SHADOW })], camera });
  return [0.003, 0.01, 0.05, 0.2].map((meters) => pixel(caught, ...project(camera, [0.15 + meters, 0, 0]))[3]);
}

export function options() {
  const stand = createStand();
  const left = sun([-1, 1, 0], { shadow: SHADOW });
  const right = sun([1, 1, 0], { shadow: SHADOW });
  const plain = sun([1, 1, 0]);
  const receivers = [phantomFloor()];
  const at = (pixels: Uint8Array): number[] => pixel(pixels, ...project(CAMERA, [0.5, 0, 0]));
  const withPlate = (options: Parameters<typeof plate>[0], more: Partial<Shot> = {}): number[] =>
    at(shoot(stand, { casters: [plate(options)], receivers, suns: [left], ...more }));
  const red: SceneLook = { kind: 'shadow-catcher', strength: { value: 1 }, color: { value: Float64Array.of(1, 0, 0, 0.8) } };
  // A low wall before the shadow, seen from the camera.
  const wall = slab(new BoxGeometry(1, 0.3, 0.02), { role: 'phantom', receivesShadow: false, at: translation(0.5, 0.15, 0.1) });
  const holes = new DataTexture(new Uint8Array([255, 255, 255, 0, 255, 255, 255, 255]), 2, 1, RGBAFormat);
  holes.magFilter = NearestFilter;
  holes.needsUpdate = true;
  const half = shoot(stand, {
    casters: [plate({ material: new MeshBasicMaterial({ map: holes, alphaTest: 0.5 }) })],
    receivers,
    suns: [left],
  });
  return {
    strengthAndColor: withPlate({}, { look: red }),
    noCaster: withPlate({ castsShadow: false }),
    noReceiver: withPlate({}, { receivers: [slab(floorGeometry(), { role: 'phantom', receivesShadow: false })] }),
    virtualReceiver: withPlate({}, { receivers: [slab(floorGeometry())] }),
    twoLights: withPlate({}, { suns: [left, right] }),
    oneOfTwoWithoutShadow: withPlate({}, { suns: [left, plain] }),
    fromBelow: withPlate({}, { suns: [sun([-1, -1, 0], { shadow: SHADOW })] }),
    behindWall: withPlate({}, { receivers: [phantomFloor(), wall] }),
    backOfThePlate: withPlate({ at: new Matrix4().makeRotationX(Math.PI).setPosition(0, 0.5, 0) }),
    faint: withPlate({ material: new MeshBasicMaterial({ transparent: true, opacity: 0.3 }) }),
    dense: withPlate({ material: new MeshBasicMaterial({ transparent: true, opacity: 0.7 }) }),
    // The texture's left half is a hole, its right half is not.
    hole: pixel(half, ...project(CAMERA, [0.4, 0, 0])),
    besideTheHole: pixel(half, ...project(CAMERA, [0.6, 0, 0])),
    realOnVirtual: withPlate({ role: 'phantom' }, { receivers: [slab(floorGeometry())], look: SHADE }),
    error: stand.gl.getError(),
  };
}

/** Lights and shadows switched while running. */
export function switching() {
  const stand = createStand();
  const { backend, layer } = stand;
  const light = sun([-1, 1, 0], { shadow: { ...SHADOW } });
  const lightList = lights(light);
  const casters = objects(plate());
  const maps = backend.createShadowMaps([casters], [lightList]);
  const service = backend.serviceFor({ shadowMaps: maps, occlusion: null });
  const catcher = service.createScene(CATCH);
  const shaded = service.createScene(SHADE);
  const floor = objects(slab(floorGeometry()));
  const draw = (): number[] => {
    catcher.update([objects(phantomFloor())], [lightList]);
    shaded.update([floor], [lightList]);
    maps.update();
    return [catcher, shaded].map((scene) => {
      layer.clear();
      scene.draw(drawView(viewOf(CAMERA), layer.framebuffer));
      const [red = 0, , , alpha = 0] = pixel(layer.pixels(), ...project(CAMERA, [0.5, 0, 0]));
      return scene === catcher ? alpha : red;
    });
  };
  const on = draw();
  const { shadow } = light;
  light.shadow = null;
  const off = draw();
  light.shadow = shadow;
  const again = draw();
  (light.shadow as Writable<LightShadow>).mapSizePx = 512;
  const coarser = draw();
  casters.items.length = 0;
  casters.version++;
  const empty = draw();
  lightList.items.length = 0;
  lightList.version++;
  const dark = draw();
  const error = stand.gl.getError();
  catcher.dispose();
  shaded.dispose();
  maps.dispose();
  return { on, off, again, coarser, empty, dark, error };
}

/**
 * The shadow of an animated model, against the model itself pressed onto the floor along the light: intersection over union of
 * the two sets of pixels.
 */
export async function animated(url: string) {
  const stand = createStand();
  const model = await loadUrl(stand.backend, url);
  const { root, at } = midStride(model);
  const light = sun([-1, 1.5, 0.4], { shadow: SHADOW });
  const [x = 0, y = 1, z = 0] = light.towardsLightWorld;
  // Along the light to y = 0.001: x - y·lx/ly, z - y·lz/ly.
  const pressed = new Matrix4().set(1, -x / y, 0, 0, 0, 0, 0, 0.001, 0, -z / y, 1, 0, 0, 0, 0, 1).multiply(at);
  const shadow = shoot(stand, { casters: [item(root, { at })], receivers: [phantomFloor()], suns: [light] });
  const flat = shoot(stand, { casters: [], receivers: [item(root, { at: pressed })], suns: [light], look: { kind: 'shaded' } });
  let both = 0;
  let either = 0;
  for (let i = 3; i < shadow.length; i += 4) {
    const a = (shadow[i] ?? 0) > 64;
    const b = (flat[i] ?? 0) > 0;
    if (a && b) both++;
    if (a || b) either++;
  }
  model.dispose();
  return { overlap: both / either, pixels: either, error: stand.gl.getError() };
}
