import { BoxGeometry, Color, DataTexture, Matrix4, Mesh, MeshLambertMaterial, PlaneGeometry, Vector3 } from 'three';
import type { LightShadow, LocalLightShadow, ShadowFilter } from '../../nodes/kit/light-shadow.ts';
import type { LightItem, ObjectItem } from '../../nodes/kit/scene-lists.ts';
import { definition as directional } from '../../nodes/light/directional/definition.ts';
import { create as createDirectional } from '../../nodes/light/directional/runtime.ts';
import { bulb, drawView, lights, lookingAt, objects, pixel, spot, sun, translation, viewOf } from '../browser/scenes-kit.ts';
import { desk, type Method, SIDES, shoot, stand, thing } from '../browser/shadow-kit.ts';
import { fakeContext } from '../support/node-context.ts';
import { BLOCK, look, measuredRoom, ROOM_CAMERA } from './block-room.ts';

/** Straight down from 2 m: a pixel of the floor is 5.2 mm. */
const ABOVE = lookingAt([0, 2, 1e-3], [0, 0, 0]);
const METERS_PER_PX = (4 * Math.tan((25 * Math.PI) / 180)) / SIDES.heightPx;

/** A plate whose right edge stands over x = 0, so high above the floor. */
function plateAt(heightM: number): ObjectItem {
  const geometry = new PlaneGeometry(0.6, 1.2).rotateX(-Math.PI / 2).translate(-0.3, 0, 0);
  return thing(geometry, { at: translation(0, heightM, 0) });
}

/** Mean alpha of the floor from left to right, over rows in the middle; the plate itself is not drawn. */
function profile(pixels: Uint8Array): number[] {
  return Array.from({ length: SIDES.widthPx }, (_, x) => {
    let sum = 0;
    for (let y = SIDES.heightPx / 2 - 40; y < SIDES.heightPx / 2 + 40; y++) sum += pixel(pixels, x, y, SIDES.widthPx)[3] ?? 0;
    return sum / 80 / 255;
  });
}

/** Where a falling profile crosses a value, meters to the right of the middle. */
function crossing(alphas: readonly number[], value: number): number {
  for (let x = Math.floor(SIDES.widthPx * 0.3); x + 1 < alphas.length; x++) {
    const [here = 0, next = 0] = [alphas[x], alphas[x + 1]];
    if (here >= value && next < value) return (x + 0.5 + (here - value) / (here - next) - SIDES.widthPx / 2) * METERS_PER_PX;
  }
  return Number.NaN;
}

const sunny = (filter: ShadowFilter, more: Partial<LightShadow> = {}): LightItem =>
  sun([0, 1, 0], { shadow: { areaM: 4, mapSizePx: 256, bias: 0, normalBiasM: (2.5 * 4) / 256, filter, ...more } });

function cast(light: LightItem, heightM: number): number[] {
  return profile(
    shoot(stand, { casters: [plateAt(heightM)], receivers: [desk()], lights: [light], method: 'map', camera: ABOVE, strength: 1 }),
  );
}

/** One texel of the map is 15.6 mm: how wide each filter makes an edge, where it lies, and how many tones it has. */
export function edges() {
  const filters: readonly ShadowFilter[] = ['basic', 'pcf', 'soft', 'vsm', 'pcss'];
  return Object.fromEntries(
    filters.map((filter) => {
      const alphas = cast(sunny(filter, { sourceRad: 0.2 }), 0.4);
      return [
        filter,
        {
          inside: alphas[Math.floor(SIDES.widthPx * 0.35)],
          outside: alphas[Math.floor(SIDES.widthPx * 0.75)],
          middle: crossing(alphas, 0.5),
          width: crossing(alphas, 0.1) - crossing(alphas, 0.9),
          error: stand.gl.getError(),
        },
      ];
    }),
  );
}

/** Widths of the penumbra from a tenth to nine tenths, of a plate at several heights. */
export function penumbras(kind: 'sun' | 'lamp', sourceSize: number, heights: readonly number[], lampHeightM = 0) {
  const lamp: LocalLightShadow = { mapSizePx: 1024, biasPx: 2, filter: 'pcss', sourceM: sourceSize };
  const light =
    kind === 'sun'
      ? sunny('pcss', { sourceRad: sourceSize, mapSizePx: 1024, normalBiasM: 0.01 })
      : spot([0, lampHeightM, 0], [0, 0, 0], 30, { shadow: lamp, halfAngleRad: 0.6 });
  return heights.map((height) => {
    const alphas = cast(light, height);
    return crossing(alphas, 0.1) - crossing(alphas, 0.9);
  });
}

/** Pixels in shadow of things that stand alone in aslant light, and so throw none on themselves where it shows. */
export function acne(filter: ShadowFilter) {
  const camera = lookingAt([0.4, 1.3, 1.2], [0, 0, 0]);
  const floor = thing(new PlaneGeometry(2, 2).rotateX(-Math.PI / 2));
  const ramp = thing(new PlaneGeometry(1, 1).rotateX(-0.5));
  const box = thing(new BoxGeometry(0.5, 0.5, 0.5));
  const light = sun([0.5, 0.6, 0.9], {
    shadow: { areaM: 3, mapSizePx: 1024, bias: 0, normalBiasM: (2.5 * 3) / 1024, filter, sourceRad: 0.1 },
  });
  const count = (item: ObjectItem): number => {
    const pixels = shoot(stand, {
      casters: [item],
      receivers: [item],
      lights: [light],
      method: 'map',
      on: 'everything',
      camera,
      strength: 1,
    });
    let shadowed = 0;
    for (let at = 3; at < pixels.length; at += 4) if ((pixels[at] ?? 0) > 12) shadowed++;
    return shadowed;
  };
  // All three sides of the box that show are lit.
  return { floor: count(floor), ramp: count(ramp), box: count(box), error: stand.gl.getError() };
}

const TOWARDS = new Vector3(-0.7, 1, 0.2).normalize();

/**
 * A plate's shadow on the room as geometry says, against what the layer shows: pixels that agree, wrong ones, and those of the block.
 * Pixels close to an edge are left out: of the shadow, or of the block where the depth's few pixels show it.
 */
export function onRoom(receivers: 'none' | 'floor', block: boolean) {
  const plate = thing(new PlaneGeometry(0.5, 0.5).rotateX(-Math.PI / 2), { at: translation(0.05, 0.7, 0) });
  const light = sun(TOWARDS.toArray(), { shadow: { areaM: 2, mapSizePx: 1024, bias: 0, normalBiasM: 0.005 } });
  const pixels = shoot(stand, {
    casters: [plate],
    receivers: receivers === 'floor' ? [desk()] : [],
    lights: [light],
    method: 'map',
    camera: ROOM_CAMERA,
    strength: 1,
    room: { depth: { views: [measuredRoom(160, 120, block)] }, toleranceM: { value: 0.05 } },
  });
  const inShadow = (point: Vector3, marginM: number): boolean => {
    const t = (0.7 - point.y) / TOWARDS.y;
    if (t <= 0) return false;
    const [x, z] = [point.x + TOWARDS.x * t - 0.05, point.z + TOWARDS.z * t];
    return Math.max(Math.abs(x), Math.abs(z)) < 0.25 + marginM;
  };
  const stepU = 1.5 / 160;
  const stepV = 1.5 / 120;
  let [right, wrong, blockShadow] = [0, 0, 0];
  for (let y = 0; y < SIDES.heightPx; y += 3) {
    for (let x = 0; x < SIDES.widthPx; x += 3) {
      const [u, v] = [(x + 0.5) / SIDES.widthPx, (y + 0.5) / SIDES.heightPx];
      const here = look(u, v, block);
      const around = [look(u + stepU, v, block), look(u - stepU, v, block), look(u, v + stepV, block), look(u, v - stepV, block)];
      if (around.some(({ meters }) => Math.abs(meters - here.meters) > 0.06)) continue;
      // Light from the left does not reach the block's right side, nor what lies within its own shadow.
      if (here.onBlock && here.point.y < BLOCK.topM - 1e-4) continue;
      if (inShadow(here.point, 0.03) !== inShadow(here.point, -0.03)) continue;
      const wanted = inShadow(here.point, 0) ? 255 : 0;
      const seen = pixel(pixels, x, y, SIDES.widthPx)[3] ?? -1;
      if (Math.abs(seen - wanted) <= 2) right++;
      else wrong++;
      if (here.onBlock && wanted > 0) blockShadow++;
    }
  }
  return { right, wrong, blockShadow, error: stand.gl.getError() };
}

/** A phantom floor alone, and a real block before it: without depth the floor's shadow lies on the block's picture. */
export function clipped(method: Method) {
  const plate = thing(new PlaneGeometry(0.5, 0.5).rotateX(-Math.PI / 2), { at: translation(0.05, 0.7, 0) });
  const light = sun(TOWARDS.toArray(), { shadow: { areaM: 2, mapSizePx: 1024, bias: 0, normalBiasM: 0.005 } });
  const shot = { casters: [plate], receivers: [desk()], lights: [light], method, camera: ROOM_CAMERA, strength: 1 } as const;
  const room = { depth: { views: [measuredRoom(160, 120, true)] }, toleranceM: { value: 0.05 } };
  const without = shoot(stand, shot);
  const within = shoot(stand, { ...shot, room });
  const unknown = shoot(stand, { ...shot, room: { ...room, depth: { views: [null] } } });
  let [misplaced, left, differs] = [0, 0, 0];
  for (let y = 0; y < SIDES.heightPx; y++) {
    for (let x = 0; x < SIDES.widthPx; x++) {
      const [u, v] = [(x + 0.5) / SIDES.widthPx, (y + 0.5) / SIDES.heightPx];
      const onFloor = pixel(without, x, y, SIDES.widthPx)[3] ?? 0;
      const here = pixel(within, x, y, SIDES.widthPx)[3] ?? 0;
      if ((pixel(unknown, x, y, SIDES.widthPx)[3] ?? 0) !== onFloor) differs++;
      const { point, onBlock } = look(u, v, true);
      const t = (0.7 - point.y) / TOWARDS.y;
      const lit = Math.max(Math.abs(point.x + TOWARDS.x * t - 0.05), Math.abs(point.z + TOWARDS.z * t)) > 0.28;
      // Lit top of the block, over which the shadow on the floor behind it would lie.
      if (!onBlock || point.y < BLOCK.topM - 1e-4 || !lit || onFloor < 200) continue;
      misplaced++;
      if (here > 50) left++;
    }
  }
  return { misplaced, left, differs, error: stand.gl.getError() };
}

/**
 * Where a phantom floor's shadow ends behind a wavy room of few samples, one of which is unknown, against what blending the known
 * ones or the nearest says by hand. The plate lies so low that what is before the floor is lit.
 */
export function clipBorder(interpolate: boolean, method: Method) {
  const [columns, rows, hole, toleranceM] = [24, 18, 9 * 24 + 11, 0.05];
  const depth = { ...measuredRoom(columns, rows, false), interpolate };
  const meters = Float32Array.from({ length: columns * rows }, (_, i) => {
    const [x, y] = [i % columns, Math.floor(i / columns)];
    const wave = 1 + 0.045 * Math.sin(x * 0.5 + 0.7) * Math.cos(y * 0.6);
    return i === hole ? 0 : look((x + 0.5) / columns, 1 - (y + 0.5) / rows, false).meters * wave;
  });
  stand.gl.bindTexture(stand.gl.TEXTURE_2D, depth.texture);
  stand.gl.texSubImage2D(stand.gl.TEXTURE_2D, 0, 0, 0, columns, rows, stand.gl.RED, stand.gl.FLOAT, meters);
  const sample = (x: number, y: number): number =>
    meters[Math.min(Math.max(y, 0), rows - 1) * columns + Math.min(Math.max(x, 0), columns - 1)] ?? 0;
  const roomM = (u: number, v: number): number => {
    if (!interpolate) return sample(Math.floor(u * columns), Math.floor((1 - v) * rows));
    const [x, y] = [u * columns - 0.5, (1 - v) * rows - 0.5];
    const [left, top] = [Math.floor(x), Math.floor(y)];
    let [sum, known] = [0, 0];
    for (const [dx, dy] of [0, 1, 2, 3].map((i) => [i & 1, i >> 1] as const)) {
      const m = sample(left + dx, top + dy);
      const weight = m > 0 ? (dx ? x - left : 1 - x + left) * (dy ? y - top : 1 - y + top) : 0;
      sum += weight * m;
      known += weight;
    }
    return known > 0 ? sum / known : 0;
  };
  const plate = thing(new PlaneGeometry(1.6, 1.6).rotateX(-Math.PI / 2), { at: translation(0.1, 0.01, 0) });
  const light = sun([0, 1, 0], { shadow: { areaM: 3, mapSizePx: 1024, bias: 0, normalBiasM: 0.002 } });
  const shot = { casters: [plate], receivers: [desk()], lights: [light], method, camera: ROOM_CAMERA, strength: 1 } as const;
  const whole = shoot(stand, shot);
  const cut = shoot(stand, { ...shot, room: { depth: { views: [depth] }, toleranceM: { value: toleranceM } } });
  const tally = { kept: 0, hidden: 0, lost: 0, left: 0 };
  for (let y = 0; y < SIDES.heightPx; y++) {
    for (let x = 0; x < SIDES.widthPx; x++) {
      const [u, v] = [(x + 0.5) / SIDES.widthPx, (y + 0.5) / SIDES.heightPx];
      const behindM = look(u, v, false).meters - (roomM(u, v) || 99) - toleranceM;
      if ((pixel(whole, x, y, SIDES.widthPx)[3] ?? 0) < 250 || Math.abs(behindM) < 0.001) continue;
      const isDark = (pixel(cut, x, y, SIDES.widthPx)[3] ?? 0) > 127;
      tally[behindM > 0 ? (isDark ? 'left' : 'hidden') : isDark ? 'kept' : 'lost']++;
    }
  }
  return { ...tally, error: stand.gl.getError() };
}

/** The same shadow on a floor that is a phantom, and that depth alone shows. */
export function byDepthAlone() {
  const mesh = new Mesh(new BoxGeometry(0.3, 0.3, 0.3), new MeshLambertMaterial());
  mesh.updateMatrixWorld(true);
  const box = thing(mesh.geometry, { at: new Matrix4().makeTranslation(0, 0.4, 0) });
  const light = sun([-0.4, 1, 0.3], { shadow: { areaM: 2, mapSizePx: 1024, bias: 0, normalBiasM: 0.005 } });
  const shot = { casters: [box], lights: [light], method: 'map', camera: ROOM_CAMERA, strength: 1 } as const;
  const byPhantom = shoot(stand, { ...shot, receivers: [desk()] });
  const upright = measuredRoom(160, 120, false);
  const byDepth = shoot(stand, { ...shot, receivers: [], room: { depth: { views: [upright] }, toleranceM: { value: 0.05 } } });
  let [both, either] = [0, 0];
  for (let at = 3; at < byDepth.length; at += 4) {
    const [a, b] = [(byPhantom[at] ?? 0) > 127, (byDepth[at] ?? 0) > 127];
    if (a && b) both++;
    if (a || b) either++;
  }
  return { overlap: both / either, shadowed: either };
}

/** Red of a lit floor or alpha of its shadow under a transparent plate, by what is above it. */
export function veils(kind: 'sun' | 'spot' | 'bulb', filter: ShadowFilter) {
  const shadow = { mapSizePx: 1024, filter } as const;
  const light: LightItem = {
    sun: () => sun([0, 1, 0], { shadow: { ...shadow, areaM: 3, bias: 0, normalBiasM: 0.005, sourceRad: 0.1 } }),
    spot: () => spot([0, 2.2, 0], [0, 0, 0], 30, { shadow: { ...shadow, biasPx: 2, sourceM: 0.1 }, halfAngleRad: 0.6 }),
    bulb: () => bulb([0, 2.2, 0], 30, { shadow: { ...shadow, biasPx: 2 } }),
  }[kind]();
  const pane = (opacity: number, heightM: number, texture: DataTexture | null = null): ObjectItem => {
    const material = new MeshLambertMaterial({ transparent: true, opacity, map: texture });
    return thing(new PlaneGeometry(0.6, 0.6).rotateX(-Math.PI / 2), { material, at: translation(0, heightM, 0) });
  };
  // Left half clear, right half solid.
  const halves = new DataTexture(Uint8Array.of(255, 255, 255, 0, 255, 255, 255, 255), 2, 1);
  halves.needsUpdate = true;
  const shot = { lights: [light], method: 'map', camera: ABOVE, strength: 1 } as const;
  const alpha = (pixels: Uint8Array, x = 0): number =>
    pixel(pixels, SIDES.widthPx / 2 + Math.round(x / METERS_PER_PX), SIDES.heightPx / 2, SIDES.widthPx)[3] ?? -1;
  const under = (...casters: ObjectItem[]): number => alpha(shoot(stand, { ...shot, casters, receivers: [desk()] }));
  const cut = shoot(stand, { ...shot, casters: [pane(1, 0.5, halves)], receivers: [desk()] });
  const solid = thing(new PlaneGeometry(0.6, 0.6).rotateX(-Math.PI / 2), { at: translation(0, 0.8, 0) });
  // Between the pane and the lamp nothing is dimmed.
  const above = thing(new PlaneGeometry(0.3, 0.3).rotateX(-Math.PI / 2), {
    role: 'phantom',
    castsShadow: false,
    at: translation(0, 0.9, 0),
  });
  return {
    thin: under(pane(0.25, 0.5)),
    thick: under(pane(0.75, 0.5)),
    two: under(pane(0.5, 0.4), pane(0.5, 0.7)),
    behindSolid: under(pane(0.5, 0.5), solid),
    above: alpha(shoot(stand, { ...shot, casters: [pane(0.5, 0.5)], receivers: [above] })),
    beside: alpha(cut, -0.1),
    cut: alpha(cut, 0.1),
    error: stand.gl.getError(),
  };
}

/** What arrives on a white virtual floor under a pane, of what arrives without it: linear light. It turns solid and clear while running. */
export function veiledThings(kind: 'sun' | 'spot' | 'bulb') {
  const { backend, layer, gl } = stand;
  const shadow = { mapSizePx: 512 } as const;
  const light: LightItem = {
    sun: () => sun([0, 1, 0], { radiance: 2, shadow: { ...shadow, areaM: 3, bias: 0, normalBiasM: 0.01 } }),
    spot: () => spot([0, 2.2, 0], [0, 0, 0], 8, { shadow: { ...shadow, biasPx: 2 }, halfAngleRad: 0.6 }),
    bulb: () => bulb([0, 2.2, 0], 8, { shadow: { ...shadow, biasPx: 2 } }),
  }[kind]();
  const material = new MeshLambertMaterial({ transparent: true, opacity: 0.5 });
  const pane = thing(new PlaneGeometry(0.5, 0.5).rotateX(-Math.PI / 2), { material, at: translation(0, 0.5, 0), receivesShadow: false });
  const floor = thing(new PlaneGeometry(3, 3).rotateX(-Math.PI / 2), { castsShadow: false });
  const [casters, shown, lamps] = [objects(pane), objects(floor), lights(light)];
  const maps = backend.createShadowMaps([casters], [lamps]);
  const scene = backend.serviceFor({ shadowMaps: maps, occlusion: null }).createScene({ kind: 'shaded', ambient: { value: 0 } });
  const camera = lookingAt([0, 1.6, 1.6], [0, 0, 0]);
  const draw = (): number => {
    scene.update([shown], [lamps]);
    maps.update();
    layer.clear();
    scene.draw(drawView(viewOf(camera, { x: 0, y: 0, ...SIDES }), layer.framebuffer));
    const byte = pixel(layer.pixels(), SIDES.widthPx / 2, SIDES.heightPx / 2, SIDES.widthPx)[0] ?? 0;
    return new Color().setRGB(byte / 255, 0, 0, 'srgb').r;
  };
  const through = draw();
  material.opacity = 0.2;
  const thinner = draw();
  material.transparent = false;
  material.needsUpdate = true;
  const solid = draw();
  casters.items.length = 0;
  casters.version++;
  const open = draw();
  scene.dispose();
  maps.dispose();
  return { through: through / open, thinner: thinner / open, solid: solid / open, error: gl.getError() };
}

/** Alpha on the floor below the middle of a box that stands on it, floats, and floats high, by the contact shadow alone; and how it lights. */
export function contacts() {
  const { ctx } = fakeContext(directional, { params: { contact: 1, areaM: 3, castShadow: true } });
  createDirectional(ctx).update({} as never);
  const contact = ctx.outputs.lights.items.filter((light) => light.kind === 'directional' && light.onlyShadows);
  const side = (heightM: number): ObjectItem => thing(new BoxGeometry(0.3, 0.2, 0.3), { at: translation(0, heightM + 0.1, 0) });
  const shot = { lights: contact, receivers: [desk()], method: 'map', camera: ABOVE, strength: 1 } as const;
  const alphas = (heightM: number): { readonly below: number; readonly beside: number } => {
    const pixels = shoot(stand, { ...shot, casters: [side(heightM)] });
    const at = (x: number): number =>
      pixel(pixels, SIDES.widthPx / 2 + Math.round(x / METERS_PER_PX), SIDES.heightPx / 2, SIDES.widthPx)[3] ?? -1;
    return { below: at(0), beside: at(0.18) };
  };
  const volumes = shoot(stand, { ...shot, casters: [side(0.1)], method: 'volume' });
  const { backend, layer } = stand;
  const scene = backend.serviceFor({ shadowMaps: null, occlusion: null }).createScene({ kind: 'shaded', ambient: { value: 0 } });
  scene.update([objects(thing(new PlaneGeometry(2, 2).rotateX(-Math.PI / 2)))], [lights(...contact)]);
  layer.clear();
  scene.draw(drawView(viewOf(ABOVE, { x: 0, y: 0, ...SIDES }), layer.framebuffer));
  const lit = pixel(layer.pixels(), SIDES.widthPx / 2, SIDES.heightPx / 2, SIDES.widthPx);
  scene.dispose();
  return {
    lights: contact.length,
    standing: alphas(0),
    floating: alphas(0.3),
    high: alphas(1.2),
    byVolume: pixel(volumes, SIDES.widthPx / 2, SIDES.heightPx / 2, SIDES.widthPx)[3],
    lit,
    error: stand.gl.getError(),
  };
}
