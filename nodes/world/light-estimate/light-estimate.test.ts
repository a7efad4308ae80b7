import { describe, expect, test } from '@jest/globals';
import { LIBRARY } from '../../../tests/support/library.ts';
import { fakeContext } from '../../../tests/support/node-context.ts';
import { readShader } from '../../../tests/support/test-library.ts';
import { TestStudio } from '../../../tests/support/test-studio.ts';
import type { ParamValue } from '../../kit/definition.ts';
import type { DirectionalLightItem, ProbeLightItem } from '../../kit/scene-lists.ts';
import type { LightEstimate } from '../../kit/session.ts';
import { definition } from './definition.ts';
import { DEFAULT_MEAN } from './guess-light.ts';
import { create } from './runtime.ts';

interface Seen {
  light: LightEstimate | null;
  cameraMean: Float32Array | null;
}

function estimate(value: number, direction: readonly [number, number, number] = [0, 1, 0]): LightEstimate {
  return {
    sphericalHarmonics: new Float32Array(27).fill(value),
    primaryDirectionWorld: Float32Array.from(direction),
    primaryIntensity: new Float32Array(3).fill(value * 2),
    reflection: { texture: {} as WebGLTexture, version: 4 },
  };
}

function make(seen: Seen, params: Record<string, ParamValue> = {}) {
  const { ctx, set, tick } = fakeContext(definition, { params, services: { session: seen as never } });
  const node = create(ctx);
  const [primary, around] = ctx.outputs.lights.items as [DirectionalLightItem, ProbeLightItem];
  const step = (deltaS: number): void => {
    tick(deltaS);
    node.update({} as never);
  };
  return { node, set, step, primary, around, lights: ctx.outputs.lights };
}

const rounded = (numbers: Iterable<number>): number[] => [...numbers].map((x) => Math.round(x * 1e5) / 1e5 + 0);

/** What it looks like is proved on pixels, in `tests/browser/light-estimate.test.ts`. */
describe('world/light-estimate', () => {
  test('passes on the estimate of the device: ambient light, directional light and reflections', () => {
    const light = estimate(0.25, [3, 0, 4]);
    const { step, primary, around } = make({ light, cameraMean: null }, { intensity: 2 });
    step(0);
    expect(rounded(around.sphericalHarmonics)).toEqual(new Array(27).fill(0.25));
    expect([around.intensity, around.reflection]).toEqual([2, light.reflection]);
    expect(rounded(primary.towardsLightWorld)).toEqual([0.6, 0, 0.8]);
    expect(rounded(primary.radiance)).toEqual([1, 1, 1]);
  });

  test('follows a change by its time constant, at any frame rate', () => {
    const wayAfterOneConstant = (frames: number): number => {
      const seen: Seen = { light: estimate(0), cameraMean: null };
      const { step, around } = make(seen, { smoothingS: 0.8 });
      step(0);
      seen.light = estimate(1);
      for (let i = 0; i < frames; i++) step(0.8 / frames);
      return around.sphericalHarmonics[7] ?? 0;
    };
    expect(wayAfterOneConstant(6)).toBeCloseTo(1 - Math.exp(-1), 5);
    expect(wayAfterOneConstant(60)).toBeCloseTo(1 - Math.exp(-1), 4);
  });

  test('rotates the direction the short way, and keeps it a unit vector', () => {
    const seen: Seen = { light: estimate(1, [1, 0, 0]), cameraMean: null };
    const { step, primary } = make(seen, { smoothingS: 1 });
    step(0);
    seen.light = estimate(1, [0, 0, 1]);
    step(0.3);
    const [x = 0, y = 0, z = 0] = primary.towardsLightWorld;
    expect([x > 0.3, y, z > 0.3, Math.hypot(x, y, z)]).toEqual([true, 0, true, expect.closeTo(1, 5)]);
    seen.light = estimate(1, [0, 0, 0]);
    step(100);
    expect(rounded(primary.towardsLightWorld)).toEqual(rounded([x, y, z].map((n, i) => (i === 1 ? 0 : n))).map(() => expect.any(Number)));
    expect(Math.hypot(...primary.towardsLightWorld)).toBeCloseTo(1, 5);
  });

  test('keeps the last estimate for two seconds, then guesses from the camera picture', () => {
    const seen: Seen = { light: estimate(3), cameraMean: Float32Array.of(0.1, 0.2, 0.4) };
    const { step, around, primary } = make(seen, { smoothingS: 0 });
    step(0);
    seen.light = null;
    step(1.9);
    expect(around.sphericalHarmonics[0]).toBe(3);
    step(0.2);
    // A matt room that sends back half of its light: radiance 0.1 leaves it where 0.2 π arrive, 0.4 of them from one side.
    expect(rounded(primary.radiance)).toEqual(rounded([0.08 * Math.PI, 0.16 * Math.PI, 0.32 * Math.PI]));
    expect(rounded(around.sphericalHarmonics.subarray(0, 3))).toEqual(rounded([0.12, 0.24, 0.48].map((l) => l * Math.sqrt(4 * Math.PI))));
    expect(around.reflection).toBeNull();
  });

  test('has a stated light where there is neither, and takes over the first picture and the first estimate at once', () => {
    const seen: Seen = { light: null, cameraMean: null };
    const { step, primary } = make(seen);
    step(0);
    expect(rounded(primary.radiance)).toEqual(rounded([...DEFAULT_MEAN].map((mean) => mean * 0.8 * Math.PI)));
    seen.cameraMean = Float32Array.of(0.1, 0.1, 0.1);
    step(0.016);
    expect(rounded(primary.radiance)).toEqual(rounded(new Array(3).fill(0.08 * Math.PI)));
    seen.light = estimate(3);
    step(0);
    expect(rounded(primary.radiance)).toEqual([6, 6, 6]);
  });

  test('its shadow is set up and turned off while running; a reset takes the next light at once', () => {
    const seen: Seen = { light: estimate(1), cameraMean: null };
    const { node, step, set, primary, around, lights } = make(seen, { areaM: 2, mapSize: '1024', biasPx: 3 });
    step(0);
    expect(primary.shadow).toMatchObject({ areaM: 2, mapSizePx: 1024, normalBiasM: (3 * 2) / 1024 });
    set('castShadow', false);
    step(0.1);
    expect(primary.shadow).toBeNull();
    seen.light = estimate(5);
    node.reset?.();
    step(0.01);
    expect([around.sphericalHarmonics[0], lights.version]).toEqual([5, 1]);
  });
});

test('asks for the camera only where that is wanted, and never requires it', () => {
  const asked = (params: Record<string, boolean>) =>
    new TestStudio({ library: LIBRARY, readShader })
      .add('box-a', 'objects/primitive')
      .add('room-a', 'world/light-estimate', params)
      .add('scene-a', 'layer/scene')
      .add('screen-a', 'output/screen')
      .wire('box-a.objects -> scene-a.objects', 'room-a.lights -> scene-a.lights', 'scene-a.layer -> screen-a.layer')
      .compile()
      .output?.needs.map(({ capability, required }) => [capability, required]);
  expect(asked({})).toEqual([['light-estimation', false]]);
  expect(asked({ guessFromCamera: true })).toEqual([
    ['camera-image', false],
    ['light-estimation', false],
  ]);
});
