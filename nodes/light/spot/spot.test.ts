import { describe, expect, test } from '@jest/globals';
import { fakeContext } from '../../../tests/support/node-context.ts';
import type { ParamValue } from '../../kit/definition.ts';
import type { SpotLightItem } from '../../kit/scene-lists.ts';
import { definition } from './definition.ts';
import { create } from './runtime.ts';

function make(params: Record<string, ParamValue>) {
  const { ctx, set } = fakeContext(definition, { params });
  const node = create(ctx);
  node.update({} as never);
  return { node, set, light: ctx.outputs.lights.items[0] as SpotLightItem };
}

/** What it looks like is proved on pixels, in `tests/browser/scenes-lights.test.ts`. */
describe('light/spot', () => {
  test('aims from its place at its target', () => {
    const { light } = make({ positionM: [1, 2, 3], targetM: [1, 0, 3] });
    expect([light.kind, [...light.positionWorld], [...light.towardsLightWorld]]).toEqual(['spot', [1, 2, 3], [0, 1, 0]]);
  });

  test('aimed at its own position, shines down', () => {
    expect([...make({ positionM: [1, 2, 3], targetM: [1, 2, 3] }).light.towardsLightWorld]).toEqual([0, 1, 0]);
  });

  test('opens by its angle from edge to edge', () => {
    const { light } = make({ angleRad: 1, penumbra: 0.25 });
    expect([light.halfAngleRad, light.penumbra]).toEqual([0.5, 0.25]);
  });

  test('its shadow is turned off and on while running, and keeps its map', () => {
    const { node, light, set } = make({ mapSize: '2048', biasPx: 1 });
    expect(light.shadow).toEqual({ mapSizePx: 2048, biasPx: 1, filter: 'soft', sourceM: 0.1 });
    const { shadow } = light;
    set('castShadow', false);
    node.update({} as never);
    expect(light.shadow).toBeNull();
    set('castShadow', true);
    node.update({} as never);
    expect(light.shadow).toBe(shadow);
  });
});
