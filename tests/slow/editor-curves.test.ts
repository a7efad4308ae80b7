import { expect, test } from '@jest/globals';
import type { Locator } from 'playwright-core';
import { centerOf, type Point } from '../../tools/lib/center-of.ts';
import { testThemes } from '../support/axe-themes.ts';
import { Hand } from '../support/hand.ts';
import type { RgbaImage } from '../support/image.ts';
import { type GraphText, saveGraphs, useOneEditor } from '../support/open-editor.ts';
import { expectSamePixels } from '../support/pixels.ts';

/** What the camera sees, by curves. */
const GRAPH: GraphText = {
  nodes: {
    'video-aaaa': { type: 'source/camera-video' },
    'curves-aaaa': { type: 'filter/curves' },
    'screen-aaaa': { type: 'output/screen' },
  },
  wires: ['video-aaaa.layer -> curves-aaaa.inputImage', 'curves-aaaa.layer -> screen-aaaa.layer'],
  places: { 'video-aaaa': [0, 0], 'curves-aaaa': [260, 0], 'screen-aaaa': [520, 0] },
};

/** As it was before any curve was touched. */
let plain: RgbaImage;
const open = useOneEditor(GRAPH, { colorScheme: 'dark', hasTouch: true }, async () => {
  await open.editor.settled();
  plain = await open.editor.rewind();
  await open.editor.node('curves').locator('.node-title').click();
  await strip('All channels').click();
});

const strip = (curve: string): Locator => open.page.getByRole('button', { name: `Edit the curve ${curve}` });
const row = (curve: string): Locator => open.editor.inspector.getByRole('group', { name: curve, exact: true });
const points = (curve = 'All channels'): Locator => row(curve).getByRole('slider');
const point = (number: number): Locator => points().nth(number - 1);

/** In the opened square, from (0, 0) at the bottom left to (1, 1). */
async function place(x: number, y: number): Promise<Point> {
  const square = open.page.locator('.curve-square');
  await square.scrollIntoViewIfNeeded();
  const box = await square.boundingBox();
  if (!box) throw new Error('No curve is open.');
  return { x: box.x + x * box.width, y: box.y + (1 - y) * box.height };
}

async function saved(param = 'all'): Promise<unknown> {
  return (await saveGraphs(open)).main?.nodes['curves-aaaa']?.params?.[param];
}

/** To two digits: where in a pixel a press lands is the machine's. */
async function savedRoughly(): Promise<unknown> {
  return ((await saved()) as readonly number[]).map((number) => Math.round(number * 50) / 50);
}

async function undo(times = 1): Promise<void> {
  await open.editor.node('screen').locator('.node-title').hover();
  for (let i = 0; i < times; i++) await open.page.keyboard.press('Control+z');
}

test('ends that are dragged to the other corners make a negative, while they are dragged; each is one step', async () => {
  const { page, editor } = open;
  await editor.drag(await centerOf(point(1)), await place(-0.05, 1.05));
  const white = await editor.imageOtherThan(plain);
  const [from, to] = [await centerOf(point(2)), await place(1.05, -0.05)];
  await page.mouse.move(from.x, from.y);
  await page.mouse.down();
  await page.mouse.move(to.x, (from.y + to.y) / 2);
  await page.mouse.move(to.x, to.y);
  // Not let go yet.
  const negative = await editor.imageOtherThan(white);
  const expected = { ...plain, data: plain.data.map((value, i) => (i % 4 === 3 ? value : 255 - value)) };
  await expectSamePixels('negative', negative, expected, { tolerance: 2 });
  await page.mouse.up();
  expect(await saved()).toEqual([0, 1, 1, 0]);
  await undo();
  await editor.imageSameAs(white, 'half undone');
  await undo();
  await editor.imageSameAs(plain, 'undone');
  expect(await saved()).toBeUndefined();
});

test('a press on the line adds a point and takes it along; a press beside it does nothing', async () => {
  const { page, editor } = open;
  const beside = await place(0.75, 0.25);
  await page.mouse.click(beside.x, beside.y);
  expect(await points().count()).toBe(2);
  await editor.drag(await place(0.5, 0.5), await place(0.4, 0.8));
  expect(await savedRoughly()).toEqual([0, 0, 0.4, 0.8, 1, 1]);
  await editor.imageOtherThan(plain);
  // It has the keyboard, and its numbers stand below.
  expect(await point(2).evaluate((element) => element === document.activeElement)).toBe(true);
  const height = row('All channels').getByRole('textbox', { name: 'Height of point 2 of All channels' });
  expect(Number(await height.inputValue())).toBeCloseTo(0.8, 1);
  // Escape gives a drag up.
  const [from, to] = [await centerOf(point(2)), await place(0.6, 0.3)];
  await page.mouse.move(from.x, from.y);
  await page.mouse.down();
  await page.mouse.move(to.x, to.y);
  expect(Number(await height.inputValue())).toBeCloseTo(0.3, 1);
  await page.keyboard.press('Escape');
  await page.mouse.up();
  expect(await savedRoughly()).toEqual([0, 0, 0.4, 0.8, 1, 1]);
  // Neighbors are not passed.
  await editor.drag(await centerOf(point(2)), await place(1.05, 0.5));
  expect(((await saved()) as readonly number[])[2]).toBe(0.999);
  await undo(2);
  await editor.imageSameAs(plain, 'the point undone');
  expect(await points().count()).toBe(2);
});

test('a point goes by a double-click, by Delete, and with the pointer out of the square; the last two stay', async () => {
  const { page } = open;
  const click = async (at: Point, clickCount = 1) => page.mouse.click(at.x, at.y, { clickCount });
  for (const x of [0.3, 0.5, 0.7]) await click(await place(x, x));
  expect(await points().count()).toBe(5);
  await click(await centerOf(point(3)), 2);
  expect(await points().count()).toBe(4);
  await page.keyboard.press('Delete');
  expect(await points().count()).toBe(3);
  // Out and back in is where it was, out and let go is gone.
  const at = await centerOf(point(2));
  const outside = await place(0.5, 1.4);
  await page.mouse.move(at.x, at.y);
  await page.mouse.down();
  await page.mouse.move(outside.x, outside.y);
  expect(await points().count()).toBe(2);
  await page.mouse.move(at.x, at.y);
  expect(await points().count()).toBe(3);
  await page.mouse.move(outside.x, outside.y);
  await page.mouse.up();
  expect(await points().count()).toBe(2);
  for (const key of ['Delete', 'Backspace']) await point(2).press(key);
  expect(await points().count()).toBe(2);
  // Three presses, a double-click, a key and a drag.
  await undo(6);
  expect(await saved()).toBeUndefined();
});

test('by keys: a point is added, moved, set by numbers and taken away', async () => {
  const { page } = open;
  const add = row('All channels').getByRole('button', { name: 'Add a point' });
  await add.press('Enter');
  expect(await saved()).toEqual([0, 0, 0.5, 0.5, 1, 1]);
  await point(2).focus();
  for (const key of ['ArrowUp', 'ArrowUp', 'Shift+ArrowRight', 'Alt+ArrowLeft']) await page.keyboard.press(key);
  expect(await saved()).toEqual([0, 0, 0.599, 0.52, 1, 1]);
  expect(await point(2).getAttribute('aria-valuetext')).toBe('0.599 across, 0.52 up');
  await row('All channels').getByRole('textbox', { name: 'Place of point 2 of All channels' }).fill('0.25');
  await page.keyboard.press('Enter');
  expect(await saved()).toEqual([0, 0, 0.25, 0.52, 1, 1]);
  for (let i = 0; i < 9; i++) if (await add.isEnabled()) await add.press('Enter');
  expect(await points().count()).toBe(8);
  await row('All channels').getByRole('button', { name: 'Remove the point' }).press('Enter');
  expect(await points().count()).toBe(7);
});

test('a curve is copied to another, and reset', async () => {
  const { page, editor } = open;
  await page.context().grantPermissions(['clipboard-read', 'clipboard-write']);
  const curve = await saved();
  const choose = async (label: string, action: string) => {
    await row(label)
      .getByRole('button', { name: `More actions for ${label}` })
      .click();
    await page.getByRole('menuitem', { name: action, exact: true }).click();
  };
  await choose('All channels', 'Copy value');
  await choose('Red', 'Paste value');
  await row('Red').getByRole('button', { name: 'Reset Red' }).waitFor();
  expect(await saved('red')).toEqual(curve);
  // Nothing that a curve cannot do is offered.
  await row('Red').getByRole('button', { name: 'More actions for Red' }).click();
  expect(await page.getByRole('menuitem').allTextContents()).toEqual(['Copy value', 'Paste value', 'Reset']);
  await page.keyboard.press('Escape');
  for (const label of ['All channels', 'Red'])
    await row(label)
      .getByRole('button', { name: `Reset ${label}` })
      .click();
  expect([await saved(), await saved('red')]).toEqual([undefined, undefined]);
  await editor.imageSameAs(plain, 'reset');
  // A number is no curve.
  await page.evaluate(() => navigator.clipboard.writeText('[0.5, 0.5]'));
  await choose('Red', 'Paste value');
  await page.getByRole('log').getByText('The value on the clipboard does not fit “Red”.').waitFor();
});

test('a finger adds points and drags them, and needs not be exact', async () => {
  const { page } = open;
  const hand = await Hand.on(page);
  const [on, to] = [await place(0.5, 0.56), await place(0.5, 0.86)];
  await hand.drag(on, to);
  expect(await savedRoughly()).toEqual([0, 0, 0.5, 0.8, 1, 1]);
  const near = await centerOf(point(2));
  await hand.drag({ x: near.x + 14, y: near.y }, { x: near.x - 30, y: near.y });
  const [, , x = 0] = (await saved()) as readonly number[];
  expect(x).toBeLessThan(0.4);
  await undo(2);
  expect(await saved()).toBeUndefined();
});

testThemes(open);
