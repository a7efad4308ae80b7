import { readFile } from 'node:fs/promises';
import { expect, test } from '@jest/globals';
import { DEFINITIONS } from '../../nodes/generated/definitions.gen.ts';
import { generatedPages } from '../../tools/docs/main.ts';

test.each(Object.entries(generatedPages(DEFINITIONS)))('%s is what `npm run docs` makes', async (path, text) => {
  expect(await readFile(path, 'utf8')).toBe(text);
});
