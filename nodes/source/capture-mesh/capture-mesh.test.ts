import { expect, test } from '@jest/globals';
import { type Mesh, Vector3 } from 'three';
import { fakeContext } from '../../../tests/support/node-context.ts';
import type { AssetHandle, AssetService } from '../../kit/assets.ts';
import type { CaptureMesh } from '../../kit/capture.ts';
import type { CaptureAsset } from '../../kit/capture-asset.ts';
import { definition } from './definition.ts';
import { create } from './runtime.ts';

const mesh = (size: number): CaptureMesh => ({
  positions: Float32Array.of(0, 0, 0, size, 0, 0, 0, size, 0),
  indices: Uint32Array.of(0, 1, 2),
});

test('outputs the mesh as a phantom where the capture is, and replaces a coarse one', () => {
  let released = false;
  let value: CaptureAsset | null = null;
  const load = (next: CaptureMesh) => {
    value = { mesh: next } as Partial<CaptureAsset> as CaptureAsset;
  };
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
  const assets = { capture: () => handle } as Partial<AssetService> as AssetService;
  const { ctx, set } = fakeContext(definition, { params: { file: 'room', positionM: [1, 2, 3], scale: 2 }, services: { assets } });
  const { objects } = ctx.outputs;
  const node = create(ctx);
  node.update({} as never);
  expect(objects.items).toEqual([]);
  const before = node.version ?? 0;

  load(mesh(1));
  node.update({} as never);
  node.update({} as never);
  const [coarse] = objects.items;
  expect(coarse).toMatchObject({ role: 'phantom', castsShadow: false, receivesShadow: true });
  // The second vertex, turned by a quarter around y.
  set('rotationRad', [0, Math.PI / 2, 0]);
  node.update({} as never);
  const corner = new Vector3(1, 0, 0).applyMatrix4(coarse?.worldFromObject as never).toArray();
  expect(corner.map((x) => Number(x.toFixed(5)))).toEqual([1, 2, 1]);
  expect(node.version).toBe(before + 1);

  load(mesh(7));
  set('castShadow', true);
  node.update({} as never);
  expect(objects.items).toHaveLength(1);
  const root = objects.items[0]?.root as Mesh;
  expect([root.geometry.getAttribute('position').getX(1), objects.items[0]?.castsShadow, node.version]).toEqual([7, true, before + 2]);
  node.dispose();
  expect(released).toBe(true);
});
