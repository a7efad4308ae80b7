import { describe, expect, test } from '@jest/globals';
import { putAsset } from '../../../export/graph/commands/asset-commands.ts';
import { sequence } from '../../../export/graph/commands/change.ts';
import { setParam } from '../../../export/graph/commands/param-commands.ts';
import { openTestEditor } from '../../../tests/support/test-editor.ts';
import { clipSelection, copySelection, duplicateSelection, parseClipping, pasteClipping, pasteText } from '../clipboard/clipboard.ts';
import { apply, undo } from '../document/apply.ts';
import { editShader } from '../document/edit-shader.ts';
import { graphOf, layoutOf } from '../editor/document.ts';
import type { Editor } from '../editor/editor.ts';
import { selectOnly } from '../editor/selection.ts';
import { filesOf } from '../files/files.ts';
import { align, distribute, selectedBoxes, tidy } from './arrange.ts';
import { addNodeFromPalette, connect, swapType, toggleCollapsed, toggleMuted, toggleUnfused } from './edit-graph.ts';
import { findNodes } from './find.ts';
import { canInsert, dropOnWire } from './insert-on-wire.ts';
import { moveAll } from './layout-items.ts';
import { createSubgraph } from './subgraphs.ts';

function add(editor: Editor, type: string, x = 0, y = 0, wire: string | null = null): string {
  const definition = editor.document.getState().library.definition(type);
  const id = definition ? addNodeFromPalette(editor, { definition, port: null }, { x, y }, null, wire) : null;
  if (id === null) throw new Error(`${type} was not added.`);
  return id;
}

const wiresOf = (editor: Editor) => graphOf(editor.document.getState()).wires.map(({ from, to }) => `${from.node} ${to.node}.${to.port}`);
const typeOf = (editor: Editor, id: string) => graphOf(editor.document.getState()).nodes[id]?.type;
const placeOf = (editor: Editor, id: string) => layoutOf(editor.document.getState()).nodes[id];

/** Two pictures laid over each other, the lower one first; a filter stands by. */
async function over() {
  const { editor } = await openTestEditor();
  const [low, high] = [add(editor, 'source/camera-video'), add(editor, 'source/image-file', 0, 200)];
  const blend = add(editor, 'operator/over', 300, 40);
  connect(editor, { node: low, port: 'layer' }, { node: blend, port: 'bottom' });
  connect(editor, { node: high, port: 'layer' }, { node: blend, port: 'top' });
  return { editor, low, high, blend, wire: `${high}.layer -> ${blend}.top` };
}

describe('a node goes into a wire', () => {
  test('that it is dropped on, with its move, in one step', async () => {
    const { editor, high, blend, wire } = await over();
    const sepia = add(editor, 'filter/sepia', 0, 400);
    const before = filesOf(editor);
    expect(canInsert(editor, sepia, wire)).toBe(true);
    dropOnWire(editor, sepia, { x: 150, y: 100 }, wire);
    expect(wiresOf(editor)).toEqual(expect.arrayContaining([`${high} ${sepia}.inputImage`, `${sepia} ${blend}.top`]));
    expect(wiresOf(editor)).toHaveLength(3);
    expect(placeOf(editor, sepia)).toEqual({ x: 150, y: 100 });
    undo(editor);
    expect(filesOf(editor)).toEqual(before);
  });

  test('and those after it make room for it, in the same step', async () => {
    const { editor } = await openTestEditor();
    const [video, blur] = [add(editor, 'source/camera-video'), add(editor, 'filter/gaussian-blur', 240, 0)];
    const [above, after] = [add(editor, 'filter/grey', 240, -400), add(editor, 'filter/threshold', 480, 16)];
    connect(editor, { node: video, port: 'layer' }, { node: blur, port: 'inputImage' });
    connect(editor, { node: video, port: 'layer' }, { node: above, port: 'inputImage' });
    connect(editor, { node: blur, port: 'layer' }, { node: after, port: 'inputImage' });
    const sepia = add(editor, 'filter/sepia', 0, 400);
    const before = filesOf(editor);
    dropOnWire(editor, sepia, { x: 120, y: 8 }, `${video}.layer -> ${blur}.inputImage`);
    expect(placeOf(editor, video)).toEqual({ x: 0, y: 0 });
    expect(placeOf(editor, sepia)).toEqual({ x: 224, y: 8 });
    expect(placeOf(editor, blur)).toEqual({ x: 448, y: 0 });
    expect(placeOf(editor, after)).toEqual({ x: 688, y: 16 });
    expect(placeOf(editor, above)).toEqual({ x: 240, y: -400 });
    undo(editor);
    expect(filesOf(editor)).toEqual(before);
  });

  test('that the palette was asked for at', async () => {
    const { editor, high, wire } = await over();
    const sepia = add(editor, 'filter/sepia', 0, 0, wire);
    expect(wiresOf(editor)).toContain(`${high} ${sepia}.inputImage`);
    undo(editor);
    expect(wiresOf(editor)).toHaveLength(2);
  });

  test('but not when it is wired already, or of another kind', async () => {
    const { editor, blend, low, wire } = await over();
    expect(canInsert(editor, add(editor, 'value/math'), wire)).toBe(false);
    expect(canInsert(editor, add(editor, 'layer/scene'), wire)).toBe(false);
    expect(canInsert(editor, low, wire)).toBe(false);
    expect(canInsert(editor, blend, wire)).toBe(false);
  });

  test('and keeps the order at a port for several', async () => {
    const { editor } = await openTestEditor();
    const [a, b, scene] = [add(editor, 'objects/primitive'), add(editor, 'objects/primitive'), add(editor, 'layer/scene')];
    for (const node of [a, b]) connect(editor, { node, port: 'objects' }, { node: scene, port: 'objects' });
    const place = add(editor, 'objects/transform', 0, 0, `${a}.objects -> ${scene}.objects`);
    expect(wiresOf(editor).filter((wire) => wire.includes(`${scene}.objects`))).toEqual([
      `${place} ${scene}.objects`,
      `${b} ${scene}.objects`,
    ]);
  });
});

describe('nodes are arranged', () => {
  test('on one line, by any side', async () => {
    const { editor, low, high, blend } = await over();
    selectOnly(editor.selection, [low, high, blend]);
    align(editor, 'left');
    expect([low, high, blend].map((id) => placeOf(editor, id)?.x)).toEqual([0, 0, 0]);
    align(editor, 'bottom');
    expect(new Set(selectedBoxes(editor).map(({ y, height }) => y + height)).size).toBe(1);
  });

  test('with equal gaps', async () => {
    const { editor, low, high, blend } = await over();
    moveAll(editor, { [low]: { x: 0, y: 0 }, [high]: { x: 210, y: 0 }, [blend]: { x: 1000, y: 0 } });
    selectOnly(editor.selection, [low, high, blend]);
    distribute(editor, 'x');
    const [first, second, third] = [...selectedBoxes(editor)].sort((a, b) => a.x - b.x);
    if (!first || !second || !third) throw new Error('Boxes are missing.');
    expect(second.x - first.x - first.width).toBeCloseTo(third.x - second.x - second.width, -1);
  });

  test('along their wires, without laying one over another, in one step', async () => {
    const { editor, low, high, blend } = await over();
    moveAll(editor, { [low]: { x: 500, y: 8 }, [high]: { x: 480, y: 0 }, [blend]: { x: 0, y: 0 } });
    const before = filesOf(editor);
    selectOnly(editor.selection, []);
    await tidy(editor);
    const x = (id: string) => placeOf(editor, id)?.x ?? Number.NaN;
    expect(x(low)).toBeLessThan(x(blend));
    expect(x(high)).toBeLessThan(x(blend));
    expect(Math.abs((placeOf(editor, low)?.y ?? 0) - (placeOf(editor, high)?.y ?? 0))).toBeGreaterThan(60);
    undo(editor);
    expect(filesOf(editor)).toEqual(before);
  });
});

test('another type takes over wires and values that fit', async () => {
  const { editor, blend, low } = await over();
  swapType(editor, blend, 'operator/blend');
  expect(typeOf(editor, blend)).toBe('operator/blend');
  expect(wiresOf(editor).some((wire) => wire.startsWith(low))).toBe(true);
  undo(editor);
  expect(typeOf(editor, blend)).toBe('operator/over');
});

describe('copies', () => {
  test('are wired to what the originals are wired to, where that is asked for', async () => {
    const { editor, blend } = await over();
    selectOnly(editor.selection, [blend]);
    toggleMuted(editor);
    toggleUnfused(editor);
    toggleCollapsed(editor);
    duplicateSelection(editor, { wired: true });
    const [copy] = editor.selection.getState().nodes;
    expect(wiresOf(editor).filter((wire) => wire.includes(`${copy}.`))).toHaveLength(2);
    expect(graphOf(editor.document.getState()).nodes[copy ?? '']?.muted).toBe(true);
    expect(graphOf(editor.document.getState()).nodes[copy ?? '']?.unfused).toBe(true);
    expect(placeOf(editor, copy ?? '')?.collapsed).toBe(true);
  });

  test('bring their subgraphs and shaders into another project, once', async () => {
    const { editor } = await openTestEditor();
    const [sepia, blur] = [add(editor, 'filter/sepia'), add(editor, 'filter/gaussian-blur')];
    connect(editor, { node: sepia, port: 'layer' }, { node: blur, port: 'inputImage' });
    const text = editor.document.getState().library.shader('filters/sepia.fs') ?? '';
    editShader(editor, sepia, text.replace('void main', '// mine\nvoid main'));
    selectOnly(editor.selection, [sepia, blur]);
    createSubgraph(editor);
    const copied = JSON.stringify(clipSelection(editor));

    const other = (await openTestEditor()).editor;
    const clipping = parseClipping(copied);
    if (!clipping) throw new Error('What was copied is no clipping.');
    const empty = filesOf(other);
    for (let times = 0; times < 2; times++) pasteClipping(other, clipping, 'Paste', { x: 0, y: 0 });
    const { project, library } = other.document.getState();
    expect(Object.keys(project.graphs)).toEqual(['main', 'subgraph', 'subgraph-2']);
    expect(Object.values(project.sources)).toEqual([expect.stringContaining('// mine')]);
    expect(library.definition('graph/subgraph')?.title).toBe('Subgraph');
    undo(other);
    undo(other);
    expect(filesOf(other)).toEqual(empty);
  });

  test('bring what their assets have in their files into a project without them, and nothing into their own', async () => {
    const { editor } = await openTestEditor();
    const image = add(editor, 'source/image-file');
    const { project, library } = editor.document.getState();
    apply(
      editor,
      'Import',
      sequence(
        project,
        (before) => putAsset(before, { id: 'cup-a2b3', asset: { path: 'assets/cup.png', kind: 'image' } }),
        (before) => setParam(before, { library, graph: 'main', node: image, param: 'file', value: 'cup-a2b3' }),
      ),
    );
    selectOnly(editor.selection, [image]);
    await copySelection(editor);
    const copied = await editor.clipboard.read();

    const { editor: other, host } = await openTestEditor();
    host.answer('asset.import', ({ name }) => ({ path: `assets/2-${name}` }));
    await pasteText(other, copied);
    const { assets, graphs } = other.document.getState().project;
    expect(assets).toEqual({ 'cup-a2b3': { path: 'assets/2-cup.png', kind: 'image' } });
    expect(Object.values(graphs.main?.nodes ?? {}).map(({ params }) => params)).toEqual([{ file: { value: 'cup-a2b3' } }]);
    const [call] = host.calls.flatMap(({ method, input }) => (method === 'asset.import' ? [input as { bytes: Uint8Array }] : []));
    expect(new TextDecoder().decode(call?.bytes)).toBe('bytes of assets/cup.png');

    await pasteText(editor, copied);
    expect(editor.document.getState().project.assets).toEqual({ 'cup-a2b3': { path: 'assets/cup.png', kind: 'image' } });
    expect(Object.keys(graphOf(editor.document.getState()).nodes)).toHaveLength(2);
  });

  test('of a damaged text add nothing', async () => {
    const { editor } = await openTestEditor();
    const clipping = { format: 'scrim-nodes', version: 1, nodes: {}, wires: [] };
    expect(parseClipping(JSON.stringify({ ...clipping, brought: { project: 3 } }))).toBeNull();
    const broken = parseClipping(JSON.stringify({ ...clipping, brought: { project: '{', layout: '', sources: {} } }));
    if (!broken) throw new Error('Its shape is right.');
    const before = filesOf(editor);
    pasteClipping(editor, broken, 'Paste', { x: 0, y: 0 });
    expect(filesOf(editor)).toEqual(before);
  });
});

test('nodes are found by title, value and id, in all graphs', async () => {
  const { editor, high, blend } = await over();
  selectOnly(editor.selection, [high]);
  createSubgraph(editor);
  const found = (query: string) => findNodes(editor.document.getState(), query).map(({ graph, node }) => [graph, node]);
  expect(found('image')).toEqual([['subgraph', high]]);
  expect(found(blend)).toEqual([['main', blend]]);
  expect(found('no such thing')).toEqual([]);
});
