import { access, rm } from 'node:fs/promises';
import { join } from 'node:path';
import { beforeAll, expect, test } from '@jest/globals';
import { axeFindings } from '../support/axe.ts';
import { useBrowser } from '../support/browser.ts';
import type { RgbaImage } from '../support/image.ts';
import { looseModel } from '../support/loose-model.ts';
import { type GraphText, openEditor, saveGraphs } from '../support/open-editor.ts';
import { eventually } from '../support/patience.ts';

/** An orange tile before the camera, lit by the sun; its model lies in three files in a folder below `assets`. */
const GRAPH: GraphText = {
  nodes: {
    'model-aaaa': { type: 'source/model', params: { model: 'tile' } },
    'place-aaaa': { type: 'objects/transform', params: { positionM: [0, 1, -1.5] } },
    'sun-aaaa': { type: 'light/directional' },
    'scene-aaaa': { type: 'layer/scene' },
    'screen-aaaa': { type: 'output/screen' },
  },
  wires: [
    'model-aaaa.objects -> place-aaaa.objects',
    'sun-aaaa.lights -> scene-aaaa.lights',
    'place-aaaa.objects -> scene-aaaa.objects',
    'scene-aaaa.layer -> screen-aaaa.layer',
  ],
  places: {
    'model-aaaa': [0, 0],
    'place-aaaa': [220, 0],
    'sun-aaaa': [220, 200],
    'scene-aaaa': [440, 0],
    'screen-aaaa': [660, 0],
  },
  assets: { tile: { path: 'assets/shapes/tile.gltf', kind: 'model' } },
};
/** Far from where copies are put, so that both are seen. */
const OTHER: GraphText = { nodes: { 'sepia-bbbb': { type: 'filter/sepia' } }, wires: [], places: { 'sepia-bbbb': [0, 400] } };

const chromium = useBrowser();
let files: Readonly<Record<string, Uint8Array<ArrayBuffer>>> = {};
beforeAll(async () => {
  files = await looseModel();
});

const withFiles = (model = files): GraphText => ({
  ...GRAPH,
  assetFiles: Object.fromEntries(Object.entries(model).map(([name, bytes]) => [`shapes/${name}`, bytes])),
});

function orangePixels({ data }: RgbaImage): number {
  let count = 0;
  for (let i = 0; i < data.length; i += 4)
    if ((data[i] ?? 0) > 1.5 * (data[i + 1] ?? 0) && (data[i] ?? 0) > 3 * (data[i + 2] ?? 0)) count++;
  return count;
}

test('nodes with a model in several files are copied to another project, where they draw the same', async () => {
  const first = await openEditor(chromium.browser, withFiles());
  const second = await openEditor(chromium.browser, OTHER);
  try {
    await first.page.context().grantPermissions(['clipboard-read', 'clipboard-write']);
    await first.page.bringToFront();
    const picture = await first.editor.rewind();
    expect(orangePixels(picture)).toBeGreaterThan(2000);
    await first.editor.node('model').locator('.node-title').click();
    await first.page.keyboard.press('Control+a');
    await first.page.keyboard.press('Control+c');
    // With the model's file, once that has been read.
    await eventually(async () => expect(await first.page.evaluate(() => navigator.clipboard.readText())).toContain('"files":{"tile"'));
    await second.page.bringToFront();
    await second.editor.node('sepia').locator('.node-title').click();
    await second.page.keyboard.press('Control+v');
    await second.editor.node('model').waitFor();
    await saveGraphs(second);
    await access(join(second.project, 'assets', 'tile.glb'));
    await second.editor.rewind();
    await second.editor.imageSameAs(picture, 'copied-model');
    expect([...first.errors, ...second.errors]).toEqual([]);
  } finally {
    await first.close();
    await second.close();
  }
});

test('a file that a model refers to and that is missing is named, when it is copied', async () => {
  const open = await openEditor(chromium.browser, withFiles());
  try {
    await open.editor.settled();
    await rm(join(open.project, 'assets', 'shapes', 'paint on wood.png'));
    await open.editor.node('model').locator('.node-title').click();
    await open.page.keyboard.press('Control+c');
    await open.page.getByText('tile.gltf is incomplete. It refers to “paint on wood.png”, which is missing.').waitFor();
  } finally {
    await open.close();
  }
});

test('a model is chosen with all its files, and refused without them', async () => {
  const open = await openEditor(chromium.browser, { ...GRAPH, assets: {} });
  try {
    const { page, editor } = open;
    await editor.node('model').locator('.node-title').click();
    const chosen = (names: readonly string[]) =>
      editor.inspector
        .getByLabel('Import for Model')
        .setInputFiles(names.map((name) => ({ name, mimeType: '', buffer: Buffer.from(files[name] ?? []) })));
    await chosen(['tile.gltf']);
    await page.getByText('tile.gltf is incomplete. It refers to “tile.bin” and “paint on wood.png”, which are missing.').waitFor();
    await chosen(Object.keys(files));
    await eventually(async () =>
      expect(await editor.inspector.locator('.asset-picker').getByRole('combobox').textContent()).toBe('tile.glb'),
    );
    await access(join(open.project, 'assets', 'tile.glb'));
    await editor.settled();
    await page.locator('.status-bar').getByText('No problems').waitFor();

    // The panel of assets lists it, goes to its node, and a drag of its row adds another.
    await page.keyboard.press('Escape');
    await page.keyboard.press('Shift+R');
    const row = page.getByRole('table', { name: 'Assets' }).getByRole('row', { name: /tile\.glb/ });
    await row.getByText(/^\d+(\.\d)? k?B$/).waitFor();
    for (const colorScheme of ['dark', 'light'] as const) {
      await page.emulateMedia({ colorScheme, reducedMotion: 'reduce' });
      expect([colorScheme, await axeFindings(page)]).toEqual([colorScheme, []]);
    }
    await row.getByRole('button', { name: 'Go to 1 node with tile.glb' }).click();
    await editor.inspector.getByLabel('Import for Model').waitFor({ state: 'attached' });
    const { x, y } = await editor.emptyPlace();
    const canvas = await page.locator('.canvas').boundingBox();
    await row
      .locator('.asset-file')
      .dragTo(page.locator('.canvas'), { targetPosition: { x: x - (canvas?.x ?? 0), y: y - (canvas?.y ?? 0) } });
    await row.getByRole('button', { name: 'Go to 2 nodes with tile.glb' }).waitFor();
  } finally {
    await open.close();
  }
});

test('an animation of a model is chosen from a list, which shows each on the picture', async () => {
  const open = await openEditor(chromium.browser, withFiles(await looseModel({ large: 1, small: 0.4 })));
  try {
    const { page, editor } = open;
    const large = await editor.rewind();
    await editor.node('model').locator('.node-title').click();
    const picker = editor.inspector.getByRole('combobox', { name: 'Animation', exact: true });
    await eventually(async () => expect(await picker.textContent()).toBe('First: large'));
    await picker.click();
    const options = page.getByRole('listbox', { name: 'Animation' }).getByRole('option');
    expect(await options.allTextContents()).toEqual(['First: large', 'None', 'large', 'small']);
    await options.getByText('small').hover();
    const small = await editor.imageOtherThan(large);
    // The floor has the color of the tile, too.
    expect(orangePixels(small)).toBeLessThan(0.75 * orangePixels(large));
    await page.keyboard.press('Escape');
    await editor.imageSameAs(large, 'animation-restored');
    await picker.click();
    await options.getByText('small').click();
    await editor.imageSameAs(small, 'animation-chosen');
    expect(await picker.textContent()).toBe('small');
    await page.keyboard.press('Control+z');
    await eventually(async () => expect(await picker.textContent()).toBe('First: large'));
    expect(open.errors).toEqual([]);
  } finally {
    await open.close();
  }
});
