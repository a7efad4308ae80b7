import { writeFile } from 'node:fs/promises';
import { afterAll, beforeAll, expect, test } from '@jest/globals';
import { openModule, type PageModule, useBrowser } from '../support/browser.ts';
import type { WindowRun } from './capture-window.page.ts';

const chromium = useBrowser();
let page: PageModule;
beforeAll(async () => {
  page = await openModule(chromium.browser, 'tests/browser/capture-window.page.ts');
});
afterAll(() => page.close());

const FRAMES = 7;

test.each([2, 3])(
  'weights within some frames, %i photographs per vertex, give the exact image after as many still frames',
  async (blended) => {
    const run = await page.call<WindowRun>('run', 5000, 24, FRAMES, blended);
    if (process.env.SCRIM_PICTURES)
      await writeFile(`${process.env.SCRIM_PICTURES}/window-${blended}.png`, Buffer.from(run.shown.slice(22), 'base64'));
    const { frames, vertexCount, psnrDb } = run;
    if (process.env.SCRIM_PICTURES) console.log(frames, psnrDb);
    // A part in each frame, so the first image after the move is not exact.
    expect(frames[0]?.isExact).toBe(false);
    expect(frames[0]?.updated).toBeLessThan(0.5 * vertexCount);
    expect(frames.slice(0, FRAMES).reduce((sum, { updated }) => sum + updated, 0)).toBe(vertexCount);
    expect(frames.slice(FRAMES - 1).map(({ isExact }) => isExact)).toEqual([true, true, true, true]);
    // A still eye costs nothing.
    expect(frames.slice(FRAMES).map(({ updated }) => updated)).toEqual([0, 0, 0]);
    expect(run.lastFeedbacks).toBe(0);
    // Each eye of a headset keeps its own weights.
    expect(run.viewsAreExact).toEqual([true, true]);
    // Weights between vertices are close to those of pixels.
    expect(psnrDb).toBeGreaterThan(25);
    expect({ leaks: run.leaks, error: run.error, pageErrors: page.errors }).toEqual({ leaks: [], error: 0, pageErrors: [] });
  },
);
