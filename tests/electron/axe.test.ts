import { mkdtemp, rm } from 'node:fs/promises';
import { tmpdir } from 'node:os';
import { join, resolve } from 'node:path';
import { afterAll, beforeAll, expect, test } from '@jest/globals';
import type { Page } from 'playwright-core';
import { axeFindings } from '../support/axe.ts';
import { describeElectron, editorWindow, findElectron, openFirstLight, playedTwiceAfterFault } from '../support/electron.ts';

const ROOT = resolve(import.meta.dirname, '../..');

async function expectNothingFound(page: Page): Promise<void> {
  for (const colorScheme of ['dark', 'light'] as const) {
    await page.emulateMedia({ colorScheme, reducedMotion: 'reduce' });
    expect([colorScheme, await axeFindings(page)]).toEqual([colorScheme, []]);
  }
}

describeElectron('axe in Electron finds nothing wrong with', await findElectron(), (launch) => {
  let base = '';
  beforeAll(async () => {
    base = await mkdtemp(join(tmpdir(), 'scrim-axe-'));
  });
  afterAll(() => rm(base, { recursive: true, force: true }));

  test('the start screen', async () => {
    await playedTwiceAfterFault(launch, async (launchWatched) => {
      const app = await launchWatched([join(ROOT, 'dist', 'electron', 'main.cjs')]);
      const page = await editorWindow(app);
      await page.getByRole('button', { name: 'New project: Empty' }).waitFor();
      await expectNothingFound(page);
      await app.close();
    });
  });

  test('the editor with an example, and the dialog of an export', async () => {
    await playedTwiceAfterFault(launch, async (launchWatched) => {
      const { app, page, errors } = await openFirstLight(launchWatched, join(base, 'project'));
      await page.locator('.react-flow__node').first().waitFor();
      await expectNothingFound(page);
      await page.getByRole('button', { name: 'Export', exact: true }).click();
      await page.getByRole('dialog', { name: 'Export the page' }).waitFor();
      await expectNothingFound(page);
      expect(errors).toEqual([]);
      await app.close();
    });
  });
});
