import type { Page } from 'playwright-core';

/**
 * Page code, installed before its scripts: delays the long press of fingers and pens until the test releases it, so that a busy
 * machine triggers none.
 */
export function holdRests(): void {
  const { setTimeout: start, clearTimeout: stop } = window;
  const held = new Map<number, () => void>();
  let next = -1;
  const after = (run: () => void, ms?: number) => {
    if (ms !== 500) return start(run, ms);
    held.set(next, run);
    return next--;
  };
  const forget = (timer?: number) => void (held.delete(timer ?? 0) || stop(timer));
  const rest = () => {
    for (const run of held.values()) run();
    held.clear();
  };
  Object.assign(window, { setTimeout: after, clearTimeout: forget, rest });
}

/** Simulates that the pressed fingers and pens have rested for half a second. */
export async function rest(page: Page): Promise<void> {
  await page.evaluate(() => (window as unknown as { rest: () => void }).rest());
}
