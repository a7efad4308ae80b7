import { expect, test } from '@jest/globals';
import { openTestEditor } from '../../tests/support/test-editor.ts';
import { openPath } from './files/files.ts';
import { keepOpenPath, openFirst } from './start.ts';

function memory(): Pick<Storage, 'getItem' | 'setItem'> {
  const texts = new Map<string, string>();
  return { getItem: (key) => texts.get(key) ?? null, setItem: (key, text) => void texts.set(key, text) };
}

test('a reload opens the project that was open, not the one of the command line', async () => {
  const storage = memory();
  const { editor } = await openTestEditor();
  keepOpenPath(editor, storage);
  await openPath(editor, '/chosen in the dialog');

  const reloaded = await openTestEditor();
  await openFirst(reloaded.editor, storage);
  expect(reloaded.editor.document.getState().open?.displayPath).toBe('/chosen in the dialog');
});

test('the first start opens the project of the command line', async () => {
  const { editor } = await openTestEditor();
  await openPath(editor, '/other');
  await openFirst(editor, memory());
  expect(editor.document.getState().open?.displayPath).toBe('/project');
});

test('a project that is gone at the reload leads to the start screen, which says so', async () => {
  const storage = memory();
  const { editor, host } = await openTestEditor();
  keepOpenPath(editor, storage);
  await openPath(editor, '/removed');
  host.refuse('project.open', 'SCR004', '/removed does not exist.');
  await openFirst(editor, storage);
  expect(editor.ui.getState().dialog).toEqual({ kind: 'open' });
  expect(editor.ui.getState().dialogErrors.map(({ text }) => text)).toEqual(['/removed does not exist.']);
});
