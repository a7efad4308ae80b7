import { readFile } from 'node:fs/promises';
import { expect, test } from '@jest/globals';
import type { Download } from 'playwright-core';
import { chooseOption, chosenValue } from '../support/choose-option.ts';
import { decodeImage } from '../support/image.ts';
import { type GraphText, useOneEditor } from '../support/open-editor.ts';
import { eventually } from '../support/patience.ts';
import { countColors } from '../support/pixels.ts';

/** What the camera sees, on the screen. */
const GRAPH: GraphText = {
  nodes: { 'video-aaaa': { type: 'source/camera-video' }, 'screen-aaaa': { type: 'output/screen' } },
  wires: ['video-aaaa.layer -> screen-aaaa.layer'],
  places: { 'video-aaaa': [0, 0], 'screen-aaaa': [300, 0] },
};

/** Chromium's own stand-in for a camera, granted unasked: green, with a disc that turns. */
const open = useOneEditor(
  GRAPH,
  { colorScheme: 'dark', switches: ['--use-fake-device-for-media-stream', '--use-fake-ui-for-media-stream'] },
  async () => {
    await open.editor.settled();
  },
);

async function choose(item: string): Promise<void> {
  await open.page.getByRole('button', { name: 'Preview options' }).click();
  await open.page.getByRole('menu', { name: 'Preview options' }).getByText(item).click();
}

async function downloadAfter(act: () => Promise<void>): Promise<{ readonly download: Download; readonly bytes: Buffer }> {
  const waiting = open.page.waitForEvent('download');
  await act();
  const download = await waiting;
  return { download, bytes: await readFile(await download.path()) };
}

function source() {
  return open.page.getByRole('combobox', { name: 'Preview source' });
}

function shareOf(picture: { readonly data: ArrayLike<number> }, is: (r: number, g: number, b: number) => boolean): number {
  let count = 0;
  for (let i = 0; i < picture.data.length; i += 4) {
    if (is(picture.data[i] ?? 0, picture.data[i + 1] ?? 0, picture.data[i + 2] ?? 0)) count++;
  }
  return count / (picture.data.length / 4);
}

test('a screenshot is the preview’s picture, pixel for pixel', async () => {
  const { editor } = open;
  await editor.rewind();
  const shown = await editor.picture();
  const { download, bytes } = await downloadAfter(() => choose('Take screenshot'));
  expect(download.suggestedFilename()).toBe('Test.png');
  const picture = decodeImage(bytes);
  expect(picture.width).toBe(shown.width);
  const below = picture.data.slice((picture.height - shown.height) * picture.width * 4);
  let different = 0;
  for (let i = 0; i < below.length; i++) if (Math.abs((below[i] ?? 0) - (shown.data[i] ?? 0)) > 1) different++;
  expect(different).toBe(0);
});

test('an entry of the palette is shown while the person points at it, and nothing stays of it', async () => {
  const { page, editor } = open;
  const before = await editor.rewind();
  await page.getByRole('button', { name: 'Add node' }).click();
  const search = page.getByRole('dialog', { name: 'Add a node' }).getByRole('combobox');
  await search.fill('sobel');
  await editor.imageOtherThan(before);
  await page.keyboard.press('Escape');
  await editor.imageSameAs(before, 'candidate-left');
  await page.locator('.saved').waitFor();
  expect(await page.getByRole('button', { name: 'Undo' }).isDisabled()).toBe(true);
  await page.locator('.status-bar').getByText('No problems').waitFor();
});

test('the star of an entry makes it a favorite, which stands first when the palette opens again, until the key takes it back', async () => {
  const { page } = open;
  const palette = page.getByRole('dialog', { name: 'Add a node' });
  const search = palette.getByRole('combobox');
  const favorites = palette.locator('.palette-category').getByText('Favorites', { exact: true });
  await page.getByRole('button', { name: 'Add node' }).click();
  await search.fill('pixelate');
  const row = palette.getByRole('option', { name: 'Pixelate' }).first();
  await row.hover();
  await row.locator('.palette-star').click();
  await palette.getByRole('button', { name: 'Favorite', pressed: true }).waitFor();
  await page.keyboard.press('Escape');
  await page.reload();
  await open.editor.settled();
  await page.getByRole('button', { name: 'Add node' }).click();
  await favorites.waitFor();
  expect(await palette.getByRole('option').first().locator('.palette-title').textContent()).toBe('Pixelate');
  await palette.getByRole('option').first().hover();
  await page.keyboard.press('Control+d');
  await favorites.waitFor({ state: 'detached' });
  await page.keyboard.press('Escape');
});

test('a video of what plays is recorded until it is stopped', async () => {
  const { page, editor } = open;
  await editor.press('Play');
  await choose('Record video');
  const stop = page.getByRole('button', { name: 'Stop recording' });
  await stop.waitFor();
  const from = await editor.frame();
  await page.waitForFunction((first) => Number(document.querySelector('.transport-time span')?.textContent) > first + 5, from);
  const { download, bytes } = await downloadAfter(() => stop.click());
  expect(download.suggestedFilename()).toMatch(/^Test\.(webm|mp4)$/);
  expect(bytes.length).toBeGreaterThan(2000);
  // EBML of WebM, or the `ftyp` box of MP4.
  expect([bytes.readUInt32BE(0).toString(16), bytes.subarray(4, 8).toString()]).toEqual(
    expect.arrayContaining([expect.stringMatching(/^(1a45dfa3|ftyp)$/)]),
  );
  await stop.waitFor({ state: 'detached' });
  await editor.hold();
});

test('the preview has the shape of the chosen device', async () => {
  const { page, editor } = open;
  const shapeOf = async () => {
    const box = await page.locator('iframe[title="Preview"]').boundingBox();
    return box ? box.width / box.height : 0;
  };
  await editor.press('Phone, portrait');
  expect(await shapeOf()).toBeCloseTo(9 / 19.5, 1);
  await editor.press('Phone, landscape');
  expect(await shapeOf()).toBeCloseTo(19.5 / 9, 1);
  await chooseOption(source(), 'room/studio');
  await editor.press('Headset');
  await open.editor.settled();
  expect(await shapeOf()).toBeCloseTo(3360 / 1760, 1);
  await editor.press('Glasses (additive display)');
  await editor.settled();
  // Not the size of the panel.
  await choose('Render size: 720p');
  await page.locator('.status-bar').getByText(/× 720/).waitFor();
  await choose('Render size: automatic');
  await editor.press('Fit to panel');
});

test('the preview moves to a window of its own, where it shows the same, and returns when that is closed', async () => {
  const { page, editor } = open;
  const popup = await editor.popOut();
  expect(countColors(decodeImage(await popup.screenshot()))).toBeGreaterThan(100);
  await popup.close();
  await page.locator('iframe[title="Preview"]').waitFor();
  await editor.settled();
});

test('the light of an emulated room is moved by pointer and keys, and goes back', async () => {
  const { page, editor } = open;
  await chooseOption(source(), 'room/studio');
  await editor.settled();
  const home = await editor.rewind();
  await editor.press('Room light');
  const panel = page.getByRole('dialog', { name: 'Room light' });
  const dome = await panel.locator('.room-light-dome').boundingBox();
  if (!dome) throw new Error('There is no dome.');
  const elevation = panel.getByRole('slider', { name: 'Elevation' });
  const azimuth = panel.getByRole('slider', { name: 'Azimuth' });
  // From the left, half way up.
  await page.mouse.click(dome.x + dome.width / 4, dome.y + dome.height / 2);
  expect([await azimuth.getAttribute('aria-valuetext'), await elevation.getAttribute('aria-valuetext')]).toEqual(['-90°', '45°']);
  const left = await editor.imageOtherThan(home);
  await azimuth.focus();
  await page.keyboard.press('End');
  expect(await azimuth.getAttribute('aria-valuetext')).toBe('180°');
  await editor.imageOtherThan(left);
  await panel.getByRole('button', { name: 'Reset' }).click();
  await page.keyboard.press('Escape');
  await panel.waitFor({ state: 'detached' });
  await editor.imageSameAs(home, 'light moved back');
});

test('a picture stands in for the camera, and so does the webcam', async () => {
  const { page, editor } = open;
  const red = await page.evaluate(async () => {
    const canvas = new OffscreenCanvas(640, 480);
    const context = canvas.getContext('2d');
    if (!context) throw new Error('No context.');
    context.fillStyle = '#d02010';
    context.fillRect(0, 0, 640, 480);
    return [...new Uint8Array(await (await canvas.convertToBlob({ type: 'image/png' })).arrayBuffer())];
  });
  const choosing = page.waitForEvent('filechooser');
  await chooseOption(source(), 'still');
  await (await choosing).setFiles({ name: 'red.png', mimeType: 'image/png', buffer: Buffer.from(red) });
  const isRed = (r: number, g: number, b: number) => r > 150 && g < 80 && b < 80;
  const isGreen = (r: number, g: number, b: number) => g > 90 && r < 80 && b < 80;
  const shows = (is: typeof isRed, share: number) =>
    eventually(async () => expect(shareOf(await editor.picture(), is)).toBeGreaterThanOrEqual(share));
  await editor.press('Play');
  await shows(isRed, 0.98);
  await chooseOption(source(), 'camera');
  await shows(isGreen, 0.5);
});

test('the table of devices says what each shows, and plays as a headset', async () => {
  const { page, editor } = open;
  await page.keyboard.press('Escape');
  await page.locator('.react-flow__pane').click({ position: { x: 20, y: 20 } });
  const devices = page.getByRole('region', { name: 'Devices' });
  const row = (name: string) => devices.locator('.device-row', { hasText: name });
  expect(await row('Android phone').textContent()).toMatch(/everything works/);
  await row('Meta Quest').getByRole('button', { name: 'Play as Meta Quest (Browser)' }).click();
  await eventually(async () => expect(await chosenValue(source())).toMatch(/^room/));
  await editor.settled();
  await page
    .getByRole('button', { name: 'Two views' })
    .or(page.getByRole('button', { name: 'One view' }))
    .waitFor();
  await row('Meta Quest').getByRole('button', { pressed: true }).waitFor();
});
