import { expect, test } from '@jest/globals';
import { fakeContext } from '../../../tests/support/node-context.ts';
import type { AssetHandle, AssetService } from '../../kit/assets.ts';
import type { CaptureAsset } from '../../kit/capture-asset.ts';
import { createCapturedPlace } from '../../kit/captured-place.ts';
import { definition } from '../../source/capture/definition.ts';
import { create } from './runtime.ts';

test('outputs the capture while it loads, where the node has it', () => {
  const asked: string[] = [];
  let value: CaptureAsset | null = null;
  let released = false;
  const handle: AssetHandle<CaptureAsset> = {
    kind: 'capture',
    get value() {
      return value;
    },
    settled: Promise.resolve(),
    release: () => {
      released = true;
    },
  };
  const capture = (id: string) => {
    asked.push(id);
    return handle;
  };
  const services = { assets: { capture } as Partial<AssetService> as AssetService };
  const { ctx, set } = fakeContext(definition, { params: { file: 'room', positionM: [1, 2, 3], scale: 2 }, services });
  const place = createCapturedPlace();
  const node = create({ ...ctx, outputs: { ...ctx.outputs, capture: place } });
  node.update({} as never);
  expect(place).toMatchObject({ assetId: 'room', facts: null, scale: 2 });
  const empty = node.version;

  const loaded = { version: 0, loaded: Uint8Array.of(2, 0), viewCount: 2 };
  value = loaded as Partial<CaptureAsset> as CaptureAsset;
  node.update({} as never);
  expect(place.facts).toBe(value);
  expect([...(place.facts?.loaded ?? [])]).toEqual([2, 0]);
  expect([...place.worldFromPlace].map((x) => x || 0)).toEqual([1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 1, 2, 3, 1]);
  // Another photograph arrives: frames must not rest.
  const before = node.version;
  loaded.version++;
  expect(new Set([empty, before, node.version]).size).toBe(3);

  set('rotationRad', [0, Math.PI / 2, 0]);
  set('scale', 0);
  node.update({} as never);
  expect([...place.worldFromPlace].map((x) => Math.round(x) || 0)).toEqual([0, 0, -1, 0, 0, 1, 0, 0, 1, 0, 0, 0, 1, 2, 3, 1]);
  expect(place.scale).toBeGreaterThan(0);
  node.dispose();
  expect([asked, released]).toEqual([['room'], true]);
});
