import { expect, test } from '@jest/globals';
import { openTestEditor } from '../../../tests/support/test-editor.ts';
import { findCommands } from './find-commands.ts';

test.each([
  ['theme', 'view.theme'],
  ['tint', 'view.theme'],
  ['filter', 'graph.new-filter'],
  ['effect', 'graph.add'],
  ['effect', 'graph.add'],
  ['publish', 'file.export'],
  ['video', 'file.render'],
  ['load', 'file.open'],
  ['duplicate project', 'file.save-as'],
  ['error', 'view.problems'],
  ['keyframes', 'view.timeline'],
  ['depth', 'view.probe'],
  ['clean up', 'arrange.tidy'],
  ['hotkeys', 'help.shortcuts'],
  ['tutorial', 'help.tour'],
])('“%s” finds the command %s first', async (query, id) => {
  const { editor } = await openTestEditor();
  expect(findCommands(editor, query)[0]).toBe(id);
});

test('commands that cannot run come last', async () => {
  const { editor } = await openTestEditor();
  const found = findCommands(editor, 'duplicate');
  // Nothing is selected.
  expect(found).toEqual(['file.save-as', 'edit.duplicate', expect.any(String)]);
});
