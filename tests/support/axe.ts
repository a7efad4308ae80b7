import { readFile } from 'node:fs/promises';
import { resolve } from 'node:path';
import type { AxeResults, RunOptions } from 'axe-core';
import type { Page } from 'playwright-core';

const SCRIPT = resolve(import.meta.dirname, '../../node_modules/axe-core/axe.min.js');

/**
 * Findings of axe-core on a page, one line each: rule and elements. Waits for animations, because fading elements have too little
 * contrast. Iframes such as the preview are checked separately.
 */
export async function axeFindings(page: Page): Promise<string[]> {
  const isThere = await page.evaluate(() => 'axe' in window);
  if (!isThere) await page.evaluate(await readFile(SCRIPT, 'utf8'));
  const { violations } = await page.evaluate(async () => {
    const moving = document.getAnimations().filter(({ effect }) => effect?.getComputedTiming().iterations !== Number.POSITIVE_INFINITY);
    await Promise.allSettled(moving.map(({ finished }) => finished));
    const { axe } = window as unknown as { axe: { run: (context: object, options: RunOptions) => Promise<AxeResults> } };
    // What passes would be described, too.
    return axe.run({ exclude: [['iframe']] }, { resultTypes: ['violations'] });
  });
  return violations.map(({ id, nodes }) => `${id}: ${nodes.map(({ target }) => target.join(' ')).join(', ')}`);
}
