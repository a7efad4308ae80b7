import { expect, test } from '@jest/globals';
import { joinPath, splitPath } from './folder-path.ts';

test.each([
  ['/home/me/Scrim/effect', '/home/me/Scrim', 'effect'],
  ['/effect', '/', 'effect'],
  ['C:\\Users\\me\\effect', 'C:\\Users\\me', 'effect'],
  ['C:\\effect', 'C:\\', 'effect'],
])('%s is split and joined again', (path, folder, name) => {
  expect(splitPath(path)).toEqual([folder, name]);
  expect(joinPath(folder, name)).toBe(path);
});

test('a name alone has no folder', () => {
  expect(splitPath('effect')[1]).toBe('');
  expect(splitPath('')).toEqual(['', '']);
});
