import { expect, test } from '@jest/globals';
import { frameOf } from '../../tools/lib/frame-of.ts';
import { useEditor } from '../support/open-editor.ts';
import { TINTED } from '../support/tinted.ts';
import { type FramesSeen, watchFrames } from './watch-frames.ts';

const TIMES = 50;

const openEditor = useEditor();

test(`a shader broken and fixed ${TIMES} times by typing shows no black frame, loses no context and leaves no GL object behind`, async () => {
  const { page, editor } = await openEditor(TINTED, { before: watchFrames });
  await editor.settled();
  await editor.openCode('tint-aaaa');
  const preview = await frameOf(page);
  const seen = () => preview.evaluate(() => ({ ...(globalThis as unknown as { framesSeen: FramesSeen }).framesSeen }));
  const mark = page.locator('.monaco-editor .squiggly-error').first();
  await editor.findInText('0), pixel.a)');
  // Fixed with one more digit, so that it is linked each time and not found in the cache.
  const breakAndMend = async (digit: number) => {
    await editor.type('q');
    await mark.waitFor();
    await page.keyboard.press('Backspace');
    await editor.type(String(digit));
    await mark.waitFor({ state: 'detached' });
    await page.locator('.status-bar').getByText('No problems').waitFor();
  };
  // Once for what is made only once.
  await breakAndMend(1);
  const before = await seen();
  for (let i = 0; i < TIMES; i++) await breakAndMend(i % 10);
  const after = await seen();
  expect(after.frames).toBeGreaterThan(before.frames + TIMES);
  expect([after.black - before.black, after.lostContexts]).toEqual([0, 0]);
  // The newest program may not have taken the place of the one before yet: two shaders and their program.
  expect(after.alive - before.alive).toBeLessThanOrEqual(3);
});
