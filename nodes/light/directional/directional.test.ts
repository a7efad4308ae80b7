import { describe, expect, test } from '@jest/globals';
import { fakeContext } from '../../../tests/support/node-context.ts';
import type { ParamValue } from '../../kit/definition.ts';
import type { DirectionalLightItem } from '../../kit/scene-lists.ts';
import { definition } from './definition.ts';
import { create } from './runtime.ts';

function make(params: Record<string, ParamValue>) {
  const { ctx, set } = fakeContext(definition, { params });
  const node = create(ctx);
  node.update({} as never);
  return { node, light: ctx.outputs.lights.items[0] as DirectionalLightItem, lights: ctx.outputs.lights, set };
}

const rounded = (numbers: Iterable<number>): number[] => [...numbers].map((x) => Math.round(x * 1e6) / 1e6 + 0);

describe('light/directional', () => {
  test.each([
    ['from the front', 0, 0, [0, 0, 1]],
    ['from the right', Math.PI / 2, 0, [1, 0, 0]],
    ['from the back', Math.PI, 0, [0, 0, -1]],
    ['from above', 1, Math.PI / 2, [0, 1, 0]],
    ['from the front, halfway up', 0, Math.PI / 4, [0, Math.SQRT1_2, Math.SQRT1_2]],
  ])('%s', (_where, azimuthRad, elevationRad, towards) => {
    expect(rounded(make({ azimuthRad, elevationRad }).light.towardsLightWorld)).toEqual(rounded(towards));
  });

  test('at intensity 1 a white matt surface facing it is white: radiance π, of which it sends back 1/π', () => {
    expect(rounded(make({ intensity: 1 }).light.radiance)).toEqual(rounded([Math.PI, Math.PI, Math.PI]));
    const [red = 0, , blue] = make({ intensity: 2, color: [0.5, 1, 0, 1] }).light.radiance;
    expect([red, blue]).toEqual([expect.closeTo(2 * Math.PI * 0.21404, 4), 0]);
  });

  test('shadows can be turned off and on, and the map set up, while running', () => {
    const { node, light, set } = make({ areaM: 2, mapSize: '1024', biasPx: 3 });
    expect(light.shadow).toEqual({ areaM: 2, mapSizePx: 1024, bias: 0, normalBiasM: (3 * 2) / 1024, filter: 'soft', sourceRad: 0.1 });
    const { shadow } = light;
    set('castShadow', false);
    node.update({} as never);
    expect(light.shadow).toBeNull();
    set('castShadow', true);
    set('areaM', 4);
    node.update({} as never);
    expect(light.shadow).toBe(shadow);
    expect(light.shadow?.areaM).toBe(4);
  });

  test('its contact shadow is another light for shadows alone, there while its strength is above 0', () => {
    const { node, lights, set } = make({ contact: 0.5, areaM: 2 });
    const [light, contact] = lights.items as DirectionalLightItem[];
    expect(contact).toMatchObject({ onlyShadows: true, shadow: { areaM: 2, filter: 'pcss' } });
    expect(rounded(contact?.towardsLightWorld ?? [])).toEqual([0, 1, 0]);
    expect(contact?.radiance[0]).toBeCloseTo((light?.radiance[0] ?? 0) / 2, 5);
    const { version } = lights;
    node.update({} as never);
    expect(lights.version).toBe(version);
    set('contact', 0);
    node.update({} as never);
    expect([lights.items.length, lights.version > version]).toEqual([1, true]);
  });
});
