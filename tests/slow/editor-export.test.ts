import { mkdtemp, readdir, rm } from 'node:fs/promises';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { afterAll, beforeAll, expect, test } from '@jest/globals';
import { expectPoster } from '../support/exported-page.ts';
import { useOneEditor } from '../support/open-editor.ts';

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
  await dialog.getByRole('button', { name: 'Export' }).click();
}

async function exportTo(name: string): Promise<string> {
  const out = join(base, name);
  await askFor(out);
  await open.page.getByText(`Exported to ${out}`).waitFor();
  return out;
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
  await page.getByRole('combobox', { name: 'Preview source' }).selectOption('room/studio');
  await editor.settled();
  await page.getByRole('button', { name: 'Two views, as in a headset' }).click();
  await editor.settled();
  const before = await editor.rewind();
  await expectPoster(open.browser, await exportTo('room'));
  await editor.imageSameAs(before, 'exported');
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
    await route.fulfill({ json: { output: { ok: false, out, diagnostics: [], bytes: 0 } } });
  });
  // Once the host is at it: a cancel while the picture is still being taken ends the export without it, and at once.
  const run = page.waitForRequest('**/api/call/export.run');
  const cancel = page.waitForRequest('**/api/call/export.cancel');
  try {
    await askFor(out);
    await run;
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

test('a page is exported without a picture where the graphics are lost, and the problems say so', async () => {
  const { page } = open;
  const frame = page.frames().find((candidate) => candidate !== page.mainFrame());
  await frame?.evaluate(() => {
    document.querySelector<HTMLCanvasElement>('#picture')?.getContext('webgl2')?.getExtension('WEBGL_lose_context')?.loseContext();
  });
  await page.getByText('The graphics device was lost').waitFor();
  const out = await exportTo('neutral');
  expect((await readdir(out)).filter((name) => name.startsWith('poster-'))).toEqual([expect.stringMatching(/\.png$/)]);
  await page.locator('.status-problems').click();
  await page.getByRole('list', { name: 'Problems' }).getByText('The poster of the page could not be rendered').waitFor();
});
