import { mkdtemp, rm } from 'node:fs/promises';
import { tmpdir } from 'node:os';
import { join, resolve } from 'node:path';
import { afterAll, beforeAll, expect, test } from '@jest/globals';
import type { Page } from 'playwright-core';
import { startServer } from '../../app/server/start-server.ts';
import { installationAt } from '../../app/services/installation.ts';
import { playFilter } from '../../tools/newcomer/play-filter.ts';
import { playPortal } from '../../tools/newcomer/play-portal.ts';
import { collectErrors, useBrowser } from '../support/browser.ts';
import { EditorDriver } from '../support/editor-driver.ts';
import { visitExportedPage } from '../support/exported-page.ts';
import type { RgbaImage } from '../support/image.ts';
import { eventually } from '../support/patience.ts';
import { countDifferent } from '../support/pixels.ts';

const ROOT = resolve(import.meta.dirname, '../..');

let base = '';
beforeAll(async () => {
  base = await mkdtemp(join(tmpdir(), 'scrim-newcomer-'));
});
afterAll(() => rm(base, { recursive: true, force: true }));

const browser = useBrowser();

async function inEditor(use: (page: Page, editor: EditorDriver) => Promise<void>): Promise<void> {
  const server = await startServer({ installation: installationAt(ROOT, '0.0.0'), startPath: null, log: () => {} });
  const page = await browser.browser.newPage({ viewport: { width: 1440, height: 900 }, reducedMotion: 'reduce' });
  const errors = collectErrors(page);
  try {
    await page.goto(server.invite());
    await use(page, new EditorDriver(page));
  } finally {
    await page.close();
    await server.close();
  }
  expect(errors).toEqual([]);
}

test('a newcomer writes a filter in at most 10 interactions', async () => {
  await inEditor(async (page, editor) => {
    const done = await playFilter({ page, project: join(base, 'filter') });
    expect(done.length).toBeLessThanOrEqual(10);
    // The camera video is blue now. The room is brown.
    await eventually(async () => expect(blueOver(await editor.picture())).toBeGreaterThan(20));
  });
});

test('a newcomer makes a page with a portal in at most 20 interactions', async () => {
  const exportTo = join(base, 'page');
  await inEditor(async (page, editor) => {
    const done = await playPortal({ page, project: join(base, 'portal'), exportTo });
    expect(done.length).toBeLessThanOrEqual(20);
    await page.keyboard.press('Escape');
    await page.getByRole('dialog').waitFor({ state: 'detached' });
    await editor.settled();
    const portal = await editor.restingImage();
    await editor.node('posterize').locator('.node-title').click();
    await page.keyboard.press('m');
    const plain = await editor.imageOtherThan(portal, 300);
    // The room around the portal is unchanged.
    expect(countDifferent(plain, portal, 24).pixels).toBeLessThan((plain.width * plain.height) / 3);
  });
  await visitExportedPage(browser.browser, exportTo);
});

/** Mean of blue above that of red. */
function blueOver({ data }: RgbaImage): number {
  let sum = 0;
  for (let i = 0; i < data.length; i += 4) sum += (data[i + 2] ?? 0) - (data[i] ?? 0);
  return sum / (data.length / 4);
}
