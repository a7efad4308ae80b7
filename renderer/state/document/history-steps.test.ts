import { expect, test } from '@jest/globals';
import { openTestEditor } from '../../../tests/support/test-editor.ts';
import { isDirty } from '../editor/document.ts';
import { filesOf, revertToSaved, save } from '../files/files.ts';
import { addNodeFromPalette } from '../graph/edit-graph.ts';
import { goToStep, historySteps, savedStep, undo } from './apply.ts';

async function withThreeSteps() {
  const { editor } = await openTestEditor();
  const states = [filesOf(editor)];
  for (const type of ['filter/sepia', 'filter/vignette', 'filter/gaussian-blur']) {
    const definition = editor.document.getState().library.definition(type);
    if (!definition) throw new Error(`There is no ${type}.`);
    addNodeFromPalette(editor, { definition, port: null }, { x: 0, y: 0 }, null);
    states.push(filesOf(editor));
  }
  return { editor, states };
}

test('the history names its steps, and any of them can be shown in one change of the document', async () => {
  const { editor, states } = await withThreeSteps();
  expect(historySteps(editor.document.getState().history).map(({ label }) => label)).toEqual([
    'Add Sepia',
    'Add Vignette',
    'Add Gaussian blur',
  ]);
  let changes = 0;
  editor.document.subscribe(() => changes++);
  for (const count of [0, 3, 1, 2]) {
    goToStep(editor, count);
    expect(filesOf(editor)).toEqual(states[count]);
  }
  expect(changes).toBe(4);
  expect(historySteps(editor.document.getState().history)).toHaveLength(3);
});

test('the saved step is found among undone and redone steps, but not after a change that replaces it', async () => {
  const { editor } = await withThreeSteps();
  expect(savedStep(editor.document.getState())).toBe(0);
  goToStep(editor, 2);
  await save(editor);
  for (const count of [0, 1, 2, 3]) {
    goToStep(editor, count);
    expect(savedStep(editor.document.getState())).toBe(2);
  }
  goToStep(editor, 1);
  const definition = editor.document.getState().library.definition('filter/sepia');
  if (definition) addNodeFromPalette(editor, { definition, port: null }, { x: 0, y: 0 }, null);
  expect(savedStep(editor.document.getState())).toBeNull();
});

test('reverting to the saved version can be redone; where undo does not lead there, it asks', async () => {
  const { editor, states } = await withThreeSteps();
  goToStep(editor, 2);
  await save(editor);
  goToStep(editor, 3);
  revertToSaved(editor);
  expect(filesOf(editor)).toEqual(states[2]);
  expect(isDirty(editor.document.getState())).toBe(false);
  expect(editor.ui.getState().dialog).toBeNull();
  goToStep(editor, 3);
  expect(filesOf(editor)).toEqual(states[3]);

  goToStep(editor, 2);
  undo(editor);
  const definition = editor.document.getState().library.definition('filter/sepia');
  if (definition) addNodeFromPalette(editor, { definition, port: null }, { x: 0, y: 0 }, null);
  revertToSaved(editor);
  expect(editor.ui.getState().dialog).toEqual({ kind: 'revert' });
});
