import { Document, NodeIO } from '@gltf-transform/core';
import { describe, expect, test } from '@jest/globals';
import { openTestEditor } from '../../../tests/support/test-editor.ts';
import { historySteps, undo } from '../document/apply.ts';
import { graphOf, layoutOf } from '../editor/document.ts';
import type { Editor } from '../editor/editor.ts';
import { addNodeFromPalette } from '../graph/edit-graph.ts';
import { NODE_WIDTH } from '../graph/node-shape.ts';
import { acceptedNames, addFiles, kindOfFile } from './add-files.ts';

test.each([
  ['Robot.GLB', 'model'],
  ['photo.jpeg', 'image'],
  ['Clip.MP4', 'video'],
  ['sticker.webm', 'video'],
  ['sky.hdr', 'environment'],
  ['studio.EXR', 'environment'],
  ['garden.ply', 'splats'],
  ['Vase.SOG', 'splats'],
  ['edge.fs', 'shader'],
  ['notes.txt', null],
])('%s is dropped as %s', (name, kind) => {
  expect(kindOfFile(name)).toBe(kind);
});

test('a panorama may be chosen among ordinary pictures, a video may not', () => {
  expect(acceptedNames('environment').split(',')).toEqual(['.hdr', '.exr', '.jpg', '.jpeg', '.png', '.webp', '.avif']);
  expect(acceptedNames('video')).not.toContain('.jpg');
});

const textFile = (name: string, text: string) => ({
  name,
  arrayBuffer: async () => new TextEncoder().encode(text).buffer as ArrayBuffer,
});

/** A model of one triangle with these sizes. */
async function modelFile(name: string, widthM: number, depthM: number) {
  const doc = new Document();
  doc.createBuffer();
  const corners = new Float32Array([0, 0, 0, widthM, 0, 0, 0, 0.5, depthM]);
  const position = doc.createAccessor().setType('VEC3').setArray(corners);
  doc
    .createScene()
    .addChild(doc.createNode().setMesh(doc.createMesh().addPrimitive(doc.createPrimitive().setAttribute('POSITION', position))));
  const bytes = await new NodeIO().writeBinary(doc);
  return { name, arrayBuffer: async () => bytes.slice().buffer };
}

/** An editor whose graph has an output and a filter. */
async function openWithOutput(): Promise<Editor> {
  const { editor } = await openTestEditor();
  for (const [i, type] of ['output/screen', 'filter/sepia'].entries()) {
    const definition = editor.document.getState().library.definition(type);
    if (definition) addNodeFromPalette(editor, { definition, port: null }, { x: 400 * i, y: 0 }, null);
  }
  return editor;
}

test('models that are dropped together stand side by side, in one undo step', async () => {
  const editor = await openWithOutput();
  const before = Object.keys(graphOf(editor.document.getState()).nodes);
  const widthsM = [0.8, 0.4, 1];
  const files = await Promise.all(widthsM.map((widthM, i) => modelFile(`model-${i}.glb`, widthM, 0.6)));
  await addFiles(editor, files, { x: 0, y: 0 }, [0, -2]);
  const { nodes } = graphOf(editor.document.getState());
  const transforms = Object.keys(nodes).filter((id) => nodes[id]?.type === 'objects/transform');
  const starts = transforms.map((id) => {
    const binding = nodes[id]?.params.positionM;
    return binding && 'value' in binding ? binding.value : null;
  });
  // Each box begins where the one before ends, and 10 cm further: 0.8 + 0.1, then 0.4 + 0.1.
  expect(starts).toEqual([
    [-1.15, 0, -2.3],
    [-0.25, 0, -2.3],
    [0.25, 0, -2.3],
  ]);
  expect(historySteps(editor.document.getState().history).at(-1)?.label).toBe('Add files');
  undo(editor);
  expect(Object.keys(graphOf(editor.document.getState()).nodes)).toEqual(before);
  expect(editor.document.getState().project.assets).toEqual({});
});

const FILTER = `/*{ "ISFVSN": "2", "INPUTS": [{ "NAME": "inputImage", "TYPE": "image" }] }*/
void main() { gl_FragColor = IMG_THIS_PIXEL(inputImage); }
`;
const TABLE = ['LUT_3D_SIZE 2', '0 0 0', '1 0 0', '0 1 0', '1 1 0', '0 0 1', '1 0 1', '0 1 1', '1 1 1'].join('\n');

describe('dropped on a node, they cover none', () => {
  /** Pairs of nodes whose heads cover each other. */
  const covering = (editor: Editor) => {
    const places = Object.entries(layoutOf(editor.document.getState()).nodes);
    return places.flatMap(([a, at], i) =>
      places.slice(i + 1).flatMap(([b, { x, y }]) => (Math.abs(at.x - x) < NODE_WIDTH && Math.abs(at.y - y) < 24 ? [`${a} ${b}`] : [])),
    );
  };

  test.each([
    ['a filter', [textFile('plain.fs', FILTER)], 1],
    ['several filters', [textFile('plain.fs', FILTER), textFile('other.fs', FILTER)], 2],
    ['a color table', [textFile('warm.cube', TABLE)], 2],
  ])('%s', async (_, files, count) => {
    const editor = await openWithOutput();
    const { nodes } = layoutOf(editor.document.getState());
    expect(Object.values(nodes)).toHaveLength(2);
    for (const { x, y } of Object.values(nodes).slice(0, 1)) await addFiles(editor, files, { x, y });
    const after = layoutOf(editor.document.getState()).nodes;
    expect(Object.keys(after)).toHaveLength(Object.keys(nodes).length + count);
    expect(after).toMatchObject(nodes);
    expect(covering(editor)).toEqual([]);
    undo(editor);
    expect(layoutOf(editor.document.getState()).nodes).toEqual(nodes);
  });
});
