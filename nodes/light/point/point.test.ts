import { describe, expect, test } from '@jest/globals';
import { fakeContext } from '../../../tests/support/node-context.ts';
import type { ParamValue } from '../../kit/definition.ts';
import type { PointLightItem } from '../../kit/scene-lists.ts';
import { definition } from './definition.ts';
import { create } from './runtime.ts';

function make(params: Record<string, ParamValue>) {
  const { ctx, set } = fakeContext(definition, { params });
  const node = create(ctx);
  node.update({} as never);
  return { node, set, light: ctx.outputs.lights.items[0] as PointLightItem };
}

/** What it looks like is proved on pixels, in `tests/browser/scenes-lights.test.ts`. */
describe('light/point', () => {
  test('shines with its candela, in its linear color, from its place', () => {
    const { light } = make({ intensityCd: 2, color: [0.5, 1, 0, 1], positionM: [1, -2, 3], rangeM: 4 });
    // sRGB 0.5 is 0.21404 in linear light.
    expect([...light.intensityCd]).toEqual([expect.closeTo(0.42808, 4), expect.closeTo(2, 6), 0]);
    expect([light.kind, [...light.positionWorld], light.rangeM]).toEqual(['point', [1, -2, 3], 4]);
  });

  test('moves, and its shadow is turned off and on, while running', () => {
    const { node, light, set } = make({ mapSize: '512', biasPx: 3 });
    expect(light.shadow).toEqual({ mapSizePx: 512, biasPx: 3, filter: 'soft' });
    const { shadow } = light;
    set('castShadow', false);
    set('positionM', [0, 5, 0]);
    node.update({} as never);
    expect([light.shadow, [...light.positionWorld]]).toEqual([null, [0, 5, 0]]);
    set('castShadow', true);
    node.update({} as never);
    // The same settings: the map is kept.
    expect(light.shadow).toBe(shadow);
  });
});
