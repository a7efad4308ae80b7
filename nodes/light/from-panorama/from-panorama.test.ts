import { describe, expect, test } from '@jest/globals';
import { fakeContext } from '../../../tests/support/node-context.ts';
import type { EnvironmentAsset } from '../../kit/assets.ts';
import type { ParamValue } from '../../kit/definition.ts';
import type { PanoramaPixels } from '../../kit/panorama/pixels.ts';
import type {
  DirectionalLightItem,
  EnvironmentLightItem,
  EnvironmentOutput,
  PointLightItem,
  SpotLightItem,
} from '../../kit/scene-lists.ts';
import { definition } from './definition.ts';
import { create } from './runtime.ts';

const W = 64;
const H = 32;
/** Frames after which a search of this size is complete. */
const SLICES_OF_64_PX = 20;

/** A dim room with a lamp of 4 × 4 pixels to the right, a little above the horizon; `seam`: the lamp is cut by the left and right edge. */
function room({ lamp = 200, wall = 0.2, seam = false } = {}): PanoramaPixels {
  const data = new Float32Array(W * H * 3).fill(wall);
  for (let y = 10; y < 14; y++) {
    for (let x = 0; x < 4; x++)
      data.fill(lamp, (y * W + (((seam ? -2 : 46) + x + W) % W)) * 3, (y * W + (((seam ? -2 : 46) + x + W) % W)) * 3 + 3);
  }
  return { widthPx: W, heightPx: H, channels: 3, data };
}

function make(pixels: PanoramaPixels, params: Record<string, ParamValue> = {}) {
  const filled: unknown[] = [];
  const rest = { dispose: () => filled.push('disposed') };
  const asset = {
    readPixels: () => pixels,
    withoutLamps: (runs: readonly number[], size: { widthPx: number }) => {
      filled.push([runs.length / 3, size.widthPx]);
      return rest;
    },
  } as unknown as EnvironmentAsset;
  const environment: EnvironmentOutput = { asset, intensity: 1, rotationRad: 0 };
  const { ctx, set, reports } = fakeContext(definition, { params, inputs: { environment } });
  const node = create(ctx);
  for (let i = 0; i < SLICES_OF_64_PX; i++) node.update({} as never);
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

  test('infinite and undefined pixels are reported, and give finite light', () => {
    const pixels = room();
    pixels.data.set([Number.NaN, 1, 1, Number.POSITIVE_INFINITY, 1, 1], 0);
    const { lights, reports } = make(pixels);
    expect(reports).toEqual([expect.objectContaining({ code: 'SCR029', message: expect.stringMatching(/^2 pixels/) })]);
    for (const light of lights.items) if (light.kind === 'directional') expect([...light.radiance].every(Number.isFinite)).toBe(true);
  });

  test('another panorama is searched anew, and the copy of the first is disposed', () => {
    const { node, lights, environment, filled, update } = make(room());
    environment.asset = null;
    update();
    expect([lights.items.map(({ kind }) => kind), filled.at(-1)]).toEqual([['environment'], 'disposed']);
    node.dispose();
    expect(filled.filter((entry) => entry === 'disposed')).toHaveLength(1);
  });

  test('searches in slices over several frames', () => {
    const pixels = { ...room(), widthPx: W, heightPx: H };
    const asset = { readPixels: () => pixels, withoutLamps: () => ({ dispose: () => {} }) } as unknown as EnvironmentAsset;
    const { ctx } = fakeContext(definition, { inputs: { environment: { asset, intensity: 1, rotationRad: 0 } } });
    const node = create(ctx);
    node.update({} as never);
    expect(ctx.outputs.lights.items).toHaveLength(1);
    for (let i = 1; i < SLICES_OF_64_PX; i++) node.update({} as never);
    expect(ctx.outputs.lights.items).toHaveLength(3);
    node.dispose();
  });
});
