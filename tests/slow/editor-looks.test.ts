import { expect, test } from '@jest/globals';
import { centerOf } from '../../tools/lib/center-of.ts';
import { axeFindings } from '../support/axe.ts';
import { chooseOption } from '../support/choose-option.ts';
import { FLAG_PX } from '../support/editor-driver.ts';
import { decodeImage, type RgbaImage } from '../support/image.ts';
import { type GraphText, useOneEditor } from '../support/open-editor.ts';
import { eventually } from '../support/patience.ts';

/** The camera's image through two filters; another one has no input. */
const GRAPH: GraphText = {
  nodes: {
    'video-aaaa': { type: 'source/camera-video' },
    'sepia-aaaa': { type: 'filter/sepia' },
    'threshold-aaaa': { type: 'filter/threshold' },
    'screen-aaaa': { type: 'output/screen' },
    'sobel-aaaa': { type: 'filter/sobel-edges' },
  },
  wires: [
    'video-aaaa.layer -> sepia-aaaa.inputImage',
    'sepia-aaaa.layer -> threshold-aaaa.inputImage',
    'threshold-aaaa.layer -> screen-aaaa.layer',
  ],
  places: { 'video-aaaa': [0, 0], 'sepia-aaaa': [240, 0], 'threshold-aaaa': [480, 0], 'screen-aaaa': [720, 0], 'sobel-aaaa': [240, 260] },
};

const open = useOneEditor(GRAPH, { colorScheme: 'dark' }, async () => {
  await open.editor.settled();
  await open.editor.rewind();
});

/** How much of an image is gray, and how much warmer than blue the rest is. */
function tints({ width, height, data }: RgbaImage, from = 0, to = 1) {
  let gray = 0;
  let warm = 0;
  let count = 0;
  for (let y = 0; y < height; y++) {
    for (let x = Math.floor(from * width); x < to * width; x++) {
      const at = (y * width + x) * 4;
      const [r = 0, g = 0, b = 0] = [data[at], data[at + 1], data[at + 2]];
      count++;
      if (Math.max(r, g, b) - Math.min(r, g, b) < 6) gray++;
      if (r > b + 8 && r >= g && g >= b) warm++;
    }
  }
  return { gray: gray / count, warm: warm / count };
}

test('nodes show their layers, and only while somebody looks', async () => {
  const { page, editor } = open;
  await page.locator('.canvas').focus();
  await page.keyboard.press('t');
  for (const node of ['video', 'sepia', 'threshold']) {
    await page.waitForFunction(
      (stem) => (document.querySelector<HTMLCanvasElement>(`[data-node^="${stem}"] .node-thumbnail canvas`)?.width ?? 0) > 100,
      node,
    );
  }
  // Nothing comes in, so nothing comes out.
  expect(await editor.node('sobel').locator('canvas').getAttribute('width')).toBe('0');
  const pixels = await editor.node('sepia').locator('.node-thumbnail').screenshot();
  expect(tints(decodeImage(pixels), 0.1, 0.9).warm).toBeGreaterThan(0.8);
  await page.keyboard.press('t');
  await page.locator('.node-thumbnail').first().waitFor({ state: 'detached' });
});

test('the preview shows any layer, and wipes between two', async () => {
  const { page, editor } = open;
  const screen = await editor.restingImage();
  expect(tints(screen).gray).toBeGreaterThan(0.95);
  await editor.node('sepia').locator('.node-title').click();
  await page.keyboard.press('p');
  await page.locator('.look-pinned').getByText('Sepia').waitFor();
  const sepia = await editor.imageOtherThan(screen);
  expect(tints(sepia).warm).toBeGreaterThan(0.8);

  await editor.node('threshold').locator('.node-title').click({ button: 'right' });
  await page.getByRole('menuitem', { name: 'Compare in the preview' }).click();
  await page.locator('.look-pinned').getByText('Sepia | Threshold').waitFor();
  const both = await editor.imageOtherThan(sepia);
  expect(tints(both, 0, 0.47).warm).toBeGreaterThan(0.8);
  expect(tints(both, 0.53, 1).gray).toBeGreaterThan(0.95);

  const wipe = page.getByRole('slider', { name: 'Wipe between the two layers' });
  const at = await centerOf(wipe);
  await editor.drag({ x: at.x, y: at.y - 60 }, { x: at.x - 100, y: at.y - 60 });
  await page.keyboard.press('ArrowLeft');
  expect(Number(await wipe.getAttribute('aria-valuenow'))).toBeLessThan(30);
  const moved = await editor.imageOtherThan(both);
  expect(tints(moved, 0.33, 1).gray).toBeGreaterThan(0.95);

  await page.getByRole('button', { name: 'Show output' }).click();
  await editor.imageSameAs(screen, 'screen-again');
});

test('a port’s menu shows the layer at it: what an output gives, and what comes in at an input', async () => {
  const { page, editor } = open;
  const label = page.locator('.look-pinned');
  await editor.port('threshold-aaaa', 'inputImage', 'target').click({ button: 'right' });
  await page.getByRole('menuitem', { name: 'View “Sepia”' }).click();
  await label.getByText('Sepia', { exact: true }).waitFor();
  // Two layers of one node, which is a subgraph: the port that is pressed is meant.
  await editor.node('video').locator('.node-title').click();
  await editor
    .node('sepia')
    .locator('.node-title')
    .click({ modifiers: ['Shift'] });
  await editor.wire(['video-aaaa', 'layer'], ['sobel-aaaa', 'inputImage']);
  await page.keyboard.press('Control+g');
  const subgraph = await editor.nodeId('subgraph');
  const outputs = page.locator(`.react-flow__handle.source[data-nodeid="${subgraph}"]`);
  await eventually(async () => expect(await outputs.count()).toBe(2));
  const shown: RgbaImage[] = [];
  for (const output of await outputs.all()) {
    await output.click({ button: 'right' });
    await page.getByRole('menuitem', { name: /^View “Subgraph · .*”/ }).click();
    await label.getByText(/^Subgraph · /).waitFor();
    await editor.settled();
    shown.push(await editor.restingImage());
  }
  const warm = shown.map((picture) => tints(picture).warm > 0.8);
  expect(warm.filter(Boolean)).toHaveLength(1);
  await page.getByRole('button', { name: 'Show output' }).click();
  for (let step = 0; step < 2; step++) await page.keyboard.press('Control+z');
  await editor.node('video').waitFor();
});

test('the probe tells color, distance and place of what is under the pointer', async () => {
  const { page, editor } = open;
  const picture = await editor.restingImage();
  await page.getByRole('button', { name: 'Pixel probe' }).click();
  const frame = await page.locator('iframe[title="Preview"]').boundingBox();
  if (!frame) throw new Error('There is no preview.');
  const at = { x: Math.round(frame.width * 0.62), y: Math.round(frame.height * 0.55) };
  const output = page.getByRole('status', { name: 'Pixel under the pointer' });
  await editor.moveOverPreview(frame.x + at.x + 0.5, frame.y + at.y + 0.5, output);
  const index = ((at.y - FLAG_PX) * picture.width + at.x) * 4;
  const shown = [...picture.data.slice(index, index + 3)].join(' ');
  await output.getByText(shown).waitFor();
  const text = (await output.textContent()) ?? '';
  const meters = Number(/(\d+\.\d+) m, the room/.exec(text)?.[1]);
  expect(meters).toBeGreaterThan(0.5);
  expect(meters).toBeLessThan(8);
  // The floor is at 0, and a hand above it the table and what stands on it.
  const height = Number(/y (-?\d+\.\d+)/.exec(text)?.[1]);
  expect(height).toBeGreaterThan(-0.1);
  expect(height).toBeLessThan(2.6);
  await page.getByRole('button', { name: 'Pixel probe' }).click();
  await output.waitFor({ state: 'detached' });
});

test('what nodes cost is drawn on them, with a budget that warns', async () => {
  const { page, editor } = open;
  await page.locator('.canvas').focus();
  await page.keyboard.press('k');
  const panel = page.getByRole('region', { name: 'Performance' });
  await panel.waitFor();
  await editor.node('sepia').locator('.node-cost').getByText('1 pass · 9.9 MB').waitFor();
  await editor
    .node('threshold')
    .locator('.node-cost')
    .getByText(/^1 pass( ·.* ms)?$/)
    .waitFor();
  // Each draws one triangle; the background is no node's.
  await panel.getByText(/^2 of 300$/).waitFor();
  await chooseOption(panel.getByRole('combobox', { name: 'Target device' }), 'headset');
  await panel.getByText(/^4 of 4$/).waitFor();
  await page.locator('.canvas').focus();
  await page.keyboard.press('k');
  await panel.waitFor({ state: 'detached' });
});

test('axe-core finds nothing wrong with any of it, in both themes', async () => {
  const { page, editor } = open;
  await editor.node('threshold').locator('.node-title').click();
  for (const key of ['t', 'k', 'Shift+P']) await page.keyboard.press(key);
  await page.getByRole('slider', { name: 'Wipe between the two layers' }).waitFor();
  await page.getByRole('button', { name: 'Preview options' }).click();
  await page.getByRole('menuitemradio', { name: 'Render size: 720p' }).waitFor();
  for (const colorScheme of ['dark', 'light'] as const) {
    await page.emulateMedia({ colorScheme, reducedMotion: 'reduce' });
    expect(await axeFindings(page)).toEqual([]);
  }
});
