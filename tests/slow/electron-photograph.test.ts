import { mkdtemp, readFile, rm } from 'node:fs/promises';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { afterAll, beforeAll, expect, test } from '@jest/globals';
import { readCapture } from '../../nodes/kit/capture.ts';
import { chooseOption } from '../support/choose-option.ts';
import { EditorDriver } from '../support/editor-driver.ts';
import { chooseInMenu, describeElectron, findElectron, openFirstLight, playedTwiceAfterFault } from '../support/electron.ts';

describeElectron('photographs of a scene in Electron', await findElectron(), (launch) => {
  let base = '';
  beforeAll(async () => {
    base = await mkdtemp(join(tmpdir(), 'scrim-electron-photographs-'));
  });
  afterAll(() => rm(base, { recursive: true, force: true }));

  test('become a capture, which is rephotographed', async () => {
    await playedTwiceAfterFault(launch, async (launchWatched) => {
      const project = join(base, 'project');
      const { app, page, errors } = await openFirstLight(launchWatched, project);
      await page.locator('.react-flow__node').first().waitFor();
      await new EditorDriver(page).settled();

      await chooseInMenu(app, 'file.photograph');
      const dialog = page.getByRole('dialog', { name: 'Photograph the scene' });
      await dialog.waitFor();
      await chooseOption(dialog.getByRole('combobox', { name: 'Layer' }), 'scene-s6ne.layer');
      const place = { 'Center (m) x': '0', 'Center (m) y': '0.6', 'Center (m) z': '-0.7' };
      const fields = { 'Name of the capture': 'Robot', Number: '4', 'Size (pixels) width': '64', 'Size (pixels) height': '48', ...place };
      for (const [name, text] of Object.entries(fields)) await dialog.getByRole('textbox', { name, exact: true }).fill(text);
      await dialog.locator('.photograph-preview[aria-busy="false"]').waitFor();
      await dialog.getByRole('button', { name: 'Take photographs' }).click();
      await page.getByText('Added Robot.capture to the assets.').waitFor();
      const { views } = readCapture(await readFile(join(project, 'assets/Robot.capture/capture.json'), 'utf8'));
      expect(views.map(({ widthPx, heightPx }) => [widthPx, heightPx])).toEqual(Array.from({ length: 4 }, () => [64, 48]));

      await chooseInMenu(app, 'file.rephotograph');
      const form = page.getByRole('dialog', { name: 'Rephotograph a capture' });
      await form.getByRole('button', { name: 'Rephotograph' }).click();
      const result = page.getByRole('dialog', { name: 'Robot.capture, rephotographed' });
      await result.waitFor();
      expect(await result.getByRole('rowheader').allTextContents()).toEqual(['Plain', 'Nearest', 'Lumigraph', 'Depth meshes']);
      const report = JSON.parse(await readFile(join(project, 'reports/Robot/report.json'), 'utf8')) as { views: unknown[] };
      expect(report.views).toHaveLength(4);
      expect(errors).toEqual([]);
    });
  });
});
