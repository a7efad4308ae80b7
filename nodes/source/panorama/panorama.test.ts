import { expect, test } from '@jest/globals';
import { fakeContext } from '../../../tests/support/node-context.ts';
import type { AssetHandle, AssetService, EnvironmentAsset } from '../../kit/assets.ts';
import { definition } from './definition.ts';
import { create } from './runtime.ts';

/** One panorama that loads when told to. */
function assets() {
  const log: string[] = [];
  const state: { value: EnvironmentAsset | null } = { value: null };
  const environment = (id: string): AssetHandle<EnvironmentAsset> => {
    log.push(`environment ${id}`);
    return {
      kind: 'environment',
      get value() {
        return state.value;
      },
      settled: Promise.resolve(),
      release: () => log.push('release'),
    };
  };
  return { log, state, service: { environment } as Partial<AssetService> as AssetService };
}

test('gives its panorama once it has loaded, turned, and a stop brighter at twice the radiance', () => {
  const { log, state, service } = assets();
  const { ctx, set } = fakeContext(definition, { params: { file: 'sky', rotationRad: 0.5 }, services: { assets: service } });
  const node = create(ctx);
  const { environment } = ctx.outputs;
  node.update({} as never);
  expect(environment).toEqual({ asset: null, intensity: 1, rotationRad: 0.5 });
  state.value = {} as EnvironmentAsset;
  set('exposure', -2);
  node.update({} as never);
  expect(environment).toEqual({ asset: state.value, intensity: 0.25, rotationRad: 0.5 });
  node.dispose();
  expect(log).toEqual(['environment sky', 'release']);
});

test('without a file loads nothing', () => {
  const { ctx } = fakeContext(definition);
  const node = create(ctx);
  node.update({} as never);
  node.dispose();
  expect(ctx.outputs.environment.asset).toBeNull();
});
