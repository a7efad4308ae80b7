import { describe, expect, test } from '@jest/globals';
import { type FakeContextOptions, fakeContext } from '../../../tests/support/node-context.ts';
import type { AssetHandle, AssetService, ImageAsset } from '../../kit/assets.ts';
import type { LayerTexture } from '../../kit/runtime.ts';
import type { Writable } from '../../kit/value-views.ts';
import { definition } from './definition.ts';
import { create } from './runtime.ts';

/** Assets whose one picture loads when told to. */
function assets() {
  const log: string[] = [];
  let value: ImageAsset | null = null;
  const handle: AssetHandle<ImageAsset> = {
    kind: 'image',
    get value() {
      return value;
    },
    settled: Promise.resolve(),
    release: () => log.push('release'),
  };
  const image = (id: string): AssetHandle<ImageAsset> => {
    log.push(`image ${id}`);
    return handle;
  };
  const load = (loaded: ImageAsset): void => {
    value = loaded;
  };
  return { log, service: { image } as Partial<AssetService> as AssetService, load };
}

function start(options: FakeContextOptions<typeof definition>) {
  const { ctx } = fakeContext(definition, options);
  (ctx.outputs.layer.views as Writable<LayerTexture>[]).push({
    texture: null,
    widthPx: 0,
    heightPx: 0,
    uvFromViewUv: new Float32Array(9),
    version: -1,
  });
  return { node: create(ctx), view: ctx.outputs.layer.views[0] };
}

describe('an image file', () => {
  test('is transparent until it has loaded, and has its own size then', () => {
    const { service, load, log } = assets();
    const { node, view } = start({ params: { file: 'photo' }, services: { assets: service } });
    node.update({} as never);
    expect(view?.texture).toBeNull();
    const texture = {} as WebGLTexture;
    load({ texture, widthPx: 300, heightPx: 200 });
    node.update({} as never);
    expect(view).toMatchObject({ widthPx: 300, heightPx: 200 });
    expect(view?.texture).toBe(texture);
    node.dispose();
    expect(log).toEqual(['image photo', 'release']);
  });

  test('without a file loads nothing', () => {
    const { node, view } = start({});
    node.update({} as never);
    node.dispose();
    expect(view?.texture).toBeNull();
  });
});
