import { readFile } from 'node:fs/promises';
import { resolve } from 'node:path';
import { expect, test } from '@jest/globals';
import { makePinwheel } from './pinwheel.ts';

test('the pinwheel of the Model node is the one that is made here', async () => {
  const kept = await readFile(resolve(import.meta.dirname, '../../nodes/source/model/example/assets/pinwheel.glb'));
  expect(Buffer.compare(await makePinwheel(), kept)).toBe(0);
});
