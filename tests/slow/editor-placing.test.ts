import { expect, test } from '@jest/globals';
import { frameOf } from '../../tools/lib/frame-of.ts';
import { useOneEditor } from '../support/open-editor.ts';
import { eventually } from '../support/patience.ts';
import { ballMiddle, ballPixels, PLACED_BALL } from '../support/placed-ball.ts';

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
  // The ball was not there when the tap began, so the tap did not select it.
  expect(await open.editor.inspector.getByRole('heading', { name: 'Project', exact: true }).isVisible()).toBe(true);
});

test('two fingers on the preview scale it', async () => {
  await open.editor.hold();
  const before = await ballPixels(open.editor);
  const preview = await frameOf(open.page);
  const box = await open.page.locator('iframe[title="Preview"]').boundingBox();
  if (!box) throw new Error('There is no preview.');
  const [xPx, yPx] = await ballMiddle(open.editor);
  // Touches reach a frame in a process of its own only by its session, at points of the page.
  const client = await open.page.context().newCDPSession(preview);
  const touch = (type: 'touchStart' | 'touchMove', halfPx: number) =>
    client.send('Input.dispatchTouchEvent', {
      type,
      touchPoints: [-halfPx, halfPx].map((dx, id) => ({ x: box.x + xPx + dx, y: box.y + yPx, id })),
    });
  await touch('touchStart', 6);
  // The preview reads fingers once per frame: one must see where they begin.
  await open.editor.restingImage();
  // The browser itself would zoom from here on.
  for (const halfPx of [9, 12, 18, 24]) await touch('touchMove', halfPx);
  await eventually(async () => expect(await ballPixels(open.editor)).toBeGreaterThan(2 * before));
  await client.send('Input.dispatchTouchEvent', { type: 'touchEnd', touchPoints: [] });
  await client.detach();
});
