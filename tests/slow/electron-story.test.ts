import { mkdtemp, rm } from 'node:fs/promises';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { afterEach, beforeEach, expect, test } from '@jest/globals';
import type { ElectronApplication, Page } from 'playwright-core';
import { useBrowser } from '../support/browser.ts';
import { playEditorStory } from '../support/editor-story.ts';
import { describeElectron, findElectron, openFirstLight, playedTwiceAfterFault } from '../support/electron.ts';
import { expectPoster, visitExportedPage } from '../support/exported-page.ts';
import { eventually } from '../support/patience.ts';

describeElectron('the editor in Electron', await findElectron(), (launch) => {
  const visitor = useBrowser();
  let base = '';
  beforeEach(async () => {
    base = await mkdtemp(join(tmpdir(), 'scrim-story-'));
  });
  afterEach(() => rm(base, { recursive: true, force: true }));

  test('a designer’s afternoon', async () => {
    await playedTwiceAfterFault(launch, async (launchWatched) => {
      await rm(base, { recursive: true, force: true });
      const project = join(base, 'project');
      const exportTo = join(base, 'page');
      const { app, page, errors } = await openFirstLight(launchWatched, project);
      await playEditorStory({ page, project, exportTo, answerFolder: (path) => chooseFolder(app, page, path) });
      expect(errors).toEqual([]);
      await app.close();
    });
    await visitExportedPage(visitor.browser, join(base, 'page'));
    await expectPoster(visitor.browser, join(base, 'page'));
  }, 900_000);
});

/** The system's own dialog cannot be reached from a page; Electron is told what the person would have picked. */
async function chooseFolder(app: ElectronApplication, page: Page, path: string): Promise<void> {
  await app.evaluate(({ dialog }, folder) => {
    const answer = async () => ({ canceled: false, filePaths: [folder], filePath: folder });
    Object.assign(dialog, { showOpenDialog: answer, showSaveDialog: answer });
  }, path);
  const dialog = page.getByRole('dialog', { name: 'Export the page' });
  await dialog.getByRole('button', { name: 'Choose…' }).click();
  await eventually(async () => expect(await dialog.getByRole('textbox', { name: 'Folder' }).inputValue()).toBe(path));
  await dialog.getByRole('button', { name: 'Export', exact: true }).click();
}
