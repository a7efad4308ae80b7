import { expect, test } from '@jest/globals';
import type { Locator } from 'playwright-core';
import { centerOf, type Point } from '../../tools/lib/center-of.ts';
import { testThemes } from '../support/axe-themes.ts';
import type { RgbaImage } from '../support/image.ts';
import { type GraphText, saveGraphs, useOneEditor } from '../support/open-editor.ts';

const BLACK_TO_WHITE = [0, 0, 0, 0, 1, 0, 1, 1, 1, 1, 1, 0];

/** What the camera sees, in grays. */
const GRAPH: GraphText = {
  nodes: {
    'video-aaaa': { type: 'source/camera-video' },
    'map-aaaa': { type: 'filter/gradient-map', params: { gradient: BLACK_TO_WHITE } },
    'map-bbbb': { type: 'filter/gradient-map', params: { amount: 0 } },
    'screen-aaaa': { type: 'output/screen' },
  },
  wires: ['video-aaaa.layer -> map-aaaa.inputImage', 'map-aaaa.layer -> map-bbbb.inputImage', 'map-bbbb.layer -> screen-aaaa.layer'],
  places: { 'video-aaaa': [0, 0], 'map-aaaa': [260, 0], 'map-bbbb': [520, 0], 'screen-aaaa': [780, 0] },
};

/** As it was before any stop was touched. */
let plain: RgbaImage;
const open = useOneEditor(GRAPH, { colorScheme: 'dark' }, async () => {
  await open.editor.settled();
  plain = await open.editor.rewind();
  await open.editor.node('map-aaaa').locator('.node-title').click();
});

const row = (): Locator => open.editor.inspector.getByRole('group', { name: 'Gradient', exact: true });
const stops = (): Locator => row().getByRole('slider', { name: /^Gradient, stop/ });
const stop = (number: number): Locator => stops().nth(number - 1);

/** A point of the bar, `downPx` below the middle of its colors. */
async function place(position: number, downPx = 0): Promise<Point> {
  const bar = open.page.locator('.gradient-bar');
  await bar.scrollIntoViewIfNeeded();
  const box = await bar.boundingBox();
  if (!box) throw new Error('There is no gradient.');
  return { x: box.x + position * box.width, y: box.y + 10 + downPx };
}

async function saved(node = 'map-aaaa'): Promise<readonly number[] | undefined> {
  return (await saveGraphs(open)).main?.nodes[node]?.params?.gradient as readonly number[] | undefined;
}

async function savedPositions(): Promise<readonly number[]> {
  return ((await saved()) ?? []).filter((_, i) => i % 6 === 0).map((position) => Math.round(position * 20) / 20);
}

async function undo(times = 1): Promise<void> {
  await open.editor.node('screen').locator('.node-title').hover();
  for (let i = 0; i < times; i++) await open.page.keyboard.press('Control+z');
}

test('a press on the bar adds a stop and takes it along, and the image follows before it is let go', async () => {
  const { page, editor } = open;
  const [from, to] = [await place(0.5), await place(0.2)];
  await page.mouse.move(from.x, from.y);
  await page.mouse.down();
  await page.mouse.move(to.x, to.y);
  const bright = await editor.imageOtherThan(plain);
  await page.mouse.up();
  expect(await savedPositions()).toEqual([0, 0.2, 1]);
  // It has the keyboard; its color is the one that was there.
  expect(await stop(2).evaluate((element) => element === document.activeElement)).toBe(true);
  const hex = row().getByRole('textbox', { name: 'Color of stop 2 of Gradient, hexadecimal' });
  expect(await hex.inputValue()).toMatch(/^#(7f7f7f|808080|818181)$/);
  await hex.fill('#ff0000');
  await hex.press('Enter');
  // Control+Z in a text field is the field's own.
  await hex.blur();
  await editor.imageOtherThan(bright);
  // The color and the drag are a step each.
  await undo();
  await editor.imageSameAs(bright, 'the color undone');
  await undo();
  await editor.imageSameAs(plain, 'the stop undone');
  expect(await saved()).toEqual(BLACK_TO_WHITE);
});

test('a stop is dragged past another, and off the bar; the last two stay', async () => {
  const { page, editor } = open;
  await page.mouse.click((await place(0.4)).x, (await place(0.4)).y);
  await editor.drag(await centerOf(stop(1)), await place(0.7, 14));
  expect(await savedPositions()).toEqual([0.4, 0.7, 1]);
  // Off and back is where it was; off and let go is gone.
  const [at, off] = [await centerOf(stop(2)), await place(0.7, 80)];
  await page.mouse.move(at.x, at.y);
  await page.mouse.down();
  await page.mouse.move(off.x, off.y);
  expect(await stops().count()).toBe(2);
  await page.mouse.move(at.x, at.y);
  expect(await stops().count()).toBe(3);
  await page.keyboard.press('Escape');
  await page.mouse.up();
  expect(await savedPositions()).toEqual([0.4, 0.7, 1]);
  await editor.drag(at, off);
  expect(await savedPositions()).toEqual([0.4, 1]);
  await editor.drag(await centerOf(stop(1)), await place(0.4, 80));
  expect(await stops().count()).toBe(2);
  await undo(4);
  expect(await saved()).toEqual(BLACK_TO_WHITE);
});

test('by keys: a stop is added, moved, held, removed; the gradient is flipped and reset', async () => {
  const { page, editor } = open;
  await row().getByRole('button', { name: 'Add a stop' }).press('Enter');
  await stop(2).focus();
  for (const key of ['ArrowRight', 'Shift+ArrowRight', 'Alt+ArrowLeft']) await page.keyboard.press(key);
  expect(await stop(2).getAttribute('aria-valuetext')).toBe('0.609, #808080, Linear');
  await page.keyboard.press('Home');
  expect(await stop(2).evaluate((element) => element === document.activeElement)).toBe(true);
  await row().getByRole('combobox', { name: 'Interpolation after stop 2 of Gradient' }).click();
  await page.getByRole('option', { name: 'Hold' }).click();
  expect((await saved())?.slice(6, 12)).toEqual([0.001, 0.5, 0.5, 0.5, 1, 2]);
  await row().getByRole('button', { name: 'Flip the gradient' }).press('Enter');
  expect((await saved())?.slice(0, 7)).toEqual([0, 1, 1, 1, 1, 2, 0.999]);
  await stop(2).press('Delete');
  await stop(1).press('Delete');
  expect(await stops().count()).toBe(2);
  expect(await row().getAttribute('data-changed')).toBe('');
  await row().getByRole('button', { name: 'Reset Gradient' }).click();
  expect(await saved()).toBeUndefined();
  expect(await row().getAttribute('data-changed')).toBeNull();
  // The default of the node, in four colors.
  expect(await stops().count()).toBe(4);
  await editor.imageOtherThan(plain);
});

test('the gradients of two nodes are edited together', async () => {
  const { page, editor } = open;
  await editor
    .node('map-bbbb')
    .locator('.node-title')
    .click({ modifiers: ['Shift'] });
  await stop(1).focus();
  await page.keyboard.press('Delete');
  expect(await saved()).toHaveLength(18);
  expect(await saved('map-bbbb')).toEqual(await saved());
  await undo();
  expect([await saved(), await saved('map-bbbb')]).toEqual([undefined, undefined]);
  await editor.node('map-aaaa').locator('.node-title').click();
});

test('an option that the pointer or a key rests on is shown in the preview, and Escape restores the image', async () => {
  const { page, editor } = open;
  const before = await editor.restingImage();
  const choice = editor.inspector.getByRole('combobox', { name: 'Position from' });
  const undoIsOff = () => page.getByRole('button', { name: /^Undo/ }).isDisabled();
  const wasOff = await undoIsOff();
  await choice.click();
  await page.getByRole('option', { name: 'Blue' }).hover();
  const blue = await editor.imageOtherThan(before);
  await page.keyboard.press('Escape');
  await editor.imageSameAs(before, 'Escape');
  // A letter opens the list at what begins with it; arrows go on.
  await choice.press('g');
  await editor.imageOtherThan(before);
  expect(await page.getByRole('listbox').getByRole('option').count()).toBe(5);
  await page.keyboard.press('ArrowDown');
  await editor.imageSameAs(blue, 'by a key');
  expect(await undoIsOff()).toBe(wasOff);
  expect((await saveGraphs(open)).main?.nodes['map-aaaa']?.params?.channel).toBeUndefined();
  await page.keyboard.press('Enter');
  await editor.imageSameAs(blue, 'chosen');
  expect((await saveGraphs(open)).main?.nodes['map-aaaa']?.params?.channel).toBe(3);
  await undo();
  await editor.imageSameAs(before, 'undone');
  await choice.click();
});

testThemes(open);
