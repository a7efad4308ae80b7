import { expect, test } from '@jest/globals';
import { openTestEditor } from '../../../tests/support/test-editor.ts';
import { startFilter } from '../graph/first-steps.ts';
import { runCommand } from './app-commands.ts';
import { tickOf } from './command-ticks.ts';
import { findCommands, findNodes } from './find-commands.ts';

test.each([
  ['theme', 'view.theme'],
  ['filter', 'graph.new-filter'],
  ['duplicate filter', 'graph.duplicate-filter'],
  ['effect', 'graph.add'],
  ['dark', 'view.theme'],
  ['color', 'view.probe'],
  ['zoom', 'view.fit'],
  ['fit', 'view.fit'],
  ['phone', 'preview.phone'],
  ['headset', 'preview.headset'],
  ['device', 'preview.fill'],
  ['dock', 'view.dock-right'],
  ['fullscreen', 'view.preview-full'],
  ['pop-out', 'view.pop-out'],
  ['photograph', 'file.photograph'],
  ['wheel', 'view.wheel'],
  ['settings', 'view.thumbnails'],
  ['resolution', 'preview.render-size'],
  ['poster', 'preview.keep-image'],
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

test('a word for what an image should look like finds no command, but nodes that do it', async () => {
  const { editor } = await openTestEditor();
  expect(findCommands(editor, 'tint')).toEqual([]);
  const types = (query: string) => findNodes(editor, query).map(({ definition }) => definition.type);
  expect(types('tint')).toEqual(expect.arrayContaining(['filter/gradient-map', 'filter/sepia']));
  expect(types('cartoon')[0]).toBe('technique/toon');
  expect(types('')).toEqual([]);
});

test('“undo” finds Undo first once there is something to undo', async () => {
  const { editor } = await openTestEditor();
  startFilter(editor, { x: 0, y: 0 });
  expect(findCommands(editor, 'undo')[0]).toBe('edit.undo');
});

test.each([
  ['preview.phone', 'phone', 1],
  ['preview.headset', 'headset', 2],
  ['preview.fill', 'fill', 1],
] as const)('%s puts the preview into the frame %s', async (id, frame, views) => {
  const { editor } = await openTestEditor();
  runCommand(editor, id);
  expect(editor.preview.getState()).toMatchObject({ frame, views });
  expect(tickOf(editor, id)).toEqual({ on: true, radio: true });
});

test('commands that cannot run come last', async () => {
  const { editor } = await openTestEditor();
  const found = findCommands(editor, 'duplicate');
  // Nothing is selected.
  expect(found).toEqual(['file.save-as', 'edit.duplicate', 'edit.duplicate-wired', 'graph.duplicate-filter']);
});
