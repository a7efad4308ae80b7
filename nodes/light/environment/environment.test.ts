import { expect, test } from '@jest/globals';
import { fakeContext } from '../../../tests/support/node-context.ts';
import type { EnvironmentAsset } from '../../kit/assets.ts';
import type { EnvironmentOutput } from '../../kit/scene-lists.ts';
import { definition } from './definition.ts';
import { create } from './runtime.ts';

/** What it looks like is proved on pixels, in `tests/browser/scenes-environments.test.ts`. */
test('hands on the panorama once it has loaded, with both brightnesses multiplied and both turns added', () => {
  const asset = {} as EnvironmentAsset;
  const environment: EnvironmentOutput = { asset: null, intensity: 4, rotationRad: 1 };
  const { ctx, set } = fakeContext(definition, { params: { intensity: 0.5, rotationRad: 0.25 }, inputs: { environment } });
  const node = create(ctx);
  const { lights } = ctx.outputs;
  node.update({} as never);
  expect(lights).toEqual({
    version: 1,
    items: [{ key: 'light', kind: 'environment', environment: null, intensity: 2, rotationRad: 1.25, visible: false }],
  });
  environment.asset = asset;
  set('visible', true);
  node.update({} as never);
  expect(lights.items[0]).toMatchObject({ environment: asset, visible: true });
  // The light is the same one: nothing that draws has to be created again.
  expect(lights.version).toBe(1);
});
