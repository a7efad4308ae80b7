import { expect, test } from '@jest/globals';
import { openTestEditor } from '../../../tests/support/test-editor.ts';
import { isDirty } from '../editor/document.ts';
import { filesOf, save } from '../files/files.ts';
import { revertToSaved } from '../files/revert.ts';
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

test('reverting to the saved version is one step, which undo takes back, also where undo does not lead to that version', async () => {
  const { editor, states } = await withThreeSteps();
  goToStep(editor, 2);
  await save(editor);
  goToStep(editor, 3);
  await revertToSaved(editor);
  expect(filesOf(editor)).toEqual(states[2]);
  expect(isDirty(editor.document.getState())).toBe(false);
  expect(historySteps(editor.document.getState().history).at(-1)?.label).toBe('Revert to saved');
  undo(editor);
  expect(filesOf(editor)).toEqual(states[3]);
  expect(isDirty(editor.document.getState())).toBe(true);
  // The step that was saved is still known, also once the step of the revert is gone.
  goToStep(editor, 2);
  expect(isDirty(editor.document.getState())).toBe(false);
  goToStep(editor, 3);

  await save(editor);
  undo(editor);
  const definition = editor.document.getState().library.definition('filter/sepia');
  if (definition) addNodeFromPalette(editor, { definition, port: null }, { x: 0, y: 0 }, null);
  const mine = filesOf(editor);
  expect(savedStep(editor.document.getState())).toBeNull();
  await revertToSaved(editor);
  expect(filesOf(editor)).toEqual(states[3]);
  expect(isDirty(editor.document.getState())).toBe(false);
  undo(editor);
  expect(filesOf(editor)).toEqual(mine);
});
