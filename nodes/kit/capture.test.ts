import { expect, test } from '@jest/globals';
import { readCapture } from './capture.ts';

const IDENTITY = [1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1];
const MESH = { file: 'mesh.bin', vertexCount: 3, triangleCount: 1 };
const CAMERA = { widthPx: 8, heightPx: 4, fxPx: 8, fyPx: 8, cxPx: 4, cyPx: 2, worldFromCamera: IDENTITY };
const DEPTH_MESH = { ...MESH, file: 'depth-meshes/000.bin', widthPx: 8, heightPx: 4 };
const DEPTH = { file: 'depths/000.png', widthPx: 8, heightPx: 4, metersPerLevel: 0.001 };

const documentOf = (view: object): string =>
  JSON.stringify({ format: 'scrim-capture', version: 2, mesh: MESH, views: [{ file: 'views/000.jpg', ...CAMERA, ...view }] });

test('reads depth, depth meshes and 360° cameras', () => {
  const view = { depth: DEPTH, depthMesh: DEPTH_MESH, projection: 'equirectangular' };
  expect(readCapture(documentOf(view)).views[0]).toEqual({ file: 'views/000.jpg', ...CAMERA, ...view });
});

test.each([
  [{ depthMesh: { ...DEPTH_MESH, file: '../000.bin' } }, 'the depth mesh of view 1 is not a path inside the capture'],
  [{ hiddenMesh: { ...DEPTH_MESH, file: '..' } }, 'the hidden mesh of view 1 is not a path inside the capture'],
  [{ depth: { ...DEPTH, file: '/etc/passwd' } }, 'the depth of view 1 is not a path inside the capture'],
  [{ depth: { ...DEPTH, file: 'views/000.jpg' } }, 'two views have the file "views/000.jpg"'],
  [{ depth: { ...DEPTH, metersPerLevel: 0 } }, 'the unit of the depth of view 1 is not above 0'],
  [{ depthMesh: { ...DEPTH_MESH, triangleCount: 10_000_000 } }, 'more than 4000000'],
  [{ depthMesh: { ...DEPTH_MESH, widthPx: 1e6 } }, 'the width of the depth mesh of view 1'],
  [{ projection: 'fisheye' }, 'the projection of view 1 is not known'],
])('refuses a view with %j', (view, reason) => {
  expect(() => readCapture(documentOf(view))).toThrow(reason);
});
