import { beforeAll, describe, expect, test } from '@jest/globals';
import type { Locator } from 'playwright-core';
import { centerOf } from '../../tools/lib/center-of.ts';
import { axeFindings } from '../support/axe.ts';
import { type GraphText, saveGraphs, useOneEditor } from '../support/open-editor.ts';
import { eventually } from '../support/patience.ts';

/** The camera's picture goes to the screen; a sepia stands by. */
const GRAPH: GraphText = {
  nodes: {
    'video-aaaa': { type: 'source/camera-video' },
    'sepia-aaaa': { type: 'filter/sepia' },
    'screen-aaaa': { type: 'output/screen' },
  },
  wires: ['video-aaaa.layer -> screen-aaaa.layer'],
  places: { 'video-aaaa': [0, 0], 'sepia-aaaa': [0, 200], 'screen-aaaa': [300, 0] },
};
const SIZE = { width: 1024, height: 768 };

const open = useOneEditor(GRAPH, { size: SIZE, colorScheme: 'dark' }, async () => {
  await open.editor.hold();
});

const title = (node: string) => open.editor.node(node).locator('.node-title');

async function boxOf(locator: Locator) {
  const box = await locator.boundingBox();
  if (!box) throw new Error('It is not there.');
  return box;
}

async function expectInWindow(locator: Locator): Promise<void> {
  const { x, y, width, height } = await boxOf(locator);
  expect([x >= 0, y >= 0, x + width <= SIZE.width + 0.5, y + height <= SIZE.height + 0.5]).toEqual([true, true, true, true]);
}

/** What the window is drawn at, percent. */
const scaleNow = (): Promise<number> =>
  open.page.evaluate(() => Math.round(Number(document.documentElement.style.getPropertyValue('--ui-scale') || 1) * 100));

/** By the View menu, as often as it takes. */
async function setScale(percent: number, item: 'Increase' | 'Decrease'): Promise<void> {
  const { page } = open;
  for (let before = await scaleNow(); before !== percent; before = await scaleNow()) {
    expect(Math.sign(percent - before)).toBe(item === 'Increase' ? 1 : -1);
    await page.getByRole('button', { name: 'View', exact: true }).click();
    await expectInWindow(page.getByRole('menu', { name: 'View' }));
    await page.getByRole('menuitem', { name: `${item} UI scale` }).click();
    await eventually(async () => expect(await scaleNow()).not.toBe(before));
  }
}

test('text and controls grow by the View menu, nodes and panels with them, and are as large in the next window', async () => {
  const { page, editor } = open;
  const file = page.getByRole('button', { name: 'File', exact: true });
  const [menuBefore, nodeBefore, asideBefore] = [await boxOf(file), await boxOf(title('sepia')), await boxOf(editor.inspector)];
  await setScale(125, 'Increase');
  await page.getByRole('log').getByText('UI scale: 125 %.').waitFor();
  const [menu, aside] = [await boxOf(file), await boxOf(editor.inspector)];
  expect(menu.height / menuBefore.height).toBeCloseTo(1.25, 1);
  expect(aside.width / asideBefore.width).toBeCloseTo(1.25, 1);
  await eventually(async () => expect((await boxOf(title('sepia'))).height / nodeBefore.height).toBeCloseTo(1.25, 1));
  await page.reload();
  await page.locator('.react-flow__node').first().waitFor();
  expect((await boxOf(file)).height).toBeCloseTo(menu.height, 0);
  await editor.hold();
});

describe.each([
  [125, 'Increase'],
  [150, 'Increase'],
  [80, 'Decrease'],
] as const)('at %d %%', (percent, item) => {
  beforeAll(async () => {
    await setScale(percent, item);
    await open.page.getByRole('button', { name: 'Fit graph to view' }).click();
  });

  test('the top bar has all its buttons inside the window, also with unsaved changes', async () => {
    const { page } = open;
    await title('sepia').click();
    await page.keyboard.press('Delete');
    await page.locator('.top-bar').getByText('Not saved').waitFor({ state: 'attached' });
    for (const button of await page.locator('.top-bar').getByRole('button').all()) await expectInWindow(button);
    await page.keyboard.press('Control+z');
  });

  test('a node goes where the pointer drags it', async () => {
    const { page, editor } = open;
    const from = await centerOf(title('sepia'));
    const offset = await boxOf(editor.node('sepia'));
    await page.mouse.move(from.x, from.y);
    await page.mouse.down();
    await page.mouse.move(from.x + 4, from.y, { steps: 4 });
    await page.mouse.move(from.x + 124, from.y + 60, { steps: 6 });
    await page.mouse.up();
    // On a grid of 8 units.
    await eventually(async () => {
      const { x, y } = await boxOf(editor.node('sepia'));
      expect(Math.hypot(x - offset.x - 122, y - offset.y - 60)).toBeLessThan(14);
    });
    await page.keyboard.press('Control+z');
    await eventually(async () => expect((await boxOf(editor.node('sepia'))).x).toBeCloseTo(offset.x, 0));
  });

  test('a wire goes from the port that is pressed to the one it is let go at', async () => {
    const { page, editor } = open;
    await editor.wire(['video-aaaa', 'layer'], ['sepia-aaaa', 'inputImage']);
    await page.getByRole('group', { name: 'Wire from Camera video to Sepia' }).waitFor();
    await page.keyboard.press('Control+z');
    await page.getByRole('group', { name: 'Wire from Camera video to Sepia' }).waitFor({ state: 'detached' });
  });

  test('a box around nodes selects those, and a press beside them none', async () => {
    const { page, editor } = open;
    const [video, sepia] = [await boxOf(editor.node('video')), await boxOf(editor.node('sepia'))];
    await editor.drag({ x: video.x - 12, y: video.y - 12 }, { x: sepia.x + sepia.width + 6, y: sepia.y + sepia.height + 6 });
    await page.getByRole('heading', { name: '2 nodes' }).waitFor();
    await page.mouse.click(sepia.x + sepia.width + 30, sepia.y + sepia.height + 30);
    await editor.inspector.getByRole('heading', { name: 'Project', exact: true }).waitFor();
  });

  test('menus, the palette and hints lie where they were asked for, inside the window', async () => {
    const { page, editor } = open;
    const at = await centerOf(title('video'));
    await page.mouse.click(at.x, at.y, { button: 'right' });
    const menu = page.getByRole('menu', { name: 'Actions' });
    const { x, y } = await boxOf(menu);
    expect(Math.abs(x - at.x)).toBeLessThan(2);
    expect(y).toBeLessThan(at.y + 2);
    await expectInWindow(menu);
    await page.keyboard.press('Escape');

    const empty = await editor.emptyPlace();
    const before = await boxOf(editor.node('video'));
    await page.mouse.dblclick(empty.x, empty.y);
    const palette = page.getByRole('dialog', { name: 'Add a node' });
    await palette.waitFor();
    await expectInWindow(palette);
    await page.getByRole('combobox', { name: 'Search nodes' }).fill('pixelate');
    await page.keyboard.press('Enter');
    const added = await boxOf(editor.node('pixelate'));
    // The canvas moves if the node is not all in it.
    const movedPx = (await boxOf(editor.node('video'))).x - before.x;
    expect(Math.abs(added.x + added.width / 2 - empty.x - movedPx)).toBeLessThan(14);
    await page.keyboard.press('Control+z');

    await title('sepia').click();
    const more = editor.inspector.getByRole('button', { name: 'More actions for Amount' });
    await more.click();
    await expectInWindow(page.getByRole('menu', { name: 'Actions for Amount' }));
    await page.keyboard.press('Escape');
    const undo = page.getByRole('button', { name: 'Redo', exact: true });
    await page.mouse.move(10, 400);
    await undo.hover();
    const [tip, button] = [await boxOf(page.locator('.tooltip')), await boxOf(undo)];
    expect(Math.abs(tip.x + tip.width / 2 - (button.x + button.width / 2))).toBeLessThan(3);
    expect(tip.y - button.y - button.height).toBeLessThan(12);
  });

  test('sliders, handles between panes and the timeline follow the pointer', async () => {
    const { page, editor } = open;
    await title('sepia').click();
    const slider = editor.inspector.getByRole('slider', { name: 'Amount' });
    await slider.scrollIntoViewIfNeeded();
    const { x, y } = await centerOf(slider);
    await page.mouse.click(x, y);
    await eventually(async () =>
      expect(Number(await editor.inspector.getByRole('textbox', { name: 'Amount' }).inputValue())).toBeCloseTo(0.5, 1),
    );
    await page.keyboard.press('Control+z');

    const handle = page.getByRole('separator', { name: 'Width of preview and inspector' });
    // Beside the preview, because it meets the handle below the preview farther down.
    const from = { x: (await centerOf(handle)).x, y: (await boxOf(handle)).y + 60 };
    await editor.drag(from, { x: from.x - 60, y: from.y });
    await eventually(async () => expect(Math.abs((await centerOf(handle)).x - from.x + 60)).toBeLessThan(2));
    await editor.drag({ x: from.x - 60, y: from.y }, from);

    await title('sepia').click();
    await page.keyboard.press('Shift+T');
    const ruler = await centerOf(page.locator('.timeline-ruler'));
    const { height } = await boxOf(page.locator('.timeline-ruler'));
    await page.mouse.click(ruler.x, ruler.y + height / 2 - 4);
    await eventually(async () => expect(Math.abs((await editor.frame()) - 18)).toBeLessThan(2));
    await page.keyboard.press('Home');
    await page.getByRole('button', { name: 'Close the panel' }).click();
  });

  test('the text editor puts the caret where one clicks, in letters as large as the rest', async () => {
    const { page, editor } = open;
    await editor.openCode('sepia');
    const size = await page
      .locator('.monaco-editor .view-line')
      .first()
      .evaluate((line) => Number.parseFloat(getComputedStyle(line).fontSize));
    expect(size).toBeCloseTo((12.5 * percent) / 100, 1);
    const word = page.locator('.monaco-editor .view-line').filter({ hasText: 'ISFVSN' }).locator('span span').first();
    const at = await boxOf(word);
    await page.mouse.click(at.x + at.width - 2, at.y + at.height / 2);
    await eventually(async () => expect(await editor.lineText()).toContain('ISFVSN'));
    const caret = await boxOf(page.locator('.monaco-editor .cursor').first());
    expect(Math.abs(caret.x - at.x - at.width)).toBeLessThan(10);
    await page.getByRole('button', { name: 'Close the panel' }).click();
  });

  test('the preview has a pixel for each of the window’s, and is drawn sharp', async () => {
    const { page, editor } = open;
    await editor.settled();
    const { width, height } = await boxOf(page.locator('iframe[title="Preview"]'));
    await page
      .locator('.status-bar')
      .getByText(`${Math.round(width)} × ${Math.round(height)}`)
      .waitFor();
  });

  test('dialogs fit into the window, and axe finds nothing', async () => {
    const { page } = open;
    for (const [keys, name] of [
      ['Control+o', 'Open project'],
      ['Control+Alt+n', 'New project'],
      ['Control+Shift+E', 'Render frames'],
      ['Control+k', 'Commands'],
    ] as const) {
      await title('sepia').click();
      await page.keyboard.press(keys);
      const dialog = page.getByRole('dialog', { name });
      await dialog.waitFor();
      await expectInWindow(dialog);
      expect(await axeFindings(page)).toEqual([]);
      await page.keyboard.press('Escape');
      await dialog.waitFor({ state: 'detached' });
    }
  });
});

test('nothing of all that is in the project', async () => {
  const { main } = await saveGraphs(open);
  expect(main?.wires).toEqual(GRAPH.wires);
});
