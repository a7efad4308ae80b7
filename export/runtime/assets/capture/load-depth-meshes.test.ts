import { expect, test } from '@jest/globals';
import type { CaptureView } from '../../../../nodes/kit/capture.ts';
import type { GlObjects } from '../../gl/gl-objects.ts';
import { loadDepthMeshes } from './load-depth-meshes.ts';

const FILE = { file: 'depth-meshes/000.bin', widthPx: 4, heightPx: 3, vertexCount: 3, triangleCount: 1 };
const view = (depthMesh?: CaptureView['depthMesh']) => ({ file: 'a.jpg', ...(depthMesh && { depthMesh }) }) as CaptureView;

/** A mesh of three vertices and one triangle. */
function meshOf({ depth = 2, column = 1, corner = 2 } = {}): ArrayBuffer {
  const data = new DataView(new ArrayBuffer(3 * 8 + 12));
  for (let i = 0; i < 3; i++) {
    data.setUint16(8 * i, column, true);
    data.setFloat32(8 * i + 4, depth, true);
    data.setUint32(24 + 4 * i, i < 2 ? i : corner, true);
  }
  return data.buffer;
}

/** GL that accepts everything, and counts vertex arrays and buffers. */
function fakeObjects() {
  const log: number[][] = [];
  let living = 0;
  const gl = new Proxy({} as WebGL2RenderingContext, {
    get: (_, name) => (target: number, at: number, data: Uint32Array) => {
      if (name === 'bufferSubData' && data instanceof Uint32Array) log.push([at, ...data]);
      return { target };
    },
  });
  const create = () => ({ id: ++living });
  const remove = () => living--;
  const objects = { gl, createVertexArray: create, deleteVertexArray: remove, createBuffer: create, deleteBuffer: remove };
  return { objects: objects as unknown as GlObjects, log, count: () => living };
}

test('joins the meshes of all views into one', async () => {
  const { objects, log, count } = fakeObjects();
  const loaded = await loadDepthMeshes(objects, [view(FILE), view(), view({ ...FILE, file: 'depth-meshes/002.bin' })], async () =>
    meshOf(),
  );
  expect(loaded.views.map((each) => each && [each.firstIndex, each.indexCount])).toEqual([[0, 3], null, [3, 3]]);
  expect(log).toEqual([
    [0, 0, 1, 2],
    [12, 3, 4, 5],
  ]);
  loaded.dispose();
  expect(count()).toBe(0);
});

test('loads what is hidden into an array of its own, whose files have a color per vertex', async () => {
  const { objects, count } = fakeObjects();
  const hidden = { ...FILE, file: 'hidden-meshes/001.bin' };
  const views = [view(FILE), { ...view({ ...FILE, file: 'depth-meshes/001.bin' }), hiddenMesh: hidden }];
  const colored = (bytes: ArrayBuffer, colors: number): ArrayBuffer =>
    Uint8Array.of(...new Uint8Array(bytes), ...new Array(colors).fill(9)).buffer;
  const load = (colors: number) => async (file: string) => (file === hidden.file ? colored(meshOf(), colors) : meshOf());
  const loaded = await loadDepthMeshes(objects, views, load(12));
  expect(loaded.hidden?.views.map((each) => each && [each.firstIndex, each.indexCount])).toEqual([null, [0, 3]]);
  // Two vertex arrays, and five buffers.
  expect(count()).toBe(7);
  loaded.dispose();
  expect(count()).toBe(0);
  await expect(loadDepthMeshes(objects, views, load(8))).rejects.toThrow('hidden-meshes/001.bin has 44 bytes instead of 48');
  expect(count()).toBe(0);
});

test.each<[string, () => ArrayBuffer, string]>([
  ['that was cut', () => meshOf().slice(0, 30), 'has 30 bytes instead of 36'],
  ['with a depth that is not a number', () => meshOf({ depth: Number.NaN }), 'a depth in depth-meshes/000.bin is not above 0'],
  ['with a vertex beyond its map', () => meshOf({ column: 9 }), 'outside its map'],
  ['with a missing vertex', () => meshOf({ corner: 3 }), 'a vertex beyond the 3'],
])('refuses a depth mesh %s, and releases what it has created', async (_, bytes, reason) => {
  const { objects, count } = fakeObjects();
  await expect(loadDepthMeshes(objects, [view(FILE)], async () => bytes())).rejects.toThrow(reason);
  expect(count()).toBe(0);
});

test('refuses a capture without depth meshes', async () => {
  await expect(loadDepthMeshes(fakeObjects().objects, [view()], async () => meshOf())).rejects.toThrow('it has no depth meshes');
});
