import { expect, test } from '@jest/globals';
import { useOneEditor } from '../support/open-editor.ts';
import { eventually } from '../support/patience.ts';
import { ballPixels, PLACED_BALL } from '../support/placed-ball.ts';

const open = useOneEditor(PLACED_BALL, {});

test('what a tap places in the preview stays while the recorded room repeats', async () => {
  const box = await open.page.locator('.stage-frame').boundingBox();
  if (!box) throw new Error('There is no preview.');
  await open.editor.settled();
  expect(await ballPixels(open.editor)).toBe(0);
  await open.page.mouse.move(box.x + box.width * 0.4, box.y + box.height * 0.85);
  await open.page.mouse.down();
  await eventually(async () => expect(await open.editor.frame()).toBeGreaterThan(1));
  await open.page.mouse.up();
  await eventually(async () => expect(await ballPixels(open.editor)).toBeGreaterThan(50));
  const placedAt = await open.editor.frame();
  await eventually(async () => expect(await open.editor.frame()).toBeGreaterThan(placedAt + 100));
  expect(await ballPixels(open.editor)).toBeGreaterThan(50);
});
