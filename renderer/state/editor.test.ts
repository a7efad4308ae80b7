import { describe, expect, test } from '@jest/globals';
import { openTestEditor } from '../../tests/support/test-editor.ts';
import { clipSelection, duplicateSelection, parseClipping, pasteClipping } from './clipboard/clipboard.ts';
import { endGesture, redo, undo } from './document/apply.ts';
import type { DraggedWire } from './editor/canvas-state.ts';
import { graphOf, isDirty, layoutOf } from './editor/document.ts';
import type { Editor } from './editor/editor.ts';
import { selectOnly } from './editor/selection.ts';
import { filesOf, save } from './files/files.ts';
import { addNodeFromPalette, connect, deleteSelection, refusalOf, rewire, toggleMuted } from './graph/edit-graph.ts';
import { moveAll } from './graph/layout-items.ts';
import { editParam, resetParam, setExposed } from './params/edit-params.ts';

function add(editor: Editor, type: string, draggedWire: DraggedWire | null = null, port: string | null = null): string {
  const definition = editor.document.getState().library.definition(type);
  if (!definition) throw new Error(`There is no ${type}.`);
  const id = addNodeFromPalette(editor, { definition, port }, { x: 8, y: 16 }, draggedWire);
  if (id === null) throw new Error(`${type} was not added.`);
  return id;
}

describe('the editor', () => {
  test('adds a node where it was asked for, selects it, and takes it back in one step', async () => {
    const { editor } = await openTestEditor();
    const before = filesOf(editor);
    const id = add(editor, 'filter/sepia');
    expect(layoutOf(editor.document.getState()).nodes[id]).toEqual({ x: 8, y: 16 });
    expect([...editor.selection.getState().nodes]).toEqual([id]);
    undo(editor);
    expect(filesOf(editor)).toEqual(before);
    expect(editor.selection.getState().nodes.size).toBe(0);
    redo(editor);
    expect(graphOf(editor.document.getState()).nodes[id]?.type).toBe('filter/sepia');
  });

  test('a wire dropped on the canvas is connected to the node chosen for it, in the same step', async () => {
    const { editor } = await openTestEditor();
    const sepia = add(editor, 'filter/sepia');
    const draggedWire: DraggedWire = { node: sepia, port: 'layer', side: 'output', type: 'layer' };
    const blur = add(editor, 'filter/gaussian-blur', draggedWire, 'inputImage');
    expect(graphOf(editor.document.getState()).wires).toEqual([
      { from: { node: sepia, port: 'layer' }, to: { node: blur, port: 'inputImage' } },
    ]);
    undo(editor);
    expect(Object.keys(graphOf(editor.document.getState()).nodes)).toEqual([sepia]);
  });

  test('refuses wires with a reason, and shows it', async () => {
    const { editor } = await openTestEditor();
    const math = add(editor, 'value/math');
    const sepia = add(editor, 'filter/sepia');
    const output = { node: math, port: 'result', side: 'output' } as const;
    const input = { node: sepia, port: 'inputImage', side: 'input' } as const;
    expect(refusalOf(editor, output, input)?.code).toBe('SCR013');
    expect(refusalOf(editor, output, { ...output, node: sepia, port: 'layer' })?.message).toContain('Both ports are outputs');
    expect(connect(editor, { node: math, port: 'result' }, { node: sepia, port: 'inputImage' })).toBe(false);
    expect(editor.ui.getState().toasts.map(({ tone }) => tone)).toEqual(['error']);
    expect(graphOf(editor.document.getState()).wires).toEqual([]);
  });

  test('moving a wire is one step', async () => {
    const { editor } = await openTestEditor();
    const a = add(editor, 'filter/sepia');
    const b = add(editor, 'filter/sepia');
    const blur = add(editor, 'filter/gaussian-blur');
    connect(editor, { node: a, port: 'layer' }, { node: blur, port: 'inputImage' });
    const steps = editor.document.getState().history.past.length;
    rewire(editor, `${a}.layer -> ${blur}.inputImage`, { node: b, port: 'layer' }, { node: blur, port: 'inputImage' });
    expect(graphOf(editor.document.getState()).wires.map(({ from }) => from.node)).toEqual([b]);
    expect(editor.document.getState().history.past.length).toBe(steps + 1);
  });

  test('the values of one gesture are one step, and the next gesture is another', async () => {
    const { editor } = await openTestEditor();
    const blur = add(editor, 'filter/gaussian-blur');
    for (const radius of [9, 10, 11]) editParam(editor, blur, 'radius', radius);
    endGesture(editor);
    editParam(editor, blur, 'radius', 20);
    undo(editor);
    expect(graphOf(editor.document.getState()).nodes[blur]?.params.radius).toEqual({ value: 11 });
    undo(editor);
    expect(graphOf(editor.document.getState()).nodes[blur]?.params.radius).toBeUndefined();
  });

  test('arrow keys that move the same nodes are one step', async () => {
    const { editor } = await openTestEditor();
    const sepia = add(editor, 'filter/sepia');
    const steps = editor.document.getState().history.past.length;
    for (const x of [16, 24, 32]) moveAll(editor, { [sepia]: { x, y: 16 } });
    expect(editor.document.getState().history.past.length).toBe(steps + 1);
  });

  test('reset takes away value, port and wire', async () => {
    const { editor } = await openTestEditor();
    const math = add(editor, 'value/math');
    const blur = add(editor, 'filter/gaussian-blur');
    editParam(editor, blur, 'radius', 20);
    setExposed(editor, blur, 'radius', true);
    connect(editor, { node: math, port: 'result' }, { node: blur, port: 'radius' });
    resetParam(editor, blur, 'radius');
    const graph = graphOf(editor.document.getState());
    expect(graph.nodes[blur]?.params).toEqual({});
    expect(graph.wires).toEqual([]);
  });

  test('copies keep values and the wires among them, under new ids', async () => {
    const { editor } = await openTestEditor();
    const sepia = add(editor, 'filter/sepia');
    const blur = add(editor, 'filter/gaussian-blur');
    connect(editor, { node: sepia, port: 'layer' }, { node: blur, port: 'inputImage' });
    editParam(editor, blur, 'radius', 3);
    selectOnly(editor.selection, [sepia, blur]);
    duplicateSelection(editor);
    const graph = graphOf(editor.document.getState());
    expect(Object.keys(graph.nodes)).toHaveLength(4);
    expect(graph.wires).toHaveLength(2);
    const copy = [...editor.selection.getState().nodes].find((id) => graph.nodes[id]?.type === 'filter/gaussian-blur') ?? '';
    expect(graph.nodes[copy]?.params.radius).toEqual({ value: 3 });
    expect(copy).not.toBe(blur);
  });

  test('a clipping goes through text into another editor; other text is no clipping', async () => {
    const { editor } = await openTestEditor();
    selectOnly(editor.selection, [add(editor, 'filter/sepia')]);
    const text = JSON.stringify(clipSelection(editor));
    const other = (await openTestEditor()).editor;
    const clipping = parseClipping(text);
    expect(clipping && pasteClipping(other, clipping, 'Paste', { x: 0, y: 0 })).toBe(true);
    expect(Object.values(graphOf(other.document.getState()).nodes).map(({ type }) => type)).toEqual(['filter/sepia']);
    for (const none of ['', 'hello', '[]', '{"format":"scrim-nodes"}', 'null']) expect(parseClipping(none)).toBeNull();
  });

  test('a project that has a screen takes copies without another, and says so', async () => {
    const { editor } = await openTestEditor();
    const ids = [add(editor, 'filter/sepia'), add(editor, 'output/screen')];
    selectOnly(editor.selection, ids);
    const types = () =>
      Object.values(graphOf(editor.document.getState()).nodes)
        .map(({ type }) => type)
        .sort();
    const clipping = clipSelection(editor);
    duplicateSelection(editor);
    expect(types()).toEqual(['filter/sepia', 'filter/sepia', 'output/screen']);
    expect(editor.ui.getState().toasts.at(-1)?.text).toContain('The Output was not pasted');
    selectOnly(editor.selection, ids.slice(1));
    expect(duplicateSelection(editor)).toBe(false);
    expect(types()).toHaveLength(3);

    // Where there is none, it comes along.
    const other = (await openTestEditor()).editor;
    if (clipping) pasteClipping(other, clipping, 'Paste', { x: 0, y: 0 });
    expect(Object.values(graphOf(other.document.getState()).nodes)).toHaveLength(2);
  });

  test('mute, delete and their way back', async () => {
    const { editor } = await openTestEditor();
    const sepia = add(editor, 'filter/sepia');
    toggleMuted(editor);
    expect(graphOf(editor.document.getState()).nodes[sepia]?.muted).toBe(true);
    toggleMuted(editor);
    expect(graphOf(editor.document.getState()).nodes[sepia]?.muted).toBeUndefined();
    const before = graphOf(editor.document.getState());
    expect(before.nodes[sepia]).toMatchObject({ type: 'filter/sepia' });
    deleteSelection(editor);
    expect(graphOf(editor.document.getState()).nodes[sepia]).toBeUndefined();
    undo(editor);
    expect(graphOf(editor.document.getState())).toEqual(before);
  });

  test('knows what is unsaved, through saving and undoing', async () => {
    const { editor } = await openTestEditor();
    expect(isDirty(editor.document.getState())).toBe(false);
    add(editor, 'filter/sepia');
    expect(isDirty(editor.document.getState())).toBe(true);
    await save(editor);
    expect(isDirty(editor.document.getState())).toBe(false);
    undo(editor);
    expect(isDirty(editor.document.getState())).toBe(true);
    redo(editor);
    expect(isDirty(editor.document.getState())).toBe(false);
  });
});
