import { mkdtemp, readdir, readFile, rm, stat, writeFile } from 'node:fs/promises';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { afterAll, beforeAll, expect, test } from '@jest/globals';
import { ALL_FORMATS, BufferSource, Input } from 'mediabunny';
import type { ElectronApplication, Page } from 'playwright-core';
import { chooseOption } from '../support/choose-option.ts';
import { EditorDriver } from '../support/editor-driver.ts';
import { chooseInMenu, describeElectron, findElectron, openFirstLight, playedTwiceAfterFault } from '../support/electron.ts';
import { decodeImage } from '../support/image.ts';
import { eventually } from '../support/patience.ts';

const dialog = (page: Page) => page.getByRole('dialog', { name: 'Render frames' });

/** Opens the dialog by the window's own menu, and fills it in. */
async function ask(app: ElectronApplication, page: Page, fields: Readonly<Record<string, string>>): Promise<void> {
  await chooseInMenu(app, 'file.render');
  await dialog(page).waitFor();
  for (const [name, text] of Object.entries({ Width: '160', Height: '120', ...fields })) {
    await dialog(page).getByRole('textbox', { name, exact: true }).fill(text);
  }
}

/** What the system's own dialogs, which no page reaches, would answer. */
async function answerDialogs(app: ElectronApplication, folder: string, video: string): Promise<void> {
  await app.evaluate(
    ({ dialog, session }, [picked, saved]) => {
      Object.assign(dialog, { showOpenDialog: async () => ({ canceled: false, filePaths: [picked] }) });
      session.defaultSession.on('will-download', (_event, item) => item.setSavePath(saved));
    },
    [folder, video] as const,
  );
}

describeElectron('rendering frames in Electron', await findElectron(), (launch) => {
  let base = '';
  beforeAll(async () => {
    base = await mkdtemp(join(tmpdir(), 'scrim-frames-'));
  });
  afterAll(() => rm(base, { recursive: true, force: true }));

  test('writes pictures into a folder that the system asked for, and a video; cancels; and says what cannot be written', async () => {
    await playedTwiceAfterFault(launch, async (launchWatched) => {
      const [project, frames, video] = [join(base, 'project'), join(base, 'frames'), join(base, 'film.video')];
      for (const path of [project, frames, video]) await rm(path, { recursive: true, force: true });
      const { app, page, errors } = await openFirstLight(launchWatched, project);
      await page.locator('.react-flow__node').first().waitFor();
      await answerDialogs(app, frames, video);
      await new EditorDriver(page).settled();

      await ask(app, page, { 'First frame': '3', 'Last frame': '4' });
      await dialog(page).getByRole('button', { name: 'Choose…' }).click();
      await eventually(async () => expect(await dialog(page).getByRole('textbox', { name: 'Folder' }).inputValue()).toBe(frames));
      await dialog(page).getByRole('button', { name: 'Render', exact: true }).click();
      await page.getByText('Rendered 2 frames to').waitFor();
      expect((await readdir(frames)).sort()).toEqual(['000003.png', '000004.png', 'sequence.json']);
      const { width, height, data } = decodeImage(await readFile(join(frames, '000003.png')));
      expect([width, height]).toEqual([160, 120]);
      // A room is in it, not one color.
      expect(new Set(data).size).toBeGreaterThan(100);

      await ask(app, page, { 'First frame': '0', 'Last frame': '5' });
      await chooseOption(dialog(page).getByRole('combobox', { name: 'Format' }), 'video');
      await dialog(page).getByRole('button', { name: 'Render', exact: true }).click();
      await page.getByText('to your downloads.').waitFor();
      await eventually(async () => expect((await stat(video)).size).toBeGreaterThan(0));
      const input = new Input({ source: new BufferSource(await readFile(video)), formats: ALL_FORMATS });
      const track = await input.getPrimaryVideoTrack();
      expect([track?.displayWidth, track?.displayHeight]).toEqual([160, 120]);
      expect(await input.computeDuration()).toBeCloseTo(0.6, 1);

      // So many that the render never ends during the test.
      const cancelled = join(base, 'cancelled');
      await ask(app, page, { 'First frame': '0', 'Last frame': '50000', Folder: cancelled });
      await dialog(page).getByRole('button', { name: 'Render', exact: true }).click();
      await page.getByText(/^Frame \d+ of 50001$/).waitFor();
      await page.getByRole('button', { name: 'Cancel', exact: true }).click();
      await page.getByText('Rendering canceled.').waitFor();
      await eventually(async () => expect((await readdir(base)).filter((name) => name.includes('cancelled'))).toEqual([]));

      // Also for those who may write everywhere, there is no folder in a file.
      const file = join(base, 'file.txt');
      await writeFile(file, 'mine');
      await ask(app, page, { 'First frame': '0', 'Last frame': '0', Folder: join(file, 'frames') });
      await dialog(page).getByRole('button', { name: 'Render', exact: true }).click();
      await dialog(page)
        .getByRole('alert')
        .getByText(/file\.txt.*(cannot be written|is no folder)/)
        .waitFor();
      expect(await readFile(file, 'utf8')).toBe('mine');
      expect(errors).toEqual([]);
    });
  });
});
