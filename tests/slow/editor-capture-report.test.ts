import { cp, mkdtemp, open as openFile, readdir, readFile, rm, writeFile } from 'node:fs/promises';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { afterAll, afterEach, beforeAll, expect, test } from '@jest/globals';
import { decode, encode } from 'fast-png';
import { axeFindings } from '../support/axe.ts';
import { withBall } from '../support/ball-project.ts';
import { useBrowser } from '../support/browser.ts';
import { chooseOption } from '../support/choose-option.ts';
import { type EditorPageOptions, type GraphText, type OpenEditor, openEditor } from '../support/open-editor.ts';
import { eventually } from '../support/patience.ts';
import { describeWithData } from '../support/shared-data.ts';
import { writeTwoCameraScan } from '../support/two-camera-scan.ts';

const GRAPH: GraphText = {
  nodes: { 'video-aaaa': { type: 'source/camera-video' }, 'screen-aaaa': { type: 'output/screen' } },
  wires: ['video-aaaa.layer -> screen-aaaa.layer'],
  places: { 'video-aaaa': [0, 0], 'screen-aaaa': [300, 0] },
};

const chromium = useBrowser();
let window: OpenEditor | null = null;
const open = async (graph: GraphText, options?: EditorPageOptions): Promise<OpenEditor> => {
  window = await openEditor(chromium.browser, graph, options);
  return window;
};
afterEach(async () => {
  // The browser itself says so of a call that is refused.
  const errors = window?.errors.filter((error) => !error.includes('422'));
  await window?.close();
  expect(errors).toEqual([]);
});

let base = '';
beforeAll(async () => {
  base = await mkdtemp(join(tmpdir(), 'scrim-capture-report-'));
  await writeTwoCameraScan(join(base, 'wall'));
});
afterAll(() => rm(base, { recursive: true, force: true }));

test('an import says what it understood, and so does the asset later', async () => {
  const { page, editor, project } = await open(GRAPH, { size: { width: 1024, height: 700 } });
  await editor.settled();
  await page.keyboard.press('Control+Alt+i');
  const form = page.getByRole('dialog', { name: 'Import photographs' });
  await form.getByRole('textbox', { name: 'Folder', exact: true }).fill(join(base, 'wall'));
  await form.getByText('2 photographs, with cameras.').waitFor();
  await form.getByRole('button', { name: 'Import', exact: true }).click();

  const dialog = page.getByRole('dialog', { name: 'wall.capture: what was understood' });
  await dialog.getByText('Added wall.capture. 2 photographs.').waitFor();
  await dialog.getByText('It has 2 photographs only, so most sides are seen once or never.').waitFor();
  await dialog
    .getByText('Its units are taken as meters. If the size is wrong, select its node and press “Set scale by two points”')
    .waitFor();
  const facts = await dialog.locator('.capture-facts > div').allInnerTexts();
  expect(facts.map((fact) => fact.replace(/\s*\n\s*/, ': '))).toEqual(
    expect.arrayContaining([
      'Files: COLMAP (text)',
      'Cameras: 2 × PINHOLE',
      'Points: 1, mean reprojection error 0.50 px',
      'Scale: 1 unit of the reconstruction is 1 m, assumed: the files do not say it',
      'Left out: nothing',
    ]),
  );

  // The worst photograph is first and shown, with its point; the keys of a list show the other one.
  const photos = dialog.getByRole('group', { name: 'Photographs, the worst first' });
  expect(await photos.getByRole('radio').count()).toBe(2);
  expect(await photos.locator('label').allTextContents()).toEqual(['c.jpg1.00 px', 'a&b.jpg0.00 px']);
  const shown = dialog.getByRole('img', { name: 'c.jpg: 1.00 px over 1 point' });
  expect(await shown.locator('.capture-off').getAttribute('d')).toBe('M17.0 24.0l-10.0 0.0');
  await shown.locator('image').waitFor();
  await photos.getByRole('radio', { name: 'c.jpg' }).focus();
  await page.keyboard.press('ArrowDown');
  await dialog.getByRole('img', { name: 'a&b.jpg: 0.00 px over 1 point' }).waitFor();

  // The cameras turn by a key, and a press on one shows its photograph.
  const cameras = dialog.getByRole('img', { name: 'Cameras over the mesh' });
  const first = cameras.locator('[data-camera="0"]').first();
  const before = await first.getAttribute('d');
  await dialog.getByRole('slider', { name: 'Turn' }).focus();
  await page.keyboard.press('ArrowRight');
  await eventually(async () => expect(await first.getAttribute('d')).not.toBe(before));
  await dialog.getByRole('button', { name: 'From the front' }).click();
  const front = await first.getAttribute('d');
  await cameras.hover({ position: { x: 20, y: 20 } });
  await page.mouse.down();
  await cameras.hover({ position: { x: 80, y: 20 } });
  await page.mouse.up();
  await eventually(async () => expect(await first.getAttribute('d')).not.toBe(front));
  await dialog.getByRole('button', { name: 'From the front' }).click();
  await cameras.locator('[data-camera="1"]').first().click();
  await shown.waitFor();

  for (const colorScheme of ['dark', 'light'] as const) {
    await page.emulateMedia({ colorScheme, reducedMotion: 'reduce' });
    expect([colorScheme, await axeFindings(page)]).toEqual([colorScheme, []]);
  }
  await dialog.getByRole('button', { name: 'Close' }).click();

  // The folder of the photographs is not needed any more. A damaged mesh is named in the dialog.
  await rm(join(base, 'wall'), { recursive: true });
  await page.keyboard.press('Shift+r');
  const button = page.getByRole('button', { name: 'Show what Scrim understood of wall.capture' });
  await button.click();
  await dialog.getByText('COLMAP (text)').waitFor();
  await page.keyboard.press('Escape');
  const mesh = await openFile(join(project, 'assets/wall.capture/mesh.bin'), 'r+');
  await mesh.write(new Uint8Array(new Float32Array([Number.NaN]).buffer), 0, 4, 12);
  await mesh.close();
  await button.click();
  await dialog.getByRole('alert').getByText('a vertex of its mesh is not finite').waitFor();
  expect(await axeFindings(page)).toEqual([]);
});

test('a capture without record shows its cameras and says why the rest is missing', async () => {
  const { page, editor } = await open(await withBall());
  await editor.settled();
  await page.keyboard.press('Shift+r');
  await page.getByRole('button', { name: 'Show what Scrim understood of ball.capture' }).click();
  const dialog = page.getByRole('dialog', { name: 'ball.capture: what was understood' });
  await dialog.getByText('Scrim imported this capture before').waitFor();
  expect(await dialog.locator('.cameras-camera').count()).toBe(5);
});

test.each([
  ['views/002.jpg', (file: Uint8Array) => file.subarray(0, -60), 'views/002.jpg is incomplete.'],
  ['mesh.bin', withNaN, 'mesh.bin is damaged at byte 208: vertex 17 is not finite.'],
] as const)('the problems name a damaged %s, its place and the remedy', async (name, damage, message) => {
  const ball = await withBall();
  const file = `ball.capture/${name}`;
  const { page } = await open({
    ...ball,
    nodes: { 'place-aaaa': { type: 'source/capture', params: { file: 'ball' } }, 'screen-aaaa': { type: 'output/screen' } },
    wires: ['place-aaaa.layer -> screen-aaaa.layer'],
    places: { 'place-aaaa': [0, 0], 'screen-aaaa': [300, 0] },
    assetFiles: { ...ball.assetFiles, [file]: damage(ball.assetFiles?.[file] ?? new Uint8Array()) },
  });
  await page.locator('.status-bar').getByText('1 error').click();
  const problem = page.getByRole('list', { name: 'Problems' }).getByRole('button');
  await problem.getByText(`assets/ball.capture/${message}`).waitFor();
  await problem.getByText('Import the capture again.').waitFor();
});

function withNaN(mesh: Uint8Array): Uint8Array {
  const damaged = Uint8Array.from(mesh);
  damaged.set(new Uint8Array(Float32Array.of(Number.NaN).buffer), 12 * 17 + 4);
  return damaged;
}

describeWithData('depth of a room in an unusual unit', 'captures/icl-livingroom', (room) => {
  test('is detected, can be told otherwise, and a wrong unit is refused before the import', async () => {
    const folder = join(base, 'room');
    await cp(room, folder, { recursive: true });
    await rm(join(folder, 'sparse_bin'), { recursive: true });
    // 1/5000 m, as in the recordings of TUM, instead of millimeters.
    for (const name of await readdir(join(folder, 'depth'))) {
      const file = join(folder, 'depth', name);
      const { width, height, data } = decode(await readFile(file));
      await writeFile(
        file,
        encode({ width, height, channels: 1, depth: 16, data: Uint16Array.from(data, (mm) => Math.min(5 * mm, 65535)) }),
      );
    }
    const { page, editor } = await open(GRAPH, { size: { width: 1024, height: 900 } });
    await editor.settled();
    await page.keyboard.press('Control+Alt+i');
    const form = page.getByRole('dialog', { name: 'Import photographs' });
    await form.getByRole('textbox', { name: 'Folder', exact: true }).fill(folder);
    const go = form.getByRole('button', { name: 'Import', exact: true });
    const unit = form.getByRole('combobox', { name: 'Unit' });
    await unit.filter({ hasText: 'Detected: 0.2 mm' }).waitFor();
    await form.getByText('1 unit = 0.2 mm, distance along the view axis; detected by the mesh.').waitFor();
    await form.getByText('1.75 m away in the median, 2.81 m at most.').waitFor();
    expect(await form.getByText(/in the page; .* of 128 MB on the GPU of a phone/).count()).toBe(1);
    expect(await go.isEnabled()).toBe(true);
    expect(await axeFindings(page)).toEqual([]);

    await chooseOption(unit, '0.001');
    await form.getByText('8.77 m away in the median').waitFor();
    await form.getByText('5 times that of the mesh').waitFor();
    expect(await go.isDisabled()).toBe(true);
    await chooseOption(unit, '0.0002');
    await form.getByText('It differs from the mesh by 0.15 % in the median.').waitFor();
    await form.getByRole('textbox', { name: 'Longest side (px)' }).fill('320');
    await go.click();

    const report = page.getByRole('dialog', { name: 'room.capture: what was understood' });
    await report.getByText('18 files, along the axes of the cameras, unit 0.0002 m').waitFor();
    await report.getByText('18, 640 × 480 px, packed as 320 × 240 px').waitFor();
    await report.getByText('read from the depth files').waitFor();
  });
});
