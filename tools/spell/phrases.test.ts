import { expect, test } from '@jest/globals';
import { checkPhrases } from './main.ts';
import { BANNED_PHRASES, findPhrases } from './phrases.ts';

test('a phrase is found across the lines of a comment', () => {
  expect(findPhrases('a.ts', '/**\n * The texture is to\n * be had.\n */')).toEqual(['a.ts:2: “is to be had”: write is available.']);
  expect(findPhrases('a.ts', '// The texture is available.')).toEqual([]);
});

test('the list stays short, and holds phrases rather than words', () => {
  expect(BANNED_PHRASES.length).toBeLessThanOrEqual(60);
});

test('code, comments and docs hold none of the phrases', async () => {
  expect(await checkPhrases('.')).toEqual([]);
});
