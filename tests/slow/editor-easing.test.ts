import { expect, test } from '@jest/globals';
import type { Locator } from 'playwright-core';
import { centerOf, type Point } from '../../tools/lib/center-of.ts';
import { testThemes } from '../support/axe-themes.ts';
import { chooseOption } from '../support/choose-option.ts';
import { Hand } from '../support/hand.ts';
import { keyframedSepia } from '../support/keyframed-sepia.ts';
import { type GraphText, saveGraphs, useOneEditor } from '../support/open-editor.ts';
import { eventually } from '../support/patience.ts';

/** What the camera sees, browner and browner for as long as the recording lasts. */
const GRAPH: GraphText = {
  nodes: {
    'video-aaaa': { type: 'source/camera-video' },
    'sepia-aaaa': keyframedSepia({ timeS: 0, value: 0.2 }, { timeS: 3, value: 0.4 }),
    'screen-aaaa': { type: 'output/screen' },
  },
  wires: ['video-aaaa.layer -> sepia-aaaa.inputImage', 'sepia-aaaa.layer -> screen-aaaa.layer'],
  places: { 'video-aaaa': [0, 0], 'sepia-aaaa': [260, 0], 'screen-aaaa': [520, 0] },
};
const HALFWAY_FRAME = 15;

const open = useOneEditor(GRAPH, { colorScheme: 'dark', hasTouch: true }, async () => {
  const { page, editor } = open;
  await editor.settled();
  await editor.hold();
  await editor.press('Go to first frame');
  await editor.node('sepia').locator('.node-title').click();
  await page.keyboard.press('Shift+T');
  await page.getByRole('slider', { name: 'Playhead' }).focus();
  for (let i = 0; i < HALFWAY_FRAME; i++) await page.keyboard.press('ArrowRight');
  await page.waitForFunction((f) => document.querySelector('.transport-time span')?.textContent === String(f), HALFWAY_FRAME);
  await page.getByRole('button', { name: 'Keyframe 1, 0.00 s' }).click();
});

const choice = (): Locator => open.page.getByRole('combobox', { name: 'Interpolation' });
const button = (): Locator => open.page.getByRole('button', { name: 'Edit Bézier curve' });
const dialog = (): Locator => open.page.getByRole('dialog', { name: 'Bézier interpolation' });
const handle = (side: 'Start control point' | 'End control point'): Locator => dialog().getByRole('slider', { name: side });

/** In the square of the easing, from (0, 0) at the bottom left to (1, 1). */
async function place(x: number, y: number): Promise<Point> {
  const box = await dialog().locator('.curve-square').boundingBox();
  if (!box) throw new Error('The easing is not open.');
  return { x: box.x + x * box.width, y: box.y + (1 - y) * box.height };
}

async function saved(): Promise<unknown> {
  const graphs = await saveGraphs(open);
  const amount = graphs.main?.nodes['sepia-aaaa']?.params?.amount as { track: { keys: { easing?: unknown }[] } };
  return amount.track.keys[0]?.easing;
}

/** To twentieths: a pixel is about a hundredth. */
async function savedRoughly(): Promise<unknown> {
  return ((await saved()) as readonly number[]).map((number) => Math.round(number * 20) / 20);
}

/** The amount that the inspector shows now. */
async function amount(): Promise<number> {
  return Number(await open.editor.inspector.getByRole('textbox', { name: 'Amount', exact: true }).inputValue());
}

/** What an animation of the browser's own makes of the saved easing at that moment. */
async function amountByBrowser(): Promise<number> {
  const progress = await open.page.evaluate(
    ({ handles, part }) => {
      const animation = document.body.animate(
        { opacity: [1, 1] },
        { duration: 1000, easing: `cubic-bezier(${handles.join(', ')})`, fill: 'both' },
      );
      animation.pause();
      animation.currentTime = 1000 * part;
      const computed = animation.effect?.getComputedTiming().progress ?? Number.NaN;
      animation.cancel();
      return computed;
    },
    { handles: (await saved()) as readonly number[], part: HALFWAY_FRAME / 30 },
  );
  return 0.2 + 0.2 * progress;
}

test('a named easing is gone on from by handles, which are dragged; the value follows as the browser would have it', async () => {
  const { page, editor } = open;
  const before = await editor.restingImage();
  expect(await amount()).toBeCloseTo(0.3, 6);
  await chooseOption(choice(), 'bezier');
  expect(await savedRoughly()).toEqual([0.35, 0.35, 0.65, 0.65]);
  await button().click();
  const [from, to] = [await centerOf(handle('Start control point')), await place(0.3, 1.4)];
  await page.mouse.move(from.x, from.y);
  await page.mouse.down();
  await page.mouse.move(to.x, to.y);
  // Not let go yet.
  await eventually(async () => expect(await amount()).toBeGreaterThan(0.35));
  await editor.imageOtherThan(before);
  await page.mouse.up();
  expect(await savedRoughly()).toEqual([0.3, 1.4, 0.65, 0.65]);
  expect(await amount()).toBeCloseTo(await amountByBrowser(), 2);
  // One step, which is undone from within.
  await page.keyboard.press('Control+z');
  expect(await savedRoughly()).toEqual([0.35, 0.35, 0.65, 0.65]);
  await editor.imageSameAs(before, 'undone');
});

test('Escape gives a drag up, and closes only when nothing is dragged', async () => {
  const { page } = open;
  const [from, to] = [await centerOf(handle('End control point')), await place(0.1, 0.1)];
  await page.mouse.move(from.x, from.y);
  await page.mouse.down();
  await page.mouse.move(to.x, to.y);
  await page.keyboard.press('Escape');
  await page.mouse.up();
  expect(await savedRoughly()).toEqual([0.35, 0.35, 0.65, 0.65]);
  await handle('Start control point').press('Escape');
  await dialog().waitFor({ state: 'detached' });
});

test('by keys and numbers, as far as handles may go', async () => {
  const { page } = open;
  await button().press('Enter');
  await eventually(async () =>
    expect(await handle('Start control point').evaluate((element) => element === document.activeElement)).toBe(true),
  );
  for (const key of ['Shift+ArrowUp', 'ArrowUp', 'ArrowLeft']) await page.keyboard.press(key);
  expect(await saved()).toEqual([0.323, 0.443, 2 / 3, 2 / 3]);
  await dialog().getByRole('textbox', { name: 'Start control point, up' }).fill('9');
  await page.keyboard.press('Enter');
  await dialog().getByRole('textbox', { name: 'End control point, across' }).fill('-1');
  await page.keyboard.press('Enter');
  expect(await saved()).toEqual([0.323, 1.6, 0, 0.667]);
  expect(await amount()).toBeCloseTo(await amountByBrowser(), 2);
});

test('by a finger', async () => {
  const hand = await Hand.on(open.page);
  await hand.drag(await centerOf(handle('Start control point')), await place(0.8, 0.2));
  expect(await savedRoughly()).toEqual([0.8, 0.2, 0, 0.65]);
});

testThemes(open);

test('a named easing has the handles that it is drawn with, and a step has none', async () => {
  const { page } = open;
  await page.keyboard.press('Escape');
  await chooseOption(choice(), 'step');
  expect(await button().isDisabled()).toBe(true);
  await chooseOption(choice(), 'ease-in');
  await button().click();
  await handle('End control point').press('ArrowDown');
  expect(await saved()).toEqual([0.42, 0, 1, 0.99]);
  expect(await choice().textContent()).toBe('Bézier');
});
