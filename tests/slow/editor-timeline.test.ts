import { expect, test } from '@jest/globals';
import type { Locator } from 'playwright-core';
import { centerOf } from '../../tools/lib/center-of.ts';
import { chooseOption } from '../support/choose-option.ts';
import { type GraphText, useOneEditor } from '../support/open-editor.ts';
import { countDifferent } from '../support/pixels.ts';

/** What the camera sees, blurred: the room's own frames differ, and a dial changes all of them. */
const GRAPH: GraphText = {
  nodes: {
    'video-aaaa': { type: 'source/camera-video' },
    'gaussian-blur-aaaa': { type: 'filter/gaussian-blur', params: { radius: 0 } },
    'screen-aaaa': { type: 'output/screen' },
  },
  wires: ['video-aaaa.layer -> gaussian-blur-aaaa.inputImage', 'gaussian-blur-aaaa.layer -> screen-aaaa.layer'],
  places: { 'video-aaaa': [0, 0], 'gaussian-blur-aaaa': [260, 0], 'screen-aaaa': [520, 0] },
};
/** Of the studio that ships with Scrim. */
const FRAMES = 36;

const open = useOneEditor(GRAPH, { colorScheme: 'dark' }, async () => {
  await open.editor.settled();
  await open.editor.hold();
  await open.editor.press('Go to first frame');
  await open.page.keyboard.press('Escape');
  await open.page.locator('.react-flow__pane').click({ position: { x: 40, y: 40 } });
  await open.page.keyboard.press('Shift+T');
  await handle('In point').waitFor();
});

function handle(name: string): Locator {
  return open.page.getByRole('slider', { name, exact: true });
}

async function frameOf(name: string): Promise<number> {
  return Number(await handle(name).getAttribute('aria-valuenow'));
}

/** The number of the frame is what was asked for; its picture comes a little later. */
async function shows(frame: number): Promise<void> {
  await open.page.waitForFunction((f) => document.querySelector('.transport-time span')?.textContent === String(f), frame);
  await open.editor.settled();
}

/** Where a border between frames stands on the ruler. */
async function borderAt(frame: number): Promise<{ readonly x: number; readonly y: number }> {
  const box = await open.page.locator('.timeline-ruler').boundingBox();
  if (!box) throw new Error('There is no ruler.');
  return { x: box.x + (frame / FRAMES) * box.width, y: box.y + box.height / 2 };
}

test('steps, keys and the ruler lead to the same frames', async () => {
  const { page, editor } = open;
  await handle('Playhead').focus();
  for (let i = 0; i < 12; i++) await page.keyboard.press('ArrowRight');
  await shows(12);
  const stepped = await editor.restingImage();
  await page.keyboard.press('End');
  await shows(FRAMES - 1);
  const last = await editor.restingImage();
  expect(countDifferent(last, stepped, 8).pixels).toBeGreaterThan(1000);
  await page.keyboard.press('Home');
  await shows(0);
  // Anywhere within the frame is that frame.
  const [left, right] = [await borderAt(12), await borderAt(13)];
  for (const part of [0.1, 0.9]) {
    await page.mouse.click(left.x + part * (right.x - left.x), left.y);
    await shows(12);
    await editor.imageSameAs(stepped, 'the ruler’s frame');
  }
  await page.mouse.click((await borderAt(20)).x + 3, left.y);
  await shows(20);
  await handle('Playhead').focus();
  for (let i = 0; i < 8; i++) await page.keyboard.press('ArrowLeft');
  await shows(12);
  await editor.imageSameAs(stepped, 'stepped back');
});

test('held, the picture follows the dials, and the frame stays', async () => {
  const { page, editor } = open;
  const sharp = await editor.restingImage();
  await editor.node('gaussian-blur').locator('.node-title').click();
  const radius = editor.inspector.getByRole('textbox', { name: 'Radius', exact: true });
  await radius.fill('12');
  await page.keyboard.press('Enter');
  await editor.imageOtherThan(sharp);
  await shows(12);
  // Muted, another program is played: at the same frame.
  await editor.node('gaussian-blur').locator('.node-title').click();
  await page.keyboard.press('m');
  await editor.imageSameAs(sharp, 'muted');
  await page.keyboard.press('Control+z');
  await page.keyboard.press('Control+z');
  await editor.imageSameAs(sharp, 'undone');
  await shows(12);
});

test('a range is set by keys and by dragging its ends, to the frame', async () => {
  const { page, editor } = open;
  await handle('Playhead').focus();
  await page.keyboard.press('i');
  expect(await frameOf('In point')).toBe(12);
  for (let i = 0; i < 6; i++) await page.keyboard.press('ArrowRight');
  await page.keyboard.press('o');
  expect(await frameOf('Out point')).toBe(18);
  expect(await page.getByRole('status', { name: 'Play range' }).textContent()).toBe('12–18 · 7 frames');

  await editor.drag(await centerOf(handle('In point')), await borderAt(9));
  expect(await frameOf('In point')).toBe(9);
  await editor.drag(await centerOf(handle('Out point')), await borderAt(14));
  expect(await frameOf('Out point')).toBe(13);
  // Neither passes the other.
  await editor.drag(await centerOf(handle('In point')), await borderAt(30));
  expect(await frameOf('In point')).toBe(13);
  await page.keyboard.press('Home');
  for (const key of ['ArrowRight', 'ArrowRight', 'PageUp', 'ArrowLeft', 'ArrowLeft', 'ArrowLeft']) await page.keyboard.press(key);
  expect(await frameOf('In point')).toBe(9);
  expect(await handle('In point').getAttribute('aria-valuetext')).toBe('Frame 9, 0.90 s');
});

/** Every frame that is told, from now until `stop` says so. */
async function framesUntil(stop: 'it goes back' | 'it is held'): Promise<readonly number[]> {
  return open.page.evaluate(
    (until) =>
      new Promise<number[]>((resolve) => {
        const number = document.querySelector('.transport-time span');
        const seen: number[] = [];
        const look = () => {
          const frame = Number(number?.textContent);
          if (seen.at(-1) !== frame) seen.push(frame);
          const wentBack = frame < (seen.at(-2) ?? 0);
          const held = document.querySelector('button[aria-label="Play"]') !== null;
          if (until === 'it goes back' ? wentBack : held && seen.length > 1) {
            observer.disconnect();
            resolve(seen);
          }
        };
        const observer = new MutationObserver(look);
        observer.observe(document.querySelector('.transport') ?? document.body, {
          subtree: true,
          characterData: true,
          childList: true,
          attributes: true,
        });
        look();
      }),
    stop,
  );
}

test('only the range is played: once, or over and over', async () => {
  const { page, editor } = open;
  await page.keyboard.press('Escape');
  // Longer than the longest step of time, half a second: on a machine that draws twice a second it would always end where it began.
  await handle('Out point').focus();
  for (let i = 0; i < 2; i++) await page.keyboard.press('ArrowRight');
  expect(await frameOf('Out point')).toBe(15);
  await handle('Playhead').focus();
  await page.keyboard.press('Home');
  await shows(0);
  const once = framesUntil('it is held');
  await editor.press('Play');
  const played = await once;
  expect(played.slice(1).every((frame) => frame >= 9 && frame <= 15)).toBe(true);
  await shows(15);

  await page.getByRole('button', { name: 'Loop', exact: true }).click();
  const looped = framesUntil('it goes back');
  await editor.press('Play');
  expect((await looped).every((frame) => frame >= 9 && frame <= 15)).toBe(true);
  const again = await framesUntil('it goes back');
  expect(again.every((frame) => frame >= 9 && frame <= 15)).toBe(true);
  await editor.hold();
});

test('the range comes back with the project, and can be given up', async () => {
  const { page, editor } = open;
  await page.keyboard.press('Control+s');
  await page.reload();
  await editor.settled();
  await page.locator('.react-flow__pane').click({ position: { x: 40, y: 40 } });
  await page.keyboard.press('Shift+T');
  await handle('In point').waitFor();
  expect([await frameOf('In point'), await frameOf('Out point')]).toEqual([9, 15]);
  expect(await page.getByRole('button', { name: 'Loop', exact: true }).getAttribute('aria-pressed')).toBe('true');
  await handle('Playhead').focus();
  await page.keyboard.press('x');
  expect([await frameOf('In point'), await frameOf('Out point')]).toEqual([0, FRAMES - 1]);

  // Rooms have no moments to go to: the panel says so.
  await chooseOption(page.getByRole('combobox', { name: 'Preview source' }), 'room/studio');
  await page.getByText('Only recordings have a play range.').waitFor();
  expect(await handle('In point').count()).toBe(0);
});
