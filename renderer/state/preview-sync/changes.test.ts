import { describe, expect, test } from '@jest/globals';
import { setTitle } from '../../../export/graph/commands/project-info.ts';
import { openTestEditor } from '../../../tests/support/test-editor.ts';
import { apply, undo } from '../document/apply.ts';
import type { Editor } from '../editor/editor.ts';
import { addNodeFromPalette, toggleMuted } from '../graph/edit-graph.ts';
import { moveAll } from '../graph/layout-items.ts';
import { editParam, setExposed } from '../params/edit-params.ts';
import { consequenceOf } from './changes.ts';

async function withNode(type: string): Promise<{ editor: Editor; id: string }> {
  const { editor } = await openTestEditor();
  const definition = editor.document.getState().library.definition(type);
  const id = definition && addNodeFromPalette(editor, { definition, port: null }, { x: 0, y: 0 }, null);
  if (!id) throw new Error(`${type} was not added.`);
  return { editor, id };
}

function consequence(editor: Editor, act: () => unknown) {
  const before = editor.document.getState().project;
  act();
  const { project, library } = editor.document.getState();
  return consequenceOf(before, project, library);
}

describe('what follows from a change', () => {
  test('a value that may be set while running goes to the preview alone, and so does its undo', async () => {
    const { editor, id } = await withNode('filter/gaussian-blur');
    expect(consequence(editor, () => editParam(editor, id, 'radius', 12))).toEqual({
      kind: 'params',
      edits: [{ graph: 'main', node: id, param: 'radius', value: 12 }],
    });
    const back = consequence(editor, () => undo(editor));
    const byDefault = editor.document.getState().library.definition('filter/gaussian-blur')?.params.radius?.default;
    expect(back).toEqual({ kind: 'params', edits: [{ graph: 'main', node: id, param: 'radius', value: byDefault }] });
  });

  test.each([
    ['curve', 'filter/curves', 'all', [0, 0.1, 0.5, 0.75, 1, 1]],
    ['gradient', 'filter/gradient-map', 'gradient', [0, 1, 0, 0, 1, 2, 1, 0, 0, 1, 1, 0]],
  ])('so does a %s', async (_, type, param, value) => {
    const { editor, id } = await withNode(type);
    const edits = [{ graph: 'main', node: id, param, value }];
    expect(consequence(editor, () => editParam(editor, id, param, value))).toEqual({ kind: 'params', edits });
  });

  test('moving changes nothing that plays', async () => {
    const { editor, id } = await withNode('filter/sepia');
    expect(consequence(editor, () => moveAll(editor, { [id]: { x: 80, y: 80 } }))).toEqual({ kind: 'nothing' });
  });

  test.each([
    ['a structure param', (editor: Editor, id: string) => editParam(editor, id, 'operation', 'multiply')],
    ['muting', (editor: Editor) => toggleMuted(editor)],
    ['undoing the node', (editor: Editor) => undo(editor)],
    ['the title', (editor: Editor) => apply(editor, '', setTitle(editor.document.getState().project, { title: 'X' }))],
  ])('%s asks for another program', async (_what, act) => {
    const { editor, id } = await withNode('value/math');
    expect(consequence(editor, () => act(editor, id)).kind).toBe('program');
  });

  test('showing a param as a port holds its value and only sets params', async () => {
    const { editor, id } = await withNode('filter/gaussian-blur');
    expect(consequence(editor, () => setExposed(editor, id, 'radius', true)).kind).toBe('params');
  });
});
