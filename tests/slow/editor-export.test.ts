import { mkdtemp, readdir, readFile, rm } from 'node:fs/promises';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { afterAll, beforeAll, expect, test } from '@jest/globals';
import type { Locator } from 'playwright-core';
import { decodeQR } from 'qr/decode.js';
import { frameOf } from '../../tools/lib/frame-of.ts';
import { axeFindings } from '../support/axe.ts';
import { chooseOption, chosenValue } from '../support/choose-option.ts';
import { expectPoster } from '../support/exported-page.ts';
import { decodeImage } from '../support/image.ts';
import { useOneEditor } from '../support/open-editor.ts';
import { eventually } from '../support/patience.ts';

const open = useOneEditor(
  {
    nodes: { 'video-aaaa': { type: 'source/camera-video' }, 'screen-aaaa': { type: 'output/screen' } },
    wires: ['video-aaaa.layer -> screen-aaaa.layer'],
    places: { 'video-aaaa': [0, 0], 'screen-aaaa': [520, 0] },
  },
  {},
);
let base = '';
beforeAll(async () => {
  base = await mkdtemp(join(tmpdir(), 'scrim-export-'));
});
afterAll(() => rm(base, { recursive: true, force: true }));

async function askFor(out: string): Promise<void> {
  const { page } = open;
  await page.getByRole('button', { name: 'Export', exact: true }).first().click();
  const dialog = page.getByRole('dialog', { name: 'Export the page' });
  await dialog.getByRole('textbox').fill(out);
  await dialog.getByRole('button', { name: 'Export', exact: true }).click();
}

async function exportTo(name: string): Promise<string> {
  const out = join(base, name);
  await askFor(out);
  await result().getByText(`Exported to ${out}`).waitFor();
  await open.page.keyboard.press('Escape');
  await result().waitFor({ state: 'detached' });
  return out;
}

function source(): Locator {
  return open.page.getByRole('combobox', { name: 'Preview source' });
}

function result(): Locator {
  return open.page.getByRole('dialog', { name: 'Test', exact: true });
}

/** Opens the last exported page again. */
async function openResult(): Promise<void> {
  await open.page.getByRole('button', { name: 'File' }).click();
  await open.page.getByRole('menuitem', { name: 'Exported page…' }).click();
  await result().waitFor();
}

// The tests go on from one another, as a designer does.
test('a page has the picture of its recording, which plays on as it was', async () => {
  const { editor } = open;
  await editor.settled();
  const before = await editor.rewind();
  await expectPoster(open.browser, await exportTo('recorded'));
  await editor.imageSameAs(before, 'exported');
});

test('a page has the picture of its room, one eye’s of two', async () => {
  const { page, editor } = open;
  const recording = (await chosenValue(source())) ?? '';
  await chooseOption(source(), 'room/studio');
  await editor.settled();
  await page.getByRole('button', { name: 'Two views, as in a headset' }).click();
  await editor.settled();
  const before = await editor.rewind();
  await expectPoster(open.browser, await exportTo('room'));
  await editor.imageSameAs(before, 'exported');
  // Without a GPU, a poster of the room takes as long as all that the next tests look at.
  await editor.press('One view');
  await chooseOption(source(), recording);
  await editor.settled();
});

test('the result shows the page: its picture, sizes, devices and a code that a phone reads', async () => {
  const { page } = open;
  await openResult();
  expect(
    await result()
      .getByRole('img', { name: 'Poster of Test' })
      .evaluate(async (image: HTMLImageElement) => {
        await image.decode();
        return image.naturalWidth;
      }),
  ).toBe(1200);
  const sizes = result().getByRole('region', { name: 'Size' });
  expect(await sizes.getByRole('listitem').first().textContent()).toMatch(/^(Scripts|Poster)\d+ kB$/);
  expect(await result().getByRole('region', { name: 'Devices' }).textContent()).toMatch(/Android phone \(Chrome\)ARMeta Quest/);

  await result().getByRole('textbox', { name: 'Address of the page' }).fill('example.org/my effect/');
  const code = result().getByRole('img', { name: 'QR code of https://example.org/my%20effect/' });
  expect(decodeQR(decodeImage(await code.screenshot()))).toBe('https://example.org/my%20effect/');
  for (const colorScheme of ['dark', 'light'] as const) {
    await page.emulateMedia({ colorScheme, reducedMotion: 'reduce' });
    expect([colorScheme, await axeFindings(page)]).toEqual([colorScheme, []]);
  }
});

test('its switches export the page again: as one file, which opens in the browser', async () => {
  const { page } = open;
  const out = join(base, 'room');
  expect(await readdir(out)).toContain('offline.js');
  await result().getByRole('switch', { name: 'Works offline' }).click();
  await result().getByRole('switch', { name: 'Works offline', checked: false, disabled: false }).waitFor();
  expect(await readdir(out)).not.toContain('offline.js');
  expect(await readFile(join(out, 'index.html'), 'utf8')).toContain('https://example.org/my%20effect/poster-');
  const size = result().getByRole('region', { name: 'Size' });
  expect(await size.textContent()).toMatch(/\d files/);
  await result().getByRole('switch', { name: 'Single file' }).click();
  // The sizes of the other form go at once.
  await size.getByText(/Measuring|1 file$/).waitFor();
  await result().getByRole('switch', { name: 'Single file', checked: true, disabled: false }).waitFor();
  expect((await readdir(out)).sort()).toEqual(['index.html', 'report.json']);
  expect(await size.textContent()).toMatch(/1 file(?!s)/);

  const tab = page.waitForEvent('popup');
  await result().getByRole('button', { name: 'Open in browser' }).click();
  const visited = await tab;
  expect(await visited.title()).toBe('Test');
  await visited.close();
  await page.keyboard.press('Escape');
});

test('an error stands in the dialog, at its folder', async () => {
  const { page } = open;
  await askFor(open.project);
  const dialog = page.getByRole('dialog', { name: 'Export the page' });
  await dialog.getByRole('alert').filter({ hasText: open.project }).waitFor();
  await page.keyboard.press('Escape');
  await dialog.waitFor({ state: 'detached' });
});

test('an export that takes long can be cancelled', async () => {
  const { page } = open;
  const out = join(base, 'cancelled');
  let letGo = () => {};
  const held = new Promise<void>((resolve) => {
    letGo = resolve;
  });
  // The host that is at work, until it is told to leave it.
  await page.route('**/api/call/export.run', async (route) => {
    await held;
    await route.fulfill({ json: { output: { ok: false, out, diagnostics: [], report: null } } });
  });
  // Once the host is at it: a cancel while the picture is still being taken ends the export without it, and at once.
  const run = page.waitForRequest('**/api/call/export.run');
  const cancel = page.waitForRequest('**/api/call/export.cancel');
  try {
    await askFor(out);
    await run;
    const dialog = page.getByRole('dialog', { name: 'Export the page' });
    await dialog.getByRole('button', { name: 'Hide' }).click();
    await dialog.waitFor({ state: 'detached' });
    await page.getByRole('button', { name: 'Cancel' }).click();
    await page.getByRole('status').getByText('Canceling…').waitFor();
    await cancel;
    letGo();
    await page.getByText('Export canceled').waitFor();
    await page.getByRole('button', { name: 'Export', exact: true }).first().waitFor();
  } finally {
    letGo();
    await page.unroute('**/api/call/export.run');
  }
});

test('a picture of the preview is kept as poster, until each export draws one again', async () => {
  const { page, editor } = open;
  await page.getByRole('button', { name: 'Export', exact: true }).first().click();
  const dialog = page.getByRole('dialog', { name: 'Export the page' });
  const poster = dialog.getByRole('img', { name: 'Poster of the page' });
  await dialog.getByRole('button', { name: 'Keep this image' }).click();
  await dialog.getByText('the image that is kept in the project').waitFor();
  const kept = await poster.getAttribute('src');
  await page.keyboard.press('Escape');
  await chooseOption(source(), 'room/studio');
  await editor.settled();
  await askFor(join(base, 'kept'));
  expect(await result().getByRole('img', { name: 'Poster of Test' }).getAttribute('src')).toBe(kept);
  await page.keyboard.press('Escape');
  await page.getByRole('button', { name: 'Export', exact: true }).first().click();
  await dialog.getByRole('button', { name: 'Draw at each export' }).click();
  await dialog.getByRole('button', { name: 'Keep this image' }).waitFor();
  await eventually(async () => expect(await poster.getAttribute('src')).not.toBe(kept));
  await page.keyboard.press('Escape');
});

test('the poster is framed in the preview, and the project keeps the frame until the objects are framed again', async () => {
  const { page, editor } = open;
  const dialog = page.getByRole('dialog', { name: 'Export the page' });
  const poster = dialog.getByRole('img', { name: 'Poster of the page' });
  await page.getByRole('button', { name: 'Export', exact: true }).first().click();
  await poster.waitFor();
  const objects = await poster.getAttribute('src');
  await dialog.getByRole('button', { name: 'Frame in the preview' }).click();
  const guide = page.getByRole('slider', { name: 'Frame of the poster' });
  const boxOf = async () => (await guide.boundingBox()) ?? { x: 0, y: 0, width: 0, height: 1 };
  const before = await boxOf();
  expect(before.width / before.height).toBeCloseTo(1200 / 630, 1);
  for (let i = 0; i < 6; i++) await page.keyboard.press('+');
  const smaller = await boxOf();
  expect(smaller.width / before.width).toBeCloseTo(1.1 ** -6, 1);
  await guide.hover();
  await page.mouse.down();
  await page.mouse.move(before.x + before.width / 2 - 10, before.y + before.height / 2);
  await page.mouse.up();
  expect((await boxOf()).x - smaller.x).toBeCloseTo(-10, 0);
  await page.getByRole('toolbar', { name: 'Poster' }).getByRole('button', { name: 'Use as poster' }).click();
  await guide.waitFor({ state: 'detached' });
  await editor.settled();

  await page.getByRole('button', { name: 'Export', exact: true }).first().click();
  await dialog.getByText('what you framed').waitFor();
  await poster.waitFor();
  const framed = await poster.getAttribute('src');
  expect(framed).not.toBe(objects);
  await dialog.getByRole('button', { name: 'Frame the objects' }).click();
  await dialog.getByText('the selected objects, or all objects').waitFor();
  await eventually(async () => expect(await poster.getAttribute('src')).not.toBe(framed));
  await page.keyboard.press('Escape');
});

test('a page is exported without a picture where the graphics are lost, and the problems say so', async () => {
  const { page } = open;
  const frame = await frameOf(page);
  await frame.evaluate(() => {
    document.querySelector<HTMLCanvasElement>('#picture')?.getContext('webgl2')?.getExtension('WEBGL_lose_context')?.loseContext();
  });
  await page.getByText('The graphics device was lost').waitFor();
  await askFor(join(base, 'neutral'));
  await result().getByText('The page has a neutral poster.').waitFor();
  await page.keyboard.press('Escape');
  await page.locator('.status-problems').click();
  await page.getByRole('list', { name: 'Problems' }).getByText('The poster of the page could not be rendered').waitFor();
});
