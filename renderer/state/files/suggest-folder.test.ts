import { expect, test } from '@jest/globals';
import { openTestEditor } from '../../../tests/support/test-editor.ts';
import { freeFolder, suggestFolder } from './suggest-folder.ts';

test('a folder is suggested in the projects folder, named after the title', async () => {
  const { editor } = await openTestEditor();
  editor.document.setState({ projectsDir: '/home/me/Scrim' });
  expect(suggestFolder(editor, 'My effect')).toBe('/home/me/Scrim/my-effect');
  expect(suggestFolder(editor, ' Größe: 2/3 ', '-page')).toBe('/home/me/Scrim/größe-2-3-page');
  expect(suggestFolder(editor, '../..')).toBe('/home/me/Scrim/untitled');
  expect(suggestFolder(editor, 'Very long '.repeat(30), '-page')).toBe(
    '/home/me/Scrim/very-long-very-long-very-long-very-long-very-lon-page',
  );
  editor.document.setState({ projectsDir: 'C:\\Users\\me\\Scrim' });
  expect(suggestFolder(editor, 'A b')).toBe('C:\\Users\\me\\Scrim\\a-b');
  editor.document.setState({ projectsDir: '' });
  expect(suggestFolder(editor, 'A b')).toBe('');
});

test('a folder that is taken gets the next free number', () => {
  expect(freeFolder('/Scrim/my-effect', new Set(['/Scrim/other']))).toBe('/Scrim/my-effect');
  expect(freeFolder('/Scrim/my-effect', new Set(['/Scrim/my-effect', '/Scrim/my-effect-2']))).toBe('/Scrim/my-effect-3');
});
