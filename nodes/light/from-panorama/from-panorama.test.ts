import { describe, expect, test } from '@jest/globals';
import { fakeContext } from '../../../tests/support/node-context.ts';
import type { EnvironmentAsset } from '../../kit/assets.ts';
import type { ParamValue } from '../../kit/definition.ts';
import { findLampsAtOnce } from '../../kit/panorama/find-lamps.ts';
import { lampKey, lampOptionsOf } from '../../kit/panorama/lamp-options.ts';
import type { PanoramaPixels } from '../../kit/panorama/pixels.ts';
import type { SessionService, WorkerService } from '../../kit/runtime.ts';
import type {
  DirectionalLightItem,
  EnvironmentLightItem,
  EnvironmentOutput,
  PointLightItem,
  SpotLightItem,
} from '../../kit/scene-lists.ts';
import type { LightEstimate } from '../../kit/session.ts';
import { definition } from './definition.ts';
import { create } from './runtime.ts';
import { type SearchMessage, serve, type WorkerScope } from './worker.ts';

const W = 64;
const H = 32;
/** A dim room with a lamp of 4 × 4 pixels to the right, a little above the horizon; `seam`: the lamp is cut by the left and right edge. */
function room({ lamp = 200, wall = 0.2, seam = false } = {}): PanoramaPixels {
  const data = new Float32Array(W * H * 3).fill(wall);
  for (let y = 10; y < 14; y++) {
    for (let x = 0; x < 4; x++)
      data.fill(lamp, (y * W + (((seam ? -2 : 46) + x + W) % W)) * 3, (y * W + (((seam ? -2 : 46) + x + W) % W)) * 3 + 3);
  }
  return { widthPx: W, heightPx: H, channels: 3, data };
}

/** Workers that answer when told to, or at once. */
function fakeWorkers(isAtOnce = true) {
  const waiting: (() => void)[] = [];
  const log: string[] = [];
  const service: WorkerService = {
    start: ({ onMessage }) => {
      const scope: WorkerScope = { onmessage: null, postMessage: (answer) => onMessage(structuredClone(answer)) };
      serve(scope);
      log.push('start');
      return {
        post: (message) => {
          const data = structuredClone(message) as SearchMessage;
          if (isAtOnce) scope.onmessage?.({ data });
          else waiting.push(() => scope.onmessage?.({ data }));
        },
        dispose: () => log.push('end'),
      };
    },
  };
  return { service, log, answer: () => waiting.splice(0).forEach((one) => void one()) };
}

function make(pixels: PanoramaPixels, params: Record<string, ParamValue> = {}, session: SessionService = {} as never) {
  const filled: unknown[] = [];
  const rest = { ready: true, dispose: () => filled.push('disposed') };
  const asset = {
    readPixels: () => pixels,
    withoutLamps: (runs: readonly number[], size: { widthPx: number }) => {
      filled.push([runs.length / 3, size.widthPx]);
      return rest;
    },
  } as unknown as EnvironmentAsset;
  const environment: EnvironmentOutput = { asset, intensity: 1, rotationRad: 0 };
  const { ctx, set, reports } = fakeContext(definition, {
    params,
    inputs: { environment },
    services: { session, workers: fakeWorkers().service },
  });
  const node = create(ctx);
  node.update({} as never);
  const { lights, environment: passedOn } = ctx.outputs;
  return { node, set, reports, lights, passedOn, asset, rest, filled, environment, update: () => node.update({} as never) };
}

const azimuthDeg = ([x = 0, , z = 0]: Float32Array): number => (Math.atan2(x, -z) * 180) / Math.PI;

describe('light/from-panorama', () => {
  test('lists the lamp with its direction and measured light, the shadow of the rest, and the rest as environment', () => {
    const { lights, rest, asset, passedOn, filled, reports } = make(room());
    const [lamp, shadow, around] = lights.items as [DirectionalLightItem, DirectionalLightItem, EnvironmentLightItem];
    expect(lights.items.map(({ kind }) => kind)).toEqual(['directional', 'directional', 'environment']);
    // Columns 46 to 49 of 64: their center is 90° to the right of the center. Rows 10 to 13 of 32: 22.5° up.
    expect(azimuthDeg(lamp.towardsLightWorld)).toBeCloseTo(90, 3);
    expect((Math.asin(lamp.towardsLightWorld[1] ?? 0) * 180) / Math.PI).toBeCloseTo(22.5, 0);
    const pixelSr = ((2 * Math.PI) / W) * 2 * Math.sin((2 * Math.PI) / H) * Math.cos(Math.PI / 8);
    // A surface that faces the lamp: radiance above the rest × solid angle, less 1 % for the edges of the lamp.
    expect(lamp.radiance[0]).toBeCloseTo(199.8 * 4 * pixelSr * 0.993, -1);
    expect(lamp.shadow).toMatchObject({ filter: 'pcss', sourceRad: expect.closeTo(0.43, 1) });
    expect(shadow).toMatchObject({ onlyShadows: true, shadow: { sourceRad: 1.4 } });
    // A floor under a sky of radiance 0.2 receives π × 0.2.
    expect((shadow.radiance[0] ?? 0) * (shadow.towardsLightWorld[1] ?? 0)).toBeCloseTo(0.2 * Math.PI, 2);
    expect([around.environment, around.intensity]).toEqual([rest, 1]);
    expect([passedOn.asset, filled, reports]).toEqual([asset, [[4, W]], []]);
  });

  test('a lamp at the seam is one lamp behind the viewer', () => {
    const { lights } = make(room({ seam: true }));
    expect(lights.items.map(({ key }) => key)).toEqual(['lamp 1', 'shadow of the rest', 'rest']);
    expect(Math.abs(azimuthDeg((lights.items[0] as DirectionalLightItem).towardsLightWorld))).toBeCloseTo(180, 3);
  });

  test('turns, dims and softens while running, with the panorama; changes nothing else', () => {
    const { lights, set, update, environment } = make(room());
    const lamp = lights.items[0] as DirectionalLightItem;
    const { version } = lights;
    const before = lamp.radiance[0] ?? 0;
    set('rotationRad', Math.PI / 4);
    environment.rotationRad = Math.PI / 4;
    environment.intensity = 2;
    set('intensity', 0.25);
    set('castShadow', false);
    update();
    // Counter-clockwise seen from above: from the right to the front of the panorama.
    expect(azimuthDeg(lamp.towardsLightWorld)).toBeCloseTo(0, 3);
    expect([lamp.radiance[0], lamp.shadow]).toEqual([expect.closeTo(before / 2, 3), null]);
    expect([lights.items[2], lights.version]).toMatchObject([{ intensity: 2, rotationRad: Math.PI / 2 }, version]);
  });

  test('spot and point lamps give the center the same light from their distance', () => {
    const { lights, set, update } = make(room(), { distanceM: 2, centerM: [0, 1, 0] });
    const radiance = (lights.items[0] as DirectionalLightItem).radiance[0] ?? 0;
    set('kind', 2);
    update();
    const point = lights.items[0] as PointLightItem;
    expect([point.kind, lights.items.length]).toEqual(['point', 2]);
    expect((point.intensityCd[0] ?? 0) / 4).toBeCloseTo(radiance, 3);
    expect(Math.hypot(point.positionWorld[0] ?? 0, (point.positionWorld[1] ?? 0) - 1, point.positionWorld[2] ?? 0)).toBeCloseTo(2, 5);
    set('kind', 1);
    update();
    const spot = lights.items[0] as SpotLightItem;
    expect([spot.kind, (spot.intensityCd[0] ?? 0) / 4]).toEqual(['spot', expect.closeTo(radiance, 3)]);
    expect(azimuthDeg(spot.towardsLightWorld)).toBeCloseTo(90, 3);
  });

  test('a pinned lamp keeps its direction and its measured light; a lamp can have its own type and distance', () => {
    const { lights, set, update } = make(room(), { distanceM: 2, centerM: [0, 1, 0] });
    const before = (lights.items[0] as DirectionalLightItem).radiance[0] ?? 0;
    set('lamp1AzimuthRad', Math.PI / 2);
    set('lamp1ElevationRad', 0);
    set('lamp1Pinned', true);
    update();
    const pinned = lights.items[0] as DirectionalLightItem;
    expect([...pinned.towardsLightWorld, pinned.radiance[0]]).toEqual([1, 0, 0, before].map((n) => expect.closeTo(n, 5)));
    set('rotationRad', Math.PI / 2);
    set('lamp1Kind', 3);
    set('lamp1DistanceM', 3);
    update();
    // Rotated from the right to the back, 3 m from the center.
    const point = lights.items[0] as PointLightItem;
    expect([point.kind, ...point.positionWorld]).toEqual(['point', ...[0, 1, -3].map((n) => expect.closeTo(n, 5))]);
    expect((point.intensityCd[0] ?? 0) / 9).toBeCloseTo(before, 4);
    set('lamp1Pinned', false);
    set('lamp1Kind', 0);
    update();
    expect((lights.items[0] as DirectionalLightItem).towardsLightWorld[1]).toBeCloseTo(Math.sin(Math.PI / 8), 2);
  });

  test('spot and point lamps are on what their direction meets in the room, and at “Distance” where it meets nothing', () => {
    const rays: number[][] = [];
    let wallM = 1.5;
    const castRay = (worldFromRay: ArrayLike<number>, hit: { distanceM: number }, sources: readonly string[]) => {
      rays.push([...Array.from(worldFromRay), Number(sources.includes('floor'))]);
      hit.distanceM = wallM;
      return wallM > 0;
    };
    const params = { kind: 2, distanceFrom: 'room', distanceM: 4, centerM: [0, 1, 0] };
    const placed = () => {
      const { lights } = make(room(), params, { castRay } as never);
      const [x = 0, y = 0, z = 0] = (lights.items[0] as PointLightItem).positionWorld;
      return Math.hypot(x, y - 1, z);
    };
    expect(placed()).toBeCloseTo(1.5, 5);
    // A ray from the center, along -z of its pose, to the lamp on the right.
    expect(rays[0]?.slice(8, 15)).toEqual([-Math.cos(Math.PI / 8), -Math.sin(Math.PI / 8), 0, 0, 0, 1, 0].map((n) => expect.closeTo(n, 1)));
    expect(rays[0]?.at(-1)).toBe(0);
    wallM = 0;
    expect(placed()).toBeCloseTo(4, 5);
  });

  test.each([
    ['white', room({ lamp: 1, wall: 1 }), /no part of it is much brighter/],
    ['black', room({ lamp: 0, wall: 0 }), /is black/],
    ['a single pixel', { widthPx: 1, heightPx: 1, channels: 3, data: Float32Array.of(1, 1, 1) } as const, /no part of it/],
  ])('a panorama that is all %s lights as a whole, with a message', (_what, pixels, reason) => {
    const { lights, reports, asset, filled } = make(pixels);
    expect(lights.items).toEqual([expect.objectContaining({ kind: 'environment', environment: asset })]);
    expect(reports).toEqual([expect.objectContaining({ code: 'SCR028', message: expect.stringMatching(reason) })]);
    expect(filled).toEqual([]);
  });

  /** Many equal lamps, one in each cell of 8 × 4 pixels. */
  function many(): PanoramaPixels {
    const [widthPx, heightPx] = [256, 128];
    const data = new Float32Array(widthPx * heightPx * 3).fill(0.1);
    for (let i = 0; i < 200; i++) {
      const [x, y] = [(i % 20) * 12 + 4, Math.floor(i / 20) * 9 + 20];
      for (let row = y; row < y + 4; row++) data.fill(100, (row * widthPx + x) * 3, (row * widthPx + x + 4) * 3);
    }
    return { widthPx, heightPx, channels: 3, data };
  }

  const bytes = (level: number): PanoramaPixels => ({ widthPx: W, heightPx: H, channels: 3, data: new Uint8Array(W * H * 3).fill(level) });

  test.each([
    [
      'solid-angle',
      'all white',
      bytes(255),
      /^The whole panorama lights the scene, because no lamp was found in it: no part of it is much brighter/,
    ],
    ['solid-angle', 'all black', bytes(0), /: the panorama is black\.$/],
    ['solid-angle', '200 equal lamps', many(), /^Of more than \d+ lamps that are about as bright, 3 are lights with shadows\./],
    ['paper', 'all white', bytes(255), /: the panorama is too bright all over to tell lamps from walls\.$/],
    ['paper', 'all black', bytes(0), /: the panorama is black\.$/],
    ['paper', '200 equal lamps', many(), /: more than 2 % of the panorama is nearly as bright as its brightest pixel/],
  ] as const)('%s tells what is wrong with a panorama that is %s', (method, _what, pixels, message) => {
    const { reports, lights } = make(pixels, { method });
    expect(reports).toEqual([expect.objectContaining({ code: 'SCR028', severity: 'info', message: expect.stringMatching(message) })]);
    for (const item of lights.items) if ('irradiance' in item) expect([...(item.irradiance as number[])].every(Number.isFinite)).toBe(true);
    expect(lights.items.at(-1)?.kind).toBe('environment');
  });

  test('infinite and undefined pixels are reported, and give finite light', () => {
    const pixels = room();
    pixels.data.set([Number.NaN, 1, 1, Number.POSITIVE_INFINITY, 1, 1], 0);
    const { lights, reports } = make(pixels);
    expect(reports).toEqual([expect.objectContaining({ code: 'SCR029', message: expect.stringMatching(/^2 pixels/) })]);
    for (const light of lights.items) if (light.kind === 'directional') expect([...light.radiance].every(Number.isFinite)).toBe(true);
  });

  test('a white lamp is as bright as the light estimation of the device says, and by “Share of white” without one', () => {
    const data = new Uint8Array(W * H * 3).fill(124);
    for (let y = 10; y < 14; y++) data.fill(255, (y * W + 46) * 3, (y * W + 50) * 3);
    const pixels: PanoramaPixels = { widthPx: W, heightPx: H, channels: 3, data };
    const session: { light: LightEstimate | null } = { light: null };
    const { lights, update } = make(pixels, { clippedFrom: 'estimate', clippedShare: 0.5 }, session as never);
    const lamp = lights.items[0] as DirectionalLightItem;
    // What the walls of linear 0.2 give: half of all light, less the pixels of the lamp.
    const walls = 4 * Math.PI * 0.2;
    expect((lamp.radiance[0] ?? 0) / walls).toBeCloseTo(1, 1);
    // Around the device: the same radiance L everywhere has the first coefficient L × √(4π). The primary light gives 0.8 of all.
    const sphericalHarmonics = new Float32Array(27).fill(3 * Math.sqrt(4 * Math.PI), 0, 3);
    const primaryIntensity = new Float32Array(3).fill(4 * 4 * Math.PI * 3);
    session.light = { sphericalHarmonics, primaryIntensity, primaryDirectionWorld: Float32Array.of(0, 1, 0) };
    update();
    expect((lamp.radiance[0] ?? 0) / walls).toBeCloseTo(4, 0);
    const kept = lamp.radiance[0];
    session.light = null;
    update();
    expect(lamp.radiance[0]).toBe(kept);
    // An estimate without light says nothing.
    session.light = {
      sphericalHarmonics: new Float32Array(27),
      primaryIntensity: new Float32Array(3),
      primaryDirectionWorld: new Float32Array(3),
    };
    update();
    expect(lamp.radiance[0]).toBe(kept);
  });

  test('another panorama is searched anew, and the copy of the first is disposed', () => {
    const { node, lights, environment, filled, update } = make(room());
    environment.asset = null;
    update();
    expect([lights.items.map(({ kind }) => kind), filled.at(-1)]).toEqual([['environment'], 'disposed']);
    node.dispose();
    expect(filled.filter((entry) => entry === 'disposed')).toHaveLength(1);
  });

  test('a worker searches while frames go on; another panorama cancels it', () => {
    const { service, log, answer } = fakeWorkers(false);
    const assetOf = (pixels: PanoramaPixels) =>
      ({ readPixels: () => pixels, withoutLamps: () => ({ ready: true, dispose: () => {} }) }) as never;
    const environment: EnvironmentOutput = { asset: assetOf(room()), intensity: 1, rotationRad: 0 };
    const { ctx } = fakeContext(definition, { inputs: { environment }, services: { workers: service } });
    const node = create(ctx);
    const kinds = () => {
      node.update({} as never);
      return ctx.outputs.lights.items.map(({ kind }) => kind);
    };
    expect(kinds()).toEqual(['environment']);
    expect(kinds()).toEqual(['environment']);
    environment.asset = assetOf(room({ seam: true }));
    expect(kinds()).toEqual(['environment']);
    expect(log).toEqual(['start', 'end', 'start']);
    answer();
    expect(kinds()).toEqual(['directional', 'directional', 'environment']);
    node.dispose();
    expect(log).toEqual(['start', 'end', 'start', 'end']);
  });

  test('until the panorama without its lamps can be drawn, the whole panorama lights alone: no light counts twice', () => {
    const rest = { ready: false, dispose: () => {} };
    const asset = { readPixels: () => room(), withoutLamps: () => rest } as unknown as EnvironmentAsset;
    const inputs = { environment: { asset, intensity: 1, rotationRad: 0 } };
    const { ctx } = fakeContext(definition, { inputs, services: { workers: fakeWorkers().service } });
    const node = create(ctx);
    const items = () => {
      node.update({} as never);
      return ctx.outputs.lights.items;
    };
    expect(items()).toEqual([expect.objectContaining({ kind: 'environment', environment: asset })]);
    expect(items()).toHaveLength(1);
    rest.ready = true;
    const lit = items();
    expect(lit.slice(0, 2).map(({ kind }) => kind)).toEqual(['directional', 'directional']);
    expect(lit.at(-1)).toMatchObject({ kind: 'environment', environment: rest });
  });

  test('lamps that the page stores need no worker, and light as those that a worker or a render finds', () => {
    const searched = make(room()).lights.items;
    const options = lampOptionsOf({ method: 'solid-angle', lamps: 3, iterations: 2, intensities: 'ranks', clippedShare: 0.5 });
    // As in `program.json`.
    const lamps = JSON.parse(JSON.stringify({ [lampKey(options)]: findLampsAtOnce(room(), options) }));
    const readPixels = () => {
      throw new Error('not read');
    };
    const withoutLamps = () => ({ ready: true, dispose: () => {} });
    for (const more of [{ lamps }, { findLamps: () => findLampsAtOnce(room(), options) }]) {
      const environment: EnvironmentOutput = { asset: { readPixels, withoutLamps, ...more } as never, intensity: 1, rotationRad: 0 };
      const { ctx } = fakeContext(definition, { inputs: { environment } });
      if ('findLamps' in more) (ctx.clock as { held: boolean }).held = true;
      const node = create(ctx);
      node.update({} as never);
      expect(ctx.outputs.lights.items.slice(0, 2)).toEqual(searched.slice(0, 2));
    }
  });

  test('where no worker starts, the whole panorama lights, with a message', () => {
    const asset = { readPixels: () => room() } as unknown as EnvironmentAsset;
    const start = () => {
      throw new Error('the browser starts no worker');
    };
    const inputs = { environment: { asset, intensity: 1, rotationRad: 0 } };
    const { ctx, reports } = fakeContext(definition, { inputs, services: { workers: { start } } });
    create(ctx).update({} as never);
    expect(ctx.outputs.lights.items).toEqual([expect.objectContaining({ environment: asset })]);
    expect(reports).toEqual([
      expect.objectContaining({ code: 'SCR028', severity: 'warning', message: expect.stringMatching(/starts no worker\.$/) }),
    ]);
  });
});
