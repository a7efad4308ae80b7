import { expect, test } from '@jest/globals';
import { openTestEditor } from '../../../tests/support/test-editor.ts';
import { searchPalette } from '../graph/palette-search.ts';
import { findCommands } from './find-commands.ts';

test.each([
  ['theme', 'view.theme'],
  ['filter', 'graph.new-filter'],
  ['duplicate filter', 'graph.duplicate-filter'],
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

test('a word for what an image should look like finds no command, but nodes', async () => {
  const { editor } = await openTestEditor();
  expect(findCommands(editor, 'tint')).toEqual([]);
  const { library } = editor.document.getState();
  const definitions = [...library.types()].flatMap((type) => library.definition(type) ?? []);
  expect(searchPalette(definitions, 'tint', null).map(({ definition }) => definition.type)).toContain('filter/sepia');
});

test('commands that cannot run come last', async () => {
  const { editor } = await openTestEditor();
  const found = findCommands(editor, 'duplicate');
  // Nothing is selected.
  expect(found).toEqual(['file.save-as', 'edit.duplicate', 'edit.duplicate-wired', 'graph.duplicate-filter']);
});
