import { readFile } from 'node:fs/promises';
import { join } from 'node:path';
import { expect, test } from '@jest/globals';
import { FLAG_PX } from '../support/editor-driver.ts';
import type { RgbaImage } from '../support/image.ts';
import { type GraphText, saveGraphs, useOneEditor } from '../support/open-editor.ts';
import { eventually } from '../support/patience.ts';

const SHADER = `/*{
  "ISFVSN": "2",
  "INPUTS": [
    { "NAME": "inputImage", "TYPE": "image" },
    { "NAME": "tint", "TYPE": "color", "DEFAULT": [1, 0, 0, 0.5] }
  ]
}*/
void main() { gl_FragColor = IMG_THIS_PIXEL(inputImage) * tint; }
`;

/** The camera image with a half transparent tint, and a shader with such a color. */
const GRAPH: GraphText = {
  nodes: {
    'video-aaaa': { type: 'source/camera-video' },
    'color-aaaa': { type: 'value/color', params: { value: [1, 0, 0, 0.5] } },
    'screen-aaaa': { type: 'output/screen' },
    'own-aaaa': { type: 'filter/own' },
  },
  wires: ['video-aaaa.layer -> screen-aaaa.layer'],
  places: { 'video-aaaa': [0, 0], 'color-aaaa': [0, 200], 'screen-aaaa': [300, 0], 'own-aaaa': [300, 200] },
  shaders: { 'own.fs': SHADER },
};

let picture: RgbaImage;
const open = useOneEditor(GRAPH, { colorScheme: 'dark' }, async () => {
  await open.editor.settled();
  picture = await open.editor.rewind();
  await open.editor.node('color').locator('.node-title').click();
});

const button = () => open.editor.inspector.getByRole('button', { name: /pick from the preview/ });
const eyedropper = () => open.page.getByRole('application', { name: /pick a color from the preview/ });
const shown = () => open.page.getByRole('status', { name: 'Color to pick' });

/** Of the preview's image, in points from its top left. */
function colorAt(x: number, y: number): readonly number[] {
  const index = ((y - FLAG_PX) * picture.width + x) * 4;
  return [...picture.data.slice(index, index + 3)];
}

/** In points from the preview's top left, where the image changes most from one pixel to the next. */
async function edgePoint(): Promise<{ readonly x: number; readonly y: number }> {
  let best = { x: 0, y: 0, change: -1 };
  for (let y = FLAG_PX + 60; y < picture.height - 20; y += 7) {
    for (let x = 140; x < picture.width - 140; x += 3) {
      const [here, there] = [colorAt(x, y), colorAt(x + 1, y)];
      const change = here.reduce((sum, part, i) => sum + Math.abs(part - (there[i] ?? 0)), 0);
      if (change > best.change) best = { x, y, change };
    }
  }
  return best;
}

async function savedColor(): Promise<unknown> {
  const graphs = await saveGraphs(open);
  return graphs.main?.nodes['color-aaaa']?.params?.value;
}

test('a click takes the color of the pixel that is shown large, as one step, and the preview does not see it', async () => {
  const { page, editor } = open;
  const frame = await page.locator('iframe[title="Preview"]').boundingBox();
  if (!frame) throw new Error('There is no preview.');
  const { x, y } = await edgePoint();
  const [r = 0, g = 0, b = 0] = colorAt(x, y);
  await button().click();
  await editor.moveOverPreview(frame.x + x + 0.5, frame.y + y + 0.5, shown().getByText(`${r} ${g} ${b}`, { exact: true }));
  // The pixel beside it is another one, and stands beside it in the magnifier.
  const middle = await page.locator('.loupe canvas').evaluate((canvas) => {
    const pixels = (canvas as HTMLCanvasElement).getContext('2d')?.getImageData(5, 5, 2, 1).data ?? [];
    return [...pixels];
  });
  expect(middle).toEqual([r, g, b, 255, ...colorAt(x + 1, y), 255]);
  await page.mouse.down();
  await page.mouse.up();
  await eyedropper().waitFor({ state: 'detached' });
  await eventually(async () => expect(await button().evaluate((button) => button === document.activeElement)).toBe(true));
  // The opacity is the param's own.
  expect(await savedColor()).toEqual([r / 255, g / 255, b / 255, 0.5]);
  await editor.node('color').locator('.node-title').click();
  await page.keyboard.press('Control+z');
  expect(await savedColor()).toEqual([1, 0, 0, 0.5]);
});

test('by keys: arrows go from pixel to pixel, Enter takes, and Escape leaves all as it was', async () => {
  const { page } = open;
  await button().focus();
  await page.keyboard.press('Enter');
  await eyedropper().waitFor();
  const middle = [Math.floor(picture.width / 2), Math.floor((picture.height + FLAG_PX) / 2)] as const;
  const expectShown = async (dx: number, dy: number) =>
    shown()
      .getByText(colorAt(middle[0] + dx, middle[1] + dy).join(' '), { exact: true })
      .waitFor();
  await expectShown(0, 0);
  for (const key of ['Shift+ArrowRight', 'Shift+ArrowRight', 'ArrowLeft', 'Shift+ArrowUp', 'ArrowDown']) await page.keyboard.press(key);
  await expectShown(19, -9);
  await page.keyboard.press('Escape');
  await eyedropper().waitFor({ state: 'detached' });
  expect(await savedColor()).toEqual([1, 0, 0, 0.5]);

  await button().focus();
  await page.keyboard.press('Enter');
  await expectShown(0, 0);
  await page.keyboard.press('Shift+ArrowDown');
  await expectShown(0, 10);
  await page.keyboard.press('Enter');
  await eyedropper().waitFor({ state: 'detached' });
  expect(await savedColor()).toEqual([...colorAt(middle[0], middle[1] + 10).map((part) => part / 255), 0.5]);
});

test('pressed again it ends, and so it does when another node is selected', async () => {
  const { editor } = open;
  await button().click();
  await eyedropper().waitFor();
  await button().click();
  await eyedropper().waitFor({ state: 'detached' });
  await button().click();
  await eyedropper().waitFor();
  await editor.node('video').locator('.node-title').click();
  await eyedropper().waitFor({ state: 'detached' });
});

test('a color of a shader’s header takes one, too, as one step', async () => {
  const { page, editor, project } = open;
  await editor.openCode('own');
  await editor.press('Header form');
  const form = page.getByRole('region', { name: 'Header' });
  await form.getByRole('button', { name: /^tint/ }).click();
  await form.getByRole('button', { name: 'Default of tint: pick from the preview' }).click();
  const frame = await page.locator('iframe[title="Preview"]').boundingBox();
  if (!frame) throw new Error('There is no preview.');
  const { x, y } = await edgePoint();
  const color = colorAt(x, y);
  const [r = 0, g = 0, b = 0] = color.map((part) => Number((part / 255).toFixed(4)));
  await editor.moveOverPreview(frame.x + x + 0.5, frame.y + y + 0.5, shown().getByText(color.join(' '), { exact: true }));
  await page.mouse.click(frame.x + x + 0.5, frame.y + y + 0.5);
  await eyedropper().waitFor({ state: 'detached' });
  const shader = async () => {
    await saveGraphs(open);
    return readFile(join(project, 'shaders/own.fs'), 'utf8');
  };
  expect(await shader()).toContain(`"DEFAULT": [${r}, ${g}, ${b}, 0.5]`);
  await editor.node('own').locator('.node-title').click();
  await page.keyboard.press('Control+z');
  expect(await shader()).toBe(SHADER);
});
