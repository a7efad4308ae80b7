import { expect, test } from '@jest/globals';
import { type Content, plain } from '../services/content.ts';
import { answer } from './scheme.ts';

/** Answers 200, and says for which origin and path. */
const content: Content = {
  answer: async (origin, _method, path) => ({ ...plain(200, ''), headers: { origin, path } }),
  show: () => () => {},
};

test.each([
  ['scrim://editor/', { origin: 'editor', path: '/' }],
  ['scrim://editor', { origin: 'editor', path: '/' }],
  ['scrim://editor/assets/a.js?x#y', { origin: 'editor', path: '/assets/a.js' }],
  ['scrim://preview/projects/0/a%20b.png', { origin: 'preview', path: '/projects/0/a%20b.png' }],
])('%s is answered', async (url, headers) => {
  expect(await answer(content, 'GET', url)).toMatchObject({ status: 200, headers });
});

test.each([
  ...['scrim://evil/', 'scrim://', 'scrim:///', 'scrim://editor.evil/', 'scrim://evil@editor/', 'scrim://editor:80/', 'other://editor/'],
  ...['scrim://preview2/', 'scrim:editor/', ''],
])('%j names nothing', async (url) => {
  expect((await answer(content, 'GET', url)).status).toBe(404);
});
