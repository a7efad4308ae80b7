import { expect, test } from '@jest/globals';
import { type Mesh, Vector3 } from 'three';
import { fakeContext } from '../../../tests/support/node-context.ts';
import type { AssetHandle, AssetService } from '../../kit/assets.ts';
import type { CaptureMesh } from '../../kit/capture.ts';
import type { CaptureAsset, CaptureFacts } from '../../kit/capture-asset.ts';
import { createCapturedPlace, writeCapturedPlace } from '../../kit/captured-place.ts';
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

test('takes the mesh and its place from a wire, follows it to another capture, and loads nothing itself', () => {
  const place = createCapturedPlace();
  const { ctx } = fakeContext(definition, { params: { positionM: [9, 9, 9] }, inputs: { capture: place } });
  const { objects } = ctx.outputs;
  const node = create(ctx);
  const params = { positionM: { value: Float64Array.of(1, 2, 3) }, rotationRad: { value: new Float64Array(3) }, scale: { value: 2 } };
  const bring = (next: CaptureMesh | null) => {
    writeCapturedPlace(place, next && ({ mesh: next } as Partial<CaptureFacts> as CaptureFacts), params);
    node.update({} as never);
    return objects.items.map(({ root }) => (root as Mesh).geometry.getAttribute('position').getX(1));
  };
  const corner = () => new Vector3(1, 0, 0).applyMatrix4(objects.items[0]?.worldFromObject as never).toArray();
  expect(bring(null)).toEqual([]);
  const first = mesh(1);
  expect([bring(first), corner()]).toEqual([[1], [3, 2, 3]]);
  const { version } = objects;
  params.positionM.value = Float64Array.of(0, 2, 3);
  expect([bring(first), corner(), objects.version]).toEqual([[1], [2, 2, 3], version]);
  expect([bring(mesh(5)), objects.version > version]).toEqual([[5], true]);
  // As when the file of the capture is removed.
  expect(bring(null)).toEqual([]);
  node.dispose();
});
