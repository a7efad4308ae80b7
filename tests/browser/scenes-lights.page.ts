import {
  BoxGeometry,
  type BufferGeometry,
  Mesh,
  MeshLambertMaterial,
  NoToneMapping,
  PlaneGeometry,
  PointLight,
  Scene,
  SRGBColorSpace,
  WebGLRenderer,
} from 'three';
import type { LightShadow, LocalLightShadow } from '../../nodes/kit/light-shadow.ts';
import type { LightItem, ObjectItem } from '../../nodes/kit/scene-lists.ts';
import type { SceneLook } from '../../nodes/kit/scene-look.ts';
import {
  bulb,
  createGl,
  createStand,
  drawView,
  HEIGHT,
  type ItemOptions,
  item,
  lights,
  lookingAt,
  objects,
  pixel,
  project,
  readPixels,
  type Stand,
  spot,
  sun,
  translation,
  viewOf,
  WIDTH,
} from './scenes-kit.ts';

/** From straight above: x to the right, z down the picture; a pixel of the floor is about 1.5 cm. */
const CAMERA = lookingAt([0, 2, 0.001], [0, 0, 0]);
const SHADE: SceneLook = { kind: 'shaded', ambient: { value: 0 } };
const CATCH: SceneLook = { kind: 'shadow-catcher', strength: { value: 0.5 }, color: { value: Float64Array.of(0, 0, 0, 1) } };
const LAMP: LocalLightShadow = { mapSizePx: 1024, biasPx: 2.5 };
const SUN: LightShadow = { areaM: 5, mapSizePx: 2048, bias: 0, normalBiasM: (2.5 * 5) / 2048 };

let made: Stand | null = null;

/** One for all tests: each context compiles its own shaders. */
function sharedStand(): Stand {
  made ??= createStand();
  return made;
}

function slab(geometry: BufferGeometry, options: ItemOptions = {}): ObjectItem {
  return item(new Mesh(geometry, new MeshLambertMaterial()), options);
}

const floorGeometry = (): BufferGeometry => new PlaneGeometry(8, 8).rotateX(-Math.PI / 2);
const floor = (): ObjectItem => slab(floorGeometry());
const phantomFloor = (): ObjectItem => slab(floorGeometry(), { role: 'phantom', castsShadow: false });
/** 0.2 m square, lying 0.5 m above the floor. */
const plate = (x = 0, z = 0): ObjectItem => slab(new PlaneGeometry(0.2, 0.2).rotateX(-Math.PI / 2), { at: translation(x, 0.5, z) });

interface Shot {
  readonly lamps: readonly LightItem[];
  readonly receivers: readonly ObjectItem[];
  readonly casters?: readonly ObjectItem[];
  readonly look?: SceneLook;
  readonly reports?: string[];
}

/** One frame as the player draws it. */
function shoot({ backend, layer }: Stand, { lamps, receivers, casters = [], look = SHADE, reports = [] }: Shot): Uint8Array {
  const lightList = lights(...lamps);
  const maps = backend.createShadowMaps([objects(...casters)], [lightList]);
  const report = ({ message }: { message: string }): unknown => reports.push(message);
  const scene = backend.serviceFor({ shadowMaps: maps, occlusion: null, report: report as () => void }).createScene(look);
  scene.update([objects(...receivers)], [lightList]);
  maps.update();
  layer.clear();
  scene.draw(drawView(viewOf(CAMERA), layer.framebuffer));
  const pixels = layer.pixels();
  scene.dispose();
  maps.dispose();
  return pixels;
}

const at = (pixels: Uint8Array, x: number, z = 0): number[] => pixel(pixels, ...project(CAMERA, [x, 0, z]));

/** World x of the middle of the pixel in which a point of the floor is seen. */
function pixelMiddle(x: number): number {
  const [column] = project(CAMERA, [x, 0, 0]);
  // 50 degrees high, 2 m above the floor.
  const metersPerPixel = (2 * 2 * Math.tan((25 * Math.PI) / 180)) / HEIGHT;
  return (column + 0.5 - WIDTH / 2) * metersPerPixel;
}

const PLACES = [0, 0.2, 0.5, 0.8, 1.1];

/** Red of the floor under a bulb of 2 cd, 0.8 m above it, with where it is. */
export function falloff(rangeM: number) {
  const stand = sharedStand();
  const pixels = shoot(stand, { lamps: [bulb([0, 0.8, 0], 2, { rangeM })], receivers: [floor()] });
  return { places: PLACES.map((x) => ({ x: pixelMiddle(x), red: at(pixels, x)[0] })), error: stand.gl.getError() };
}

/** The same by three.js, used as its manual says. */
export function falloffOfThree(rangeM: number) {
  const gl = createGl();
  const renderer = new WebGLRenderer({ canvas: gl.canvas, context: gl });
  renderer.outputColorSpace = SRGBColorSpace;
  renderer.toneMapping = NoToneMapping;
  const scene = new Scene();
  scene.add(new Mesh(floorGeometry(), new MeshLambertMaterial()));
  const light = new PointLight(0xffffff, 2, rangeM);
  light.position.set(0, 0.8, 0);
  scene.add(light);
  renderer.render(scene, CAMERA);
  const pixels = readPixels(gl, WIDTH, HEIGHT);
  renderer.dispose();
  return PLACES.map((x) => at(pixels, x)[0]);
}

/** Where along x the light of a spot begins and ends to be more than half of what it is without an edge. */
export function cone(penumbra: number) {
  const stand = sharedStand();
  const lamp = spot([0, 1, 0], [0, 0, 0], 2, { penumbra });
  const pixels = shoot(stand, { lamps: [lamp], receivers: [floor()] });
  const open = shoot(stand, { lamps: [bulb([0, 1, 0], 2)], receivers: [floor()] });
  const [, row] = project(CAMERA, [0, 0, 0]);
  const columns = Array.from({ length: WIDTH }, (_, x) => x);
  const share = columns.map((x) => linear(pixel(pixels, x, row)[0]) / linear(pixel(open, x, row)[0]));
  return {
    share,
    meters: columns.map(
      (x) => pixelMiddle(0) + ((x - WIDTH / 2) * (pixelMiddle(0.3) - pixelMiddle(0))) / (project(CAMERA, [0.3, 0, 0])[0] - WIDTH / 2),
    ),
    error: stand.gl.getError(),
  };
}

function linear(value = 0): number {
  const x = value / 255;
  return x <= 0.04045 ? x / 12.92 : ((x + 0.055) / 1.055) ** 2.4;
}

const LAMPS = {
  spot: () => spot([0, 1.5, 0], [0, 0, 0], 4, { shadow: LAMP, halfAngleRad: 0.8 }),
  point: () => bulb([0, 1.5, 0], 4, { shadow: LAMP }),
} as const;

/**
 * A plate 0.5 m above the floor under a lamp 1.5 m above it: its shadow is half as large again, 0.15 m to each side of where the
 * ray through its middle meets the floor.
 */
export function lampShadow(kind: keyof typeof LAMPS) {
  const stand = sharedStand();
  const points = (pixels: Uint8Array) => ({
    middle: at(pixels, 0.6),
    inside: at(pixels, 0.47),
    insideFar: at(pixels, 0.73),
    outside: at(pixels, 0.42),
    outsideFar: at(pixels, 0.78),
    beside: at(pixels, 0.6, 0.18),
    mirrored: at(pixels, -0.6),
  });
  // The middle at x 0.4 is thrown to 0.4 · 1.5 / 1 = 0.6.
  const casters = [plate(0.4)];
  const ground = floor();
  const caught = shoot(stand, { lamps: [LAMPS[kind]()], receivers: [phantomFloor()], casters, look: CATCH });
  const shaded = shoot(stand, { lamps: [LAMPS[kind]()], receivers: [ground], casters: [...casters, ground] });
  const plain = shoot(stand, { lamps: [LAMPS[kind]()], receivers: [ground] });
  return { catcher: points(caught), scene: points(shaded), lit: points(plain), error: stand.gl.getError() };
}

/** Pixels that a floor and a box darken by themselves, and that a phantom floor catches of itself. */
export function acne(kind: keyof typeof LAMPS) {
  const stand = sharedStand();
  const ground = floor();
  const lamps = [LAMPS[kind]()];
  const shadowed = shoot(stand, { lamps, receivers: [ground], casters: [ground] });
  const plain = shoot(stand, { lamps, receivers: [ground] });
  const phantom = slab(floorGeometry(), { role: 'phantom', castsShadow: true });
  const caught = shoot(stand, { lamps, receivers: [phantom], casters: [phantom], look: CATCH });
  let darker = 0;
  for (let i = 0; i < plain.length; i += 4) if ((shadowed[i] ?? 0) < (plain[i] ?? 0) - 1) darker++;
  return { darker, caught: caught.filter((value, i) => i % 4 === 3 && value > 0).length, error: stand.gl.getError() };
}

/** A point light throws shadows to all sides: plates around it, walls around those; the walls' reds behind the plates and beside. */
export function allSides() {
  const stand = sharedStand();
  const light = bulb([0, 0, 0], 4, { shadow: LAMP });
  const sides = { '+x': [1, 0, 0], '-x': [-1, 0, 0], '+y': [0, 1, 0], '-y': [0, -1, 0], '+z': [0, 0, 1], '-z': [0, 0, -1] } as const;
  const result: Record<string, [number | undefined, number | undefined]> = {};
  for (const [name, [x, y, z]] of Object.entries(sides)) {
    // A box of 0.2 m at 0.5 m, and a wall at 1 m, seen from the light.
    const box = slab(new BoxGeometry(0.2, 0.2, 0.2), { at: translation(x * 0.5, y * 0.5, z * 0.5) });
    const wall = slab(new BoxGeometry(3, 3, 3), { at: translation(x * 2.5, y * 2.5, z * 2.5) });
    const camera = lookingAt([x === 0 ? 0.001 : 0, 0, 0], [x, y, z === 0 && x === 0 ? 0.0001 : z]);
    const list = lights(light);
    const maps = stand.backend.createShadowMaps([objects(box, wall)], [list]);
    const scene = stand.backend.serviceFor({ shadowMaps: maps, occlusion: null }).createScene(SHADE);
    scene.update([objects(wall)], [list]);
    maps.update();
    stand.layer.clear();
    scene.draw(drawView(viewOf(camera), stand.layer.framebuffer));
    const pixels = stand.layer.pixels();
    // The shadow is 0.25 m to each side (the box's near face at 0.4 m): at 0 it is dark, at 0.42 m not.
    result[name] = [pixel(pixels, WIDTH / 2, HEIGHT / 2)[0], pixel(pixels, WIDTH / 2 + 54, HEIGHT / 2)[0]];
    scene.dispose();
    maps.dispose();
  }
  return { result, error: stand.gl.getError() };
}

/** Several lamps at once, each behind a plate of its own: alpha of the shadow layer, and the scene, at each shadow and between. */
export function several() {
  const stand = sharedStand();
  const lamps = [
    spot([-0.6, 1.5, 0], [-0.6, 0, 0], 3, { shadow: LAMP }),
    bulb([0.6, 1.5, 0], 3, { shadow: LAMP }),
    sun([0, 1, 0], { shadow: SUN, radiance: 1 }),
  ];
  const casters = [plate(-0.6), plate(0.6)];
  const ground = floor();
  const caught = shoot(stand, { lamps, receivers: [phantomFloor()], casters, look: CATCH });
  const shaded = shoot(stand, { lamps, receivers: [ground], casters: [...casters, ground] });
  const places = { underSpot: -0.6, between: 0, underBulb: 0.6 };
  return {
    catcher: Object.fromEntries(Object.entries(places).map(([name, x]) => [name, at(caught, x)[3]])),
    scene: Object.fromEntries(Object.entries(places).map(([name, x]) => [name, at(shaded, x)[0]])),
    error: stand.gl.getError(),
  };
}

/** Seven lights with shadows: what is told, and whether the floor under the plate is still lit by the last. */
export function tooMany() {
  const stand = sharedStand();
  const reports: string[] = [];
  const lamps = Array.from({ length: 7 }, () => bulb([0, 1.5, 0], 0.5, { shadow: { mapSizePx: 64, biasPx: 2.5 } }));
  const ground = floor();
  const pixels = shoot(stand, { lamps, receivers: [ground], casters: [plate()], reports });
  const one = shoot(stand, { lamps: [bulb([0, 1.5, 0], 0.5)], receivers: [ground] });
  return { reports, seven: at(pixels, 0)[0], one: at(one, 0)[0], error: stand.gl.getError() };
}

/** GPU objects before lamps with shadows were there, and after they are gone. */
export function leaks() {
  const stand = sharedStand();
  const [ground, phantom, casters] = [[floor()], [phantomFloor()], [plate()]];
  const draw = (): void => {
    shoot(stand, { lamps: [LAMPS.spot(), LAMPS.point()], receivers: ground, casters });
    shoot(stand, { lamps: [LAMPS.spot(), LAMPS.point()], receivers: phantom, casters, look: CATCH });
  };
  draw();
  const before = stand.backend.counts();
  draw();
  draw();
  return { before, after: stand.backend.counts() };
}
