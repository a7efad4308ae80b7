import { describe, expect, test } from '@jest/globals';
import { openTestEditor } from '../../tests/support/test-editor.ts';
import { selectOnly } from '../state/editor/selection.ts';
import { addNodeFromPalette, connect, toggleMuted } from '../state/graph/edit-graph.ts';
import { moveAll } from '../state/graph/layout-items.ts';
import { editParam } from '../state/params/edit-params.ts';
import { sameForWires, sourcesFor } from './wire-sources.ts';

async function graph() {
  const { editor } = await openTestEditor();
  const add = (type: string) => {
    const definition = editor.document.getState().library.definition(type);
    const id = definition && addNodeFromPalette(editor, { definition, port: null }, { x: 0, y: 0 }, null);
    if (!id) throw new Error(`${type} was not added.`);
    return id;
  };
  return { editor, add, video: add('source/camera-video'), blur: add('filter/gaussian-blur') };
}

describe('what a port can be wired to', () => {
  test('is every output that fits, by node and port, and closes no loop', async () => {
    const { editor, add, video, blur } = await graph();
    const sepia = add('filter/sepia');
    connect(editor, { node: blur, port: 'layer' }, { node: sepia, port: 'inputImage' });
    const sources = sourcesFor(editor.document.getState(), { node: blur, port: 'inputImage' });
    expect(sources).toEqual([{ from: { node: video, port: 'layer' }, label: 'Camera video · Layer' }]);
  });

  test('is the same for as long as values and places alone change', async () => {
    const { editor, add, video, blur } = await graph();
    const state = () => editor.document.getState();
    const keeps = (act: () => void) => {
      const before = state();
      act();
      return [before === state(), sameForWires(before, state())];
    };
    expect(keeps(() => editParam(editor, blur, 'radius', 3))).toEqual([false, true]);
    expect(keeps(() => moveAll(editor, { [blur]: { x: 8, y: 8 } }))).toEqual([false, true]);
    expect(keeps(() => connect(editor, { node: video, port: 'layer' }, { node: blur, port: 'inputImage' }))).toEqual([false, false]);
    expect(keeps(() => void add('filter/sepia'))).toEqual([false, false]);
    selectOnly(editor.selection, [blur]);
    expect(keeps(() => toggleMuted(editor))).toEqual([false, false]);
  });
});
