import { join, resolve } from 'node:path';
import { expect, test } from '@jest/globals';
import { collectErrors } from '../support/browser.ts';
import { describeElectron, editorWindow, findElectron, playedTwiceAfterFault } from '../support/electron.ts';
import { TOUR_STEPS, takeTour } from '../support/tour.ts';

const ROOT = resolve(import.meta.dirname, '../..');

describeElectron('the tour in Electron', await findElectron(), (launch) => {
  test('leads a newcomer from the start screen through the window of an example', async () => {
    await playedTwiceAfterFault(launch, async (launchWatched) => {
      const app = await launchWatched([join(ROOT, 'dist', 'electron', 'main.cjs')]);
      const page = await editorWindow(app);
      const errors = collectErrors(page);
      await page.setViewportSize({ width: 1280, height: 800 });
      await page.getByRole('button', { name: 'Take the tour' }).click();
      await page.locator('.react-flow__node').first().waitFor();
      let seen = 0;
      await takeTour(page, async (step) => {
        seen = step;
        // What each card is about lies in the window, beside the card.
        const [card, frame] = [await page.locator('.tour-card').boundingBox(), await page.locator('.tour-frame').boundingBox()];
        if (!card || !frame) throw new Error('The card or its frame is not on screen.');
        expect([card.x >= 0, card.y >= 0, card.x + card.width <= 1280, card.y + card.height <= 800]).toEqual([true, true, true, true]);
      });
      expect(seen).toBe(TOUR_STEPS);
      // The window is the person's again: the example plays, and a node can be chosen.
      await page.locator('.node-title').first().click();
      await page.locator('.react-flow__node.selected').waitFor();
      expect(errors).toEqual([]);
      await app.close();
    });
  });
});
