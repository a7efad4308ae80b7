import { describe, expect, test } from '@jest/globals';
import { openTestEditor } from '../../../tests/support/test-editor.ts';
import { undo } from '../document/apply.ts';
import { graphOf, layoutOf, nodeOf } from '../editor/document.ts';
import type { Editor } from '../editor/editor.ts';
import { addFiles } from '../files/add-files.ts';
import { filesOf } from '../files/files.ts';
import { addNodeFromPalette, connect } from './edit-graph.ts';
import { placeAsset } from './place-asset.ts';
import { createSubgraph, openSubgraph } from './subgraphs.ts';

const AT = { x: 0, y: 400 };
const MODEL = { name: 'cup.glb', arrayBuffer: async () => new ArrayBuffer(8) };

const typeOf = (editor: Editor, id: string) => nodeOf(editor.document.getState(), id)?.type.split('/')[1];
const wiresOf = (editor: Editor) =>
  graphOf(editor.document.getState())
    .wires.map(({ from, to }) => `${typeOf(editor, from.node)} > ${typeOf(editor, to.node)}.${to.port}`)
    .sort();

function add(editor: Editor, type: string): string {
  const definition = editor.document.getState().library.definition(type);
  const id = definition ? addNodeFromPalette(editor, { definition, port: null }, { x: 400, y: 0 }, null) : null;
  if (id === null) throw new Error(`${type} was not added.`);
  return id;
}

describe('a model that is dropped', () => {
  test('is drawn over what the output shows, with a light, in one undo step', async () => {
    const { editor } = await openTestEditor();
    const camera = add(editor, 'source/camera-video');
    const screen = add(editor, 'output/screen');
    connect(editor, { node: camera, port: 'layer' }, { node: screen, port: 'layer' });
    const before = filesOf(editor);
    await addFiles(editor, [MODEL], AT);
    expect(wiresOf(editor)).toEqual([
      'camera-video > over.bottom',
      'directional > scene.lights',
      'model > transform.objects',
      'over > screen.layer',
      'scene > over.top',
      'transform > scene.objects',
    ]);
    // The output stays to the right of what leads to it.
    const places = layoutOf(editor.document.getState()).nodes;
    const over = Object.keys(places).find((id) => typeOf(editor, id) === 'over') ?? '';
    expect(places[screen]?.x).toBeGreaterThan((places[over]?.x ?? Number.NaN) + 184);
    undo(editor);
    expect(filesOf(editor)).toEqual(before);
  });

  test('joins the scene and the shadow of the graph', async () => {
    const { editor } = await openTestEditor();
    add(editor, 'output/screen');
    add(editor, 'layer/scene');
    add(editor, 'layer/shadow');
    await addFiles(editor, [MODEL], AT);
    const wires = wiresOf(editor);
    expect(wires).toContain('transform > scene.objects');
    expect(wires).toContain('transform > shadow.casters');
    expect(wires.some((wire) => wire.includes('over'))).toBe(false);
  });

  test('is left to the user where there is no output, or several scenes, or in a subgraph', async () => {
    const { editor } = await openTestEditor();
    await addFiles(editor, [MODEL], AT);
    expect(wiresOf(editor)).toEqual([]);
    add(editor, 'output/screen');
    add(editor, 'layer/scene');
    add(editor, 'layer/scene');
    await addFiles(editor, [MODEL], AT);
    expect(wiresOf(editor)).toEqual([]);
    editor.selection.setState({ nodes: new Set([add(editor, 'filter/sepia')]) });
    const subgraph = createSubgraph(editor);
    if (typeof subgraph === 'string') openSubgraph(editor, subgraph);
    await addFiles(editor, [MODEL], AT);
    expect(wiresOf(editor).filter((wire) => wire.startsWith('model'))).toEqual([]);
  });
});

describe('a captured place, or splats', () => {
  const withCapture = async () => {
    const opened = await openTestEditor();
    const asset = { path: 'assets/room.capture/capture.json', kind: 'capture' } as const;
    const place = () => placeAsset(opened.editor, { id: 'room', asset }, AT);
    return { ...opened, place };
  };

  test('is on the screen at once, over what was there, in one undo step', async () => {
    const { editor, place } = await withCapture();
    const screen = add(editor, 'output/screen');
    const empty = filesOf(editor);
    place();
    expect(wiresOf(editor)).toEqual(['capture > screen.layer']);
    undo(editor);
    expect(filesOf(editor)).toEqual(empty);

    connect(editor, { node: add(editor, 'source/camera-video'), port: 'layer' }, { node: screen, port: 'layer' });
    const before = filesOf(editor);
    const node = place() ?? '';
    expect(wiresOf(editor)).toEqual(['camera-video > over.bottom', 'capture > over.top', 'over > screen.layer']);
    const places = layoutOf(editor.document.getState()).nodes;
    expect(places[screen]?.x).toBeGreaterThan((places[node]?.x ?? Number.NaN) + 2 * 184);
    undo(editor);
    expect(filesOf(editor)).toEqual(before);
    await addFiles(editor, [{ name: 'vase.sog', arrayBuffer: async () => new ArrayBuffer(8) }], AT);
    expect(wiresOf(editor)).toEqual(['camera-video > over.bottom', 'over > screen.layer', 'splats > over.top']);
  });

  test('is left to the user where there is no output', async () => {
    const { editor, place } = await withCapture();
    place();
    expect(wiresOf(editor)).toEqual([]);
  });
});

describe('new nodes', () => {
  const boxes = (editor: Editor) =>
    Object.values(layoutOf(editor.document.getState()).nodes).map(({ x, y }) => ({ x, y, width: 184, height: 64 }));
  const covered = (editor: Editor) =>
    boxes(editor).filter((a, i) =>
      boxes(editor).some((b, j) => i < j && a.x < b.x + b.width && b.x < a.x + a.width && a.y < b.y + b.height && b.y < a.y + a.height),
    );

  test('cover no others, wherever they are added and whatever comes along', async () => {
    const { editor } = await openTestEditor();
    for (const type of ['output/screen', 'source/camera-video', 'layer/scene', 'layer/depth-occlusion', 'filter/sepia']) add(editor, type);
    await addFiles(editor, [MODEL, MODEL], { x: 400, y: 0 });
    expect(boxes(editor).length).toBeGreaterThanOrEqual(10);
    expect(covered(editor)).toEqual([]);
  });
});
