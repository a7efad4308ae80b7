import type { Page } from 'playwright-core';
import type { Interaction } from './hands.ts';

const ID = 'newcomer-mark';

/** Draws the pointer and a caption over the page, for a screenshot. */
export async function markInteraction(page: Page, { what, at }: Interaction, count: number): Promise<void> {
  await page.evaluate(
    ({ id, text, x, y }) => {
      const mark = document.createElement('div');
      mark.id = id;
      mark.popover = 'manual';
      mark.style.cssText = 'position:fixed;inset:0;width:100%;height:100%;margin:0;padding:0;border:0;background:none;pointer-events:none';
      const dot = document.createElement('div');
      dot.style.cssText = `position:fixed;left:${x - 16}px;top:${y - 16}px;width:32px;height:32px;box-sizing:border-box;border-radius:50%;border:3px solid #c3e277;background:rgb(195 226 119 / 28%)`;
      const line = document.createElement('div');
      line.textContent = text;
      line.style.cssText =
        'position:fixed;left:24px;bottom:48px;padding:10px 18px;border-radius:10px;background:rgb(10 12 14 / 88%);color:#fff;font:600 24px/1.3 sans-serif';
      mark.append(dot, line);
      document.body.append(mark);
      // A popover is above dialogs.
      mark.showPopover();
    },
    { id: ID, text: `${count}  ${what}`, ...at },
  );
}

export async function unmark(page: Page): Promise<void> {
  await page.evaluate((id) => document.getElementById(id)?.remove(), ID);
}
