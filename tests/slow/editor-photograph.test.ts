import { readdir, readFile, stat } from 'node:fs/promises';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { expect, test } from '@jest/globals';
import { readCapture } from '../../nodes/kit/capture.ts';
import { axeFindings } from '../support/axe.ts';
import { chooseOption } from '../support/choose-option.ts';
import type { RgbaImage } from '../support/image.ts';
import { type GraphText, useEditor } from '../support/open-editor.ts';
import { eventually } from '../support/patience.ts';

/** A red box on a floor, 2 m in front of the start. */
const GRAPH: GraphText = {
  nodes: {
    'box-aaaa': { type: 'objects/primitive', params: { shape: 'box', sizeM: [0.5, 0.5, 0.5], color: [0.9, 0.2, 0.1, 1] } },
    'lift-aaaa': { type: 'objects/transform', params: { positionM: [0, 0.25, -2] } },
    'floor-aaaa': { type: 'objects/primitive', params: { shape: 'plane', sizeM: [4, 0, 4], color: [0.5, 0.5, 0.6, 1] } },
    'under-aaaa': { type: 'objects/transform', params: { positionM: [0, 0, -2] } },
    'sun-aaaa': { type: 'light/directional' },
    'scene-aaaa': { type: 'layer/scene' },
    'video-aaaa': { type: 'source/camera-video' },
    'screen-aaaa': { type: 'output/screen' },
  },
  wires: [
    'box-aaaa.objects -> lift-aaaa.objects',
    'floor-aaaa.objects -> under-aaaa.objects',
    'lift-aaaa.objects -> scene-aaaa.objects',
    'under-aaaa.objects -> scene-aaaa.objects',
    'sun-aaaa.lights -> scene-aaaa.lights',
    'scene-aaaa.layer -> screen-aaaa.layer',
  ],
  places: {
    'box-aaaa': [0, 0],
    'lift-aaaa': [220, 0],
    'floor-aaaa': [0, 160],
    'under-aaaa': [220, 160],
    'sun-aaaa': [220, 320],
    'scene-aaaa': [440, 80],
    'video-aaaa': [440, 320],
    'screen-aaaa': [660, 80],
  },
};

const open = useEditor();

/** The mean color of the covered pixels of a picture, and their share. */
function look(canvas: HTMLCanvasElement) {
  const { data } = canvas.getContext('2d')?.getImageData(0, 0, canvas.width, canvas.height) ?? { data: new Uint8ClampedArray() };
  const sums = [0, 0, 0, 0];
  for (let i = 0; i < data.length; i += 4) {
    if ((data[i + 3] ?? 0) < 255) continue;
    for (let c = 0; c < 3; c++) sums[c] = (sums[c] ?? 0) + (data[i + c] ?? 0);
    sums[3] = (sums[3] ?? 0) + 1;
  }
  const [r = 0, g = 0, b = 0, covered = 0] = sums;
  return { mean: [r, g, b].map((sum) => sum / covered), share: covered / (data.length / 4) };
}

/** Positions of the pixels in the color of the box. */
function redPixels({ data }: RgbaImage): number[] {
  const found: number[] = [];
  for (let i = 0; i < data.length; i += 4) {
    const [r = 0, g = 0, b = 0] = data.subarray(i, i + 3);
    if (r > 120 && g < 0.45 * r && b < 0.45 * r) found.push(i);
  }
  return found;
}

async function filesIn(folder: string): Promise<readonly string[]> {
  const entries = await readdir(folder, { recursive: true, withFileTypes: true });
  return entries.flatMap((entry) => (entry.isFile() ? [join(entry.parentPath, entry.name)] : []));
}

/** Folders of photographs that are not packed yet. */
const staged = async () => (await readdir(tmpdir())).filter((name) => name.startsWith('scrim-photographs-'));

test('photographs of a scene become a capture, which a node shows', async () => {
  const before = await staged();
  const { page, editor, project } = await open(GRAPH, { colorScheme: 'dark' });
  await editor.settled();
  await page.keyboard.press('Control+Alt+p');
  const dialog = page.getByRole('dialog', { name: 'Photograph the scene' });
  await dialog.waitFor();
  const field = (name: string) => dialog.getByRole('textbox', { name, exact: true });
  const fill = async (fields: Readonly<Record<string, string>>) => {
    for (const [name, text] of Object.entries(fields)) await field(name).fill(text);
  };
  const take = dialog.getByRole('button', { name: 'Take photographs' });
  const picture = (kind: string, camera: number) => dialog.getByRole('img', { name: `${kind} of camera ${camera}` });

  // Errors stand at their fields.
  await fill({ Number: '1001', 'Diameters (m) y': '0', 'Field of view (°)': '170' });
  await expect(field('Number').getAttribute('aria-invalid')).resolves.toBe('true');
  const said = await dialog.locator('.form-error').allTextContents();
  expect(said).toEqual([
    'These are 1001 cameras. A capture has at most 1000.',
    'Enter three numbers above 0.',
    'Enter an angle from 1° to 150°.',
  ]);
  expect(await take.isDisabled()).toBe(true);
  await chooseOption(dialog.getByRole('combobox', { name: 'Layer' }), 'video-aaaa.layer');
  await dialog.getByText('This layer has no depth. Choose that of a Scene.').waitFor();
  await chooseOption(dialog.getByRole('combobox', { name: 'Layer' }), 'scene-aaaa.layer');

  await fill({
    'Name of the capture': 'Red box',
    Number: '6',
    'Center (m) x': '0',
    'Center (m) y': '0.2',
    'Center (m) z': '-2',
    'Diameters (m) x': '3',
    'Diameters (m) y': '2',
    'Diameters (m) z': '3',
    'Field of view (°)': '40',
    'Heights above the center (°) from': '20',
    'Heights above the center (°) to': '60',
    'Size (pixels) width': '160',
    'Size (pixels) height': '120',
  });
  const isShown = () => dialog.locator('.photograph-preview[aria-busy="false"]').waitFor();
  await isShown();
  expect(await dialog.locator('figcaption').allTextContents()).toEqual(['Color', expect.stringMatching(/^Depth, \d\.\d\d to \d\.\d\d m$/)]);
  await dialog.getByText('kB on disk').waitFor();
  const status = (await dialog.getByRole('status').textContent()) ?? '';
  expect(status).toMatch(/^6 photographs: about \d+ kB on disk, [\d.]+ (kB|MB) on the GPU\./);
  const estimateKb = Number(/about (\d+) kB/.exec(status)?.[1]);
  const first = await picture('Color', 1).evaluate(look);
  const depth = await picture('Depth', 1).evaluate(look);
  expect(first.share).toBeGreaterThan(0.9);
  expect(depth.share).toBeCloseTo(first.share, 1);
  const url = () => dialog.getByRole('img', { name: /^Color/ }).evaluate((canvas) => (canvas as HTMLCanvasElement).toDataURL());
  const shown = await url();
  await dialog.getByRole('button', { name: 'Next camera' }).click();
  await dialog.getByText('2 of 6').waitFor();
  await isShown();
  expect(await url()).not.toBe(shown);
  for (const colorScheme of ['dark', 'light'] as const) {
    await page.emulateMedia({ colorScheme, reducedMotion: 'reduce' });
    expect([colorScheme, await axeFindings(page)]).toEqual([colorScheme, []]);
  }
  if (process.env.SHOT) await page.screenshot({ path: `${process.env.SHOT}-dialog.png` });

  await take.click();
  await page.getByText('Added Red-box.capture to the assets.').waitFor();
  const capture = readCapture(await readFile(join(project, 'assets/Red-box.capture/capture.json'), 'utf8'));
  expect(capture.views.map(({ widthPx, heightPx, depthMesh }) => [widthPx, heightPx, depthMesh !== undefined])).toEqual(
    Array.from({ length: 6 }, () => [160, 120, true]),
  );
  expect(await staged()).toEqual(before);
  const bytes = (await Promise.all((await filesIn(join(project, 'assets/Red-box.capture'))).map((file) => stat(file)))).reduce(
    (sum, { size }) => sum + size,
    0,
  );
  expect(estimateKb * 1000).toBeGreaterThan(bytes / 2);
  expect(estimateKb * 1000).toBeLessThan(bytes * 2);

  await editor.hold();
  const scene = await editor.picture();
  const row = page.getByRole('row', { name: /Red-box\.capture/ });
  await row.getByRole('button', { name: 'Add a node with Red-box.capture' }).click();
  await page.locator('.react-flow__node', { hasText: 'Red-box' }).waitFor();
  // It lies over the scene; alone, it shows what it has of it.
  await editor.wire([await editor.nodeId('capture'), 'layer'], ['screen-aaaa', 'layer']);
  const place = await editor.imageOtherThan(scene, 100);
  if (process.env.SHOT) await page.screenshot({ path: `${process.env.SHOT}-node.png` });
  // The box stands where it stood, in its color.
  const [reds, shownReds] = [redPixels(scene), redPixels(place)];
  expect(reds.length).toBeGreaterThan(500);
  expect(shownReds.filter((pixel) => reds.includes(pixel)).length / reds.length).toBeGreaterThan(0.9);
  expect(shownReds.length / reds.length).toBeLessThan(1.15);
});

test('canceled photographs leave nothing', async () => {
  const before = await staged();
  const { page, editor, project } = await open(GRAPH);
  await editor.settled();
  let release = () => {};
  const held = new Promise<void>((resolve) => {
    release = resolve;
  });
  let count = 0;
  await page.route('**/api/call/capture.add', async (route) => {
    if (++count === 2) await held;
    await route.continue();
  });
  await page.keyboard.press('Control+Alt+p');
  const dialog = page.getByRole('dialog', { name: 'Photograph the scene' });
  await chooseOption(dialog.getByRole('combobox', { name: 'Projection' }), 'equirectangular');
  await dialog.getByRole('textbox', { name: 'Width (pixels)' }).fill('64');
  await dialog.getByRole('textbox', { name: 'Center (m) z' }).fill('-2');
  await dialog.getByRole('textbox', { name: 'Turned left (°)' }).fill('90');
  await dialog.locator('.photograph-preview[aria-busy="false"]').waitFor();
  await page.keyboard.press('Enter');
  try {
    await page.getByText('Photograph 2 of 24').waitFor();
    await page.getByRole('button', { name: 'Cancel', exact: true }).click();
  } finally {
    release();
  }
  await page.getByText('Photographs canceled.').waitFor();
  await eventually(async () => expect(await staged()).toEqual(before));
  expect(await readdir(project)).not.toContain('assets');
});
