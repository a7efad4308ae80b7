import { readFile } from 'node:fs/promises';
import { resolve } from 'node:path';
import type { AxeResults } from 'axe-core';
import type { Page } from 'playwright-core';

const SCRIPT = resolve(import.meta.dirname, '../../node_modules/axe-core/axe.min.js');

/**
 * What axe-core finds wrong with a page as it is, one line each: rule and places. Frames, such as the editor's preview, are pages of
 * their own. What fades in has too little contrast until it is there: what moves is waited for.
 */
export async function axeFindings(page: Page): Promise<string[]> {
  await page.evaluate(await readFile(SCRIPT, 'utf8'));
  const { violations } = await page.evaluate(async () => {
    const moving = document.getAnimations().filter(({ effect }) => effect?.getComputedTiming().iterations !== Number.POSITIVE_INFINITY);
    await Promise.allSettled(moving.map(({ finished }) => finished));
    const { axe } = window as unknown as { axe: { run: (context: object) => Promise<AxeResults> } };
    return axe.run({ exclude: [['iframe']] });
  });
  return violations.map(({ id, nodes }) => `${id}: ${nodes.map(({ target }) => target.join(' ')).join(', ')}`);
}
