import { expect, test } from '@jest/globals';
import { newProject } from '../../../export/graph/new-project.ts';
import type { Project } from '../../../export/graph/project.ts';
import { openTestEditor } from '../../../tests/support/test-editor.ts';
import { undo } from '../document/apply.ts';
import { isUnused, listAssets } from './asset-rows.ts';
import { addAssetToGraph, goToUses, nameOf, refreshAssetFiles, removeUnused, replaceAsset, unusedAssets } from './edit-assets.ts';

const SHADER = `/*{ "ISFVSN": "2", "INPUTS": [{ "NAME": "inputImage", "TYPE": "image" }], "IMPORTED": { "dirt": { "PATH": "../assets/dirt.png" } } }*/
void main() { gl_FragColor = IMG_NORM_PIXEL(inputImage, isf_FragNormCoord) * IMG_NORM_PIXEL(dirt, isf_FragNormCoord); }
`;

const image = (id: string) => ({ type: 'source/image-file', version: 1, params: { file: { value: id } } });
const EXPOSED = { inputs: [], outputs: [] };
const PROJECT: Project = {
  ...newProject('Test'),
  graphs: {
    main: { nodes: { 'one-aaaa': image('cup'), 'two-aaaa': image('cup'), 'lost-aaaa': image('lost') }, wires: [], exposed: EXPOSED },
    inner: { nodes: { 'three-aaaa': image('cup') }, wires: [], exposed: EXPOSED },
  },
  sources: { 'dirty.fs': SHADER },
  assets: {
    cup: { path: 'assets/cup.png', kind: 'image', credit: 'Ada' },
    hall: { path: 'assets/hall.capture/capture.json', kind: 'capture' },
    lost: { path: 'assets/lost.png', kind: 'image' },
    tile: { path: 'assets/tile/tile.gltf', kind: 'model' },
  },
};
const FILES = [
  { path: 'assets/cup.png', bytes: 100 },
  { path: 'assets/dirt.png', bytes: 20 },
  { path: 'assets/hall.capture/capture.json', bytes: 1 },
  { path: 'assets/hall.capture/mesh.bin', bytes: 4000 },
  { path: 'assets/notes.txt', bytes: 7 },
  { path: 'assets/tile/tile.bin', bytes: 9 },
  { path: 'assets/tile/tile.gltf', bytes: 3 },
];

async function openAssets() {
  const opened = await openTestEditor(PROJECT);
  opened.host.answer('asset.list', () => ({ assetFiles: FILES }));
  await refreshAssetFiles(opened.editor);
  return opened;
}

test('each asset is one row, with its size and the nodes and shaders that use it', async () => {
  const { editor } = await openAssets();
  const { rows, others } = listAssets(editor.document.getState());
  expect(rows.map(({ path, bytes, uses, shaders }) => [nameOf(path), bytes, uses.length, shaders])).toEqual([
    ['cup.png', 100, 3, []],
    ['dirt.png', 20, 0, ['dirty.fs']],
    ['hall.capture', 4001, 0, []],
    ['lost.png', null, 1, []],
    ['tile/tile.gltf', 3, 0, []],
  ]);
  expect(rows.filter(isUnused).map(({ id }) => id)).toEqual(['hall', 'tile']);
  expect(others).toEqual([{ path: 'assets/notes.txt', bytes: 7 }]);
});

test('unused assets are removed as one step, and brought back by undo', async () => {
  const { editor } = await openAssets();
  expect(removeUnused(editor, unusedAssets(editor))).toBe(true);
  expect(Object.keys(editor.document.getState().project.assets)).toEqual(['cup', 'lost']);
  expect(removeUnused(editor, unusedAssets(editor))).toBe(false);
  undo(editor);
  expect(Object.keys(editor.document.getState().project.assets).sort()).toEqual(['cup', 'hall', 'lost', 'tile']);
});

test('a replaced file is used by all nodes of the asset, and a missing one is found again', async () => {
  const { editor } = await openAssets();
  const file = { name: 'found.png', arrayBuffer: async () => new ArrayBuffer(4) };
  expect(await replaceAsset(editor, 'lost', [file])).toBe(true);
  expect(editor.document.getState().project.assets.lost).toEqual({ path: 'assets/found.png', kind: 'image' });
  expect(await replaceAsset(editor, 'cup', [file])).toBe(true);
  // The author was that of the file before.
  expect(editor.document.getState().project.assets.cup).toEqual({ path: 'assets/found.png', kind: 'image' });
  expect(listAssets(editor.document.getState()).rows.find(({ id }) => id === 'cup')?.uses).toHaveLength(3);
  expect(await replaceAsset(editor, 'hall', [file])).toBe(false);
});

test('the uses are selected graph by graph', async () => {
  const { editor, clock } = await openAssets();
  const cup = listAssets(editor.document.getState()).rows.find(({ id }) => id === 'cup');
  if (!cup) throw new Error('There is no cup.');
  const shown = () => [editor.document.getState().graph, ...editor.selection.getState().nodes];
  goToUses(editor, cup);
  expect(shown()).toEqual(['main', 'one-aaaa', 'two-aaaa']);
  goToUses(editor, cup);
  clock.pass(100);
  expect(shown()).toEqual(['inner', 'three-aaaa']);
  goToUses(editor, cup);
  expect(shown()).toEqual(['main', 'one-aaaa', 'two-aaaa']);
});

test('an asset becomes the node that outputs it', async () => {
  const { editor } = await openAssets();
  const added = await addAssetToGraph(editor, 'hall', { x: 0, y: 900 });
  expect(editor.document.getState().project.graphs.main?.nodes[added ?? '']).toMatchObject({
    type: 'source/capture',
    params: { file: { value: 'hall' } },
  });
  expect([...editor.selection.getState().nodes]).toEqual([added]);
  expect(
    listAssets(editor.document.getState())
      .rows.filter(isUnused)
      .map(({ id }) => id),
  ).toEqual(['tile']);
});

test('a captured place whose floor is not known stands so that the visitor sees it', async () => {
  const { editor, host } = await openAssets();
  /** Two cameras at these heights, 3 m to the right; both look along +x. */
  const captureAt = (...heightsM: readonly number[]) => ({
    ...{ format: 'scrim-capture', version: 1, mesh: { file: 'mesh.bin', vertexCount: 3, triangleCount: 1 } },
    views: heightsM.map((y, i) => ({
      ...{ file: `${i}.jpg`, widthPx: 4, heightPx: 3, fxPx: 4, fyPx: 4, cxPx: 2, cyPx: 1.5 },
      worldFromCamera: [0, 0, 1, 0, 0, 1, 0, 0, -1, 0, 0, 0, 3, y, 0, 1],
    })),
  });
  const poseOf = async (...heightsM: readonly number[]) => {
    host.answer('asset.read', () => ({ base64: btoa(JSON.stringify(captureAt(...heightsM))) }));
    const node = await addAssetToGraph(editor, 'hall', { x: 0, y: 900 });
    const { positionM, rotationRad } = editor.document.getState().project.graphs.main?.nodes[node ?? '']?.params ?? {};
    return [positionM, rotationRad];
  };
  // The cameras of a photographed scene stand over its floor.
  expect(await poseOf(1.4, 0.2)).toEqual([undefined, undefined]);
  const [position, rotation] = await poseOf(0, 0);
  // Turned by 90° to the left, what was at x = 3 is at z = -3: it comes to the eye, which looks along −z.
  expect(rotation).toEqual({ value: [0, expect.closeTo(Math.PI / 2, 3), 0] });
  expect(position).toEqual({ value: [expect.closeTo(0, 6), 1.6, 3] });
});
