import { expect, test } from '@jest/globals';
import { openTestEditor } from '../../../tests/support/test-editor.ts';
import { endGesture, undo } from '../document/apply.ts';
import type { Editor } from '../editor/editor.ts';
import { addNodeFromPalette, connect } from '../graph/edit-graph.ts';
import { editParam } from './edit-params.ts';
import { projectColors } from './project-colors.ts';

function add(editor: Editor, type: string): string {
  const definition = editor.document.getState().library.definition(type);
  const id = definition && addNodeFromPalette(editor, { definition, port: null }, { x: 0, y: 0 }, null);
  if (!id) throw new Error(`${type} was not added.`);
  return id;
}

test('the colors of a project are those that were set, the most used first', async () => {
  const { editor } = await openTestEditor();
  const lights = ['first', 'second', 'third'].map(() => add(editor, 'light/directional'));
  const colors = (most: number) => {
    const { project, library } = editor.document.getState();
    return projectColors(project, library, most);
  };
  const before = colors(8);
  const set = (index: number, color: readonly number[]) => {
    editParam(editor, lights[index] ?? '', 'color', [...color]);
    endGesture(editor);
  };
  set(0, [1, 0.5, 0, 1]);
  set(1, [0, 0, 1, 1]);
  set(2, [0, 0, 1, 0.5]);
  expect(colors(8).filter((color) => !before.includes(color))).toEqual(['#0000ff', '#ff8000']);
  expect(colors(1)).toEqual(['#0000ff']);
  // A wire replaces the color of the first light until it is removed.
  const green = add(editor, 'value/color');
  editParam(editor, green, 'value', [0, 1, 0, 1]);
  endGesture(editor);
  expect(connect(editor, { node: green, port: 'color' }, { node: lights[0] ?? '', port: 'color' })).toBe(true);
  expect(colors(8).filter((color) => !before.includes(color))).toEqual(['#0000ff', '#00ff00']);
  undo(editor);
  expect(colors(8)).toContain('#ff8000');
});
