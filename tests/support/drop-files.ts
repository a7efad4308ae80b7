import type { Page } from 'playwright-core';
import type { Point } from '../../tools/lib/center-of.ts';
import { eventually } from './patience.ts';

/**
 * Drags files from outside the browser straight to a point of the page, as a file manager does, and drops them there once the page accepts them.
 *
 * @param paths Absolute paths.
 * @param ready Throws until the page is ready for the drop.
 */
export async function dropFiles(
  page: Page,
  paths: readonly string[],
  { x, y }: Point,
  ready: () => Promise<void> = async () => {},
): Promise<void> {
  const client = await page.context().newCDPSession(page);
  const data = { items: [], files: [...paths], dragOperationsMask: 1 };
  const send = (type: 'dragEnter' | 'dragOver' | 'drop', atX = x) => client.send('Input.dispatchDragEvent', { type, x: atX, y, data });
  try {
    await send('dragEnter');
    // The operating system repeats the event, and so must the test.
    await eventually(async () => {
      await send('dragOver', x - 1);
      await send('dragOver');
      await ready();
    });
    await send('drop');
  } finally {
    await client.detach();
  }
}
