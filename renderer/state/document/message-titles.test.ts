import { describe, expect, test } from '@jest/globals';
import { openTestEditor } from '../../../tests/support/test-editor.ts';
import type { Editor } from '../editor/editor.ts';
import { explainRefusal } from '../graph/connect-ports.ts';
import { addNodeFromPalette, connect, refusalOf } from '../graph/edit-graph.ts';
import { editParam } from '../params/edit-params.ts';
import { withTitles } from './message-titles.ts';

function add(editor: Editor, type: string): string {
  const definition = editor.document.getState().library.definition(type);
  const id = definition ? addNodeFromPalette(editor, { definition, port: null }, { x: 0, y: 0 }, null) : null;
  if (id === null) throw new Error(`${type} was not added.`);
  return id;
}

describe('messages call nodes and ports as the canvas does', () => {
  test('where a wire is refused, beside the pointer and in the toast', async () => {
    const { editor } = await openTestEditor();
    const math = add(editor, 'value/math');
    const blur = add(editor, 'filter/gaussian-blur');
    const from = { node: math, port: 'result', side: 'output' } as const;
    const to = { node: blur, port: 'inputImage', side: 'input' } as const;
    expect(refusalOf(editor, from, to)?.message).toBe('Math outputs “Number”, but Gaussian blur takes “Layer”.');
    explainRefusal(editor, from, { nodeId: blur, id: 'inputImage', type: 'target' });
    connect(editor, from, to);
    expect(editor.ui.getState().toasts.map(({ text }) => text)).toEqual(['Math outputs “Number”, but Gaussian blur takes “Layer”.']);
  });

  test('where a wire would close a loop', async () => {
    const { editor } = await openTestEditor();
    const sepia = add(editor, 'filter/sepia');
    const blur = add(editor, 'filter/gaussian-blur');
    connect(editor, { node: sepia, port: 'layer' }, { node: blur, port: 'inputImage' });
    connect(editor, { node: blur, port: 'layer' }, { node: sepia, port: 'inputImage' });
    expect(editor.ui.getState().toasts[0]?.text).toContain('Gaussian blur → Sepia → Gaussian blur');
  });

  test('where a value is out of range', async () => {
    const { editor } = await openTestEditor();
    editParam(editor, add(editor, 'filter/gaussian-blur'), 'radius', 1e6);
    expect(editor.ui.getState().toasts[0]?.text).toMatch(/^“Radius” of Gaussian blur must be /);
  });

  test('and subgraphs by their names', async () => {
    const { editor } = await openTestEditor();
    const said = withTitles(editor.document.getState(), 'Wire it (in the subgraph “soft-look”).');
    expect(said).toBe('Wire it (in the subgraph “Soft look”).');
  });

  test('and leave names of files alone', async () => {
    const { editor } = await openTestEditor();
    const id = add(editor, 'filter/sepia');
    const text = `The file shaders/${id}.fs.`;
    expect(withTitles(editor.document.getState(), text)).toBe(text);
  });

  test('and leave words without a node alone', async () => {
    const { editor } = await openTestEditor();
    const text = 'A view-aligned layer, half-float.rgba, of soft-look-99.x/y.';
    expect(withTitles(editor.document.getState(), text)).toBe(text);
  });
});
