import { cp, mkdtemp, rm } from 'node:fs/promises';
import { tmpdir } from 'node:os';
import { join, resolve } from 'node:path';
import { afterAll, beforeAll, expect, test } from '@jest/globals';
import { type EditorServer, startServer } from '../../app/server/start-server.ts';
import { installationAt } from '../../app/services/installation.ts';
import { collectErrors, useBrowser } from '../support/browser.ts';
import { playEditorStory } from '../support/editor-story.ts';
import { expectPoster, visitExportedPage } from '../support/exported-page.ts';

const ROOT = resolve(import.meta.dirname, '../..');
const browser = useBrowser();
let base = '';
let server: EditorServer;

beforeAll(async () => {
  base = await mkdtemp(join(tmpdir(), 'scrim-story-'));
  await cp(join(ROOT, 'examples', 'first-light'), join(base, 'project'), { recursive: true });
  server = await startServer({
    installation: installationAt(ROOT, '0.0.0'),
    startPath: join(base, 'project'),
    log: (message) => process.stderr.write(`${message}\n`),
  });
});
afterAll(async () => {
  await server.close();
  await rm(base, { recursive: true, force: true });
});

test('a designer’s afternoon, in the browser', async () => {
  const page = await browser.browser.newPage({ viewport: { width: 1440, height: 900 } });
  const errors = collectErrors(page);
  await page.goto(server.invite());
  const exportTo = join(base, 'page');
  await playEditorStory({
    page,
    project: join(base, 'project'),
    exportTo,
    answerFolder: async (path) => {
      const dialog = page.getByRole('dialog', { name: 'Export the page' });
      await dialog.getByRole('textbox').fill(path);
      await dialog.getByRole('button', { name: 'Export', exact: true }).click();
    },
  });
  expect(errors).toEqual([]);
  await page.close();

  await visitExportedPage(browser.browser, exportTo);
  await expectPoster(browser.browser, exportTo);
});
