import { expect } from '@jest/globals';
import type { Page } from 'playwright-core';

export const TOUR_STEPS = 5;

/** Steps through the tour by Enter, and calls `atStep` at each card. */
export async function takeTour(page: Page, atStep: (step: number) => Promise<void>): Promise<void> {
  const card = page.locator('.tour-card');
  const titles = new Set<string>();
  for (let step = 1; step <= TOUR_STEPS; step++) {
    await card.getByText(`${step} of ${TOUR_STEPS}`).waitFor();
    titles.add((await card.getByRole('heading').textContent()) ?? '');
    const frame = await page.locator('.tour-frame').boundingBox();
    expect((frame?.width ?? 0) * (frame?.height ?? 0)).toBeGreaterThan(1000);
    await atStep(step);
    await page.keyboard.press('Enter');
  }
  expect(titles.size).toBe(TOUR_STEPS);
  await card.waitFor({ state: 'detached' });
}
