import { cp, mkdir, mkdtemp, readdir, readFile, rm } from 'node:fs/promises';
import { tmpdir } from 'node:os';
import { basename, join } from 'node:path';
import { afterAll, beforeAll, expect, test } from '@jest/globals';
import { readCapture } from '../../nodes/kit/capture.ts';
import { axeFindings } from '../support/axe.ts';
import { describeWithProgram } from '../support/colmap.ts';
import { type GraphText, type OpenEditor, saveGraphs, useEditor } from '../support/open-editor.ts';
import { describeWithData } from '../support/shared-data.ts';

const GRAPH: GraphText = {
  nodes: { 'video-aaaa': { type: 'source/camera-video' }, 'screen-aaaa': { type: 'output/screen' } },
  wires: ['video-aaaa.layer -> screen-aaaa.layer'],
  places: { 'video-aaaa': [0, 0], 'screen-aaaa': [300, 0] },
};
const COUNT = 9;

const open = useEditor();
let base = '';
let folder = '';
beforeAll(async () => {
  base = await mkdtemp(join(tmpdir(), 'scrim-import-'));
  folder = join(base, '-Café & "Hall" 1');
});
afterAll(() => rm(base, { recursive: true, force: true }));

const dialogOf = ({ page }: OpenEditor) => page.getByRole('dialog', { name: 'Import photographs' });
const field = (editor: OpenEditor, name: string) => dialogOf(editor).getByRole('textbox', { name, exact: true });
const COLMAP_FIELD = 'COLMAP (empty: the one in PATH)';

describeWithProgram('photographs in the editor', () => {
  describeWithData('of a room', 'captures/icl-livingroom', (room) => {
    beforeAll(async () => {
      await mkdir(join(folder, 'images'), { recursive: true });
      const names = (await readdir(join(room, 'images'))).sort().slice(0, COUNT);
      for (const name of names) await cp(join(room, 'images', name), join(folder, 'images', name.replace('000', '-ö ')));
    });

    test('become a capture on the screen; a canceled import continues where it was', async () => {
      const window = await open(GRAPH, { colorScheme: 'dark' });
      const { page, editor, project } = window;
      await editor.settled();
      const before = await editor.picture();
      await page.keyboard.press('Control+Alt+i');
      const dialog = dialogOf(window);
      await field(window, 'Folder').fill(folder);
      await dialog.getByText(`${COUNT} photographs without cameras. COLMAP`).waitFor();
      expect(await field(window, 'Name of the capture').inputValue()).toBe(basename(folder));
      const go = dialog.getByRole('button', { name: 'Import', exact: true });

      // Another program is not run.
      await field(window, COLMAP_FIELD).fill('/bin/sh');
      await dialog.getByText('/bin/sh is not COLMAP').waitFor();
      expect(await go.isDisabled()).toBe(true);
      await field(window, COLMAP_FIELD).fill(join(base, 'colmap'));
      await dialog.getByText(`COLMAP cannot be run: ${join(base, 'colmap')} is no executable file.`).waitFor();
      await field(window, COLMAP_FIELD).fill('');
      await field(window, 'Name of the capture').fill('Kitchen');

      await go.click();
      await dialog.getByRole('status').filter({ hasText: 'Matching photographs' }).waitFor();
      expect(await field(window, 'Output of COLMAP').inputValue()).toContain('Processed file');
      expect(await dialog.locator('[aria-current="step"]').textContent()).toBe('Matches');
      if (process.env.SHOT) await page.screenshot({ path: `${process.env.SHOT}-progress.png` });
      for (const colorScheme of ['dark', 'light'] as const) {
        await page.emulateMedia({ colorScheme, reducedMotion: 'reduce' });
        expect([colorScheme, await axeFindings(page)]).toEqual([colorScheme, []]);
      }
      await dialog.getByRole('button', { name: 'Cancel' }).click();
      await page.getByText('Import of photographs canceled.').waitFor();
      expect((await readdir(folder)).sort()).toEqual(['.scrim-reconstruction', 'images']);

      await go.click();
      const report = page.getByRole('dialog', { name: 'Kitchen.capture: what was understood' });
      await report.getByText(`Added Kitchen.capture. ${COUNT} photographs.`).waitFor();
      await report.getByText(`${COUNT} × SIMPLE_RADIAL`).waitFor();
      await report.getByRole('button', { name: 'Close' }).click();
      const log = await readFile(join(folder, '.scrim-reconstruction/colmap.log'), 'utf8');
      expect(log.match(/"feature_extractor" "--database_path"/g)).toHaveLength(1);
      const { views } = readCapture(await readFile(join(project, 'assets/Kitchen.capture/capture.json'), 'utf8'));
      expect(views).toHaveLength(COUNT);

      await editor.settled();
      await editor.hold();
      await editor.imageOtherThan(before);
      if (process.env.SHOT) await page.screenshot({ path: `${process.env.SHOT}-room.png` });
      const { main } = await saveGraphs(window);
      const types = Object.values(main?.nodes ?? {}).map(({ type }) => type);
      expect(types.sort()).toEqual(['operator/over', 'output/screen', 'source/camera-video', 'source/capture']);
    });
  });
});

test('a folder that is dropped is copied for the import', async () => {
  const window = await open(GRAPH);
  const { page, editor, project } = window;
  await editor.settled();
  const place = join(base, 'hall');
  await mkdir(join(place, 'images'), { recursive: true });
  await cp('tests/support/../../docs/gallery.jpg', join(place, 'images', 'a.jpg'));
  await cp('tests/support/../../docs/gallery.jpg', join(place, 'images', 'b ö.jpg'));
  const cdp = await page.context().newCDPSession(page);
  const { x, y } = await editor.emptyPlace();
  for (const type of ['dragEnter', 'dragOver', 'drop'] as const) {
    await cdp.send('Input.dispatchDragEvent', { type, x, y, data: { items: [], files: [place], dragOperationsMask: 1 } });
  }
  await dialogOf(window).getByText('2 photographs without cameras.').waitFor();
  const staged = join(project, '.scrim/photographs/hall');
  expect(await field(window, 'Folder').inputValue()).toBe(staged);
  expect((await readdir(join(staged, 'images'))).sort()).toEqual(['a.jpg', 'b ö.jpg']);
});
