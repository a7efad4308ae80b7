import { expect, test } from '@jest/globals';
import { frameOf } from '../../tools/lib/frame-of.ts';
import { axeFindings } from '../support/axe.ts';
import { type GraphText, useOneEditor } from '../support/open-editor.ts';
import { eventually } from '../support/patience.ts';
import { countDifferent } from '../support/pixels.ts';

/** A project as new ones are: the camera on the screen. */
const GRAPH: GraphText = {
  nodes: { 'video-aaaa': { type: 'source/camera-video' }, 'screen-aaaa': { type: 'output/screen' } },
  wires: ['video-aaaa.layer -> screen-aaaa.layer'],
  places: { 'video-aaaa': [0, 0], 'screen-aaaa': [300, 0] },
};

/** Page code: the preview draws no frame while `framesHeld` is set in its window. */
function holdFramesOnRequest(): void {
  if (window.top === window) return;
  const page = window as unknown as { framesHeld?: boolean };
  const request = window.requestAnimationFrame.bind(window);
  window.requestAnimationFrame = (draw) => {
    const run = (timeMs: number) => (page.framesHeld ? void request(run) : draw(timeMs));
    return request(run);
  };
}

const open = useOneEditor(GRAPH, { before: holdFramesOnRequest }, async () => {
  await open.editor.settled();
  await open.editor.hold();
});

const step = (name: string) => open.page.getByRole('list', { name: 'History' }).getByRole('button', { name });
const start = (name: string) => open.page.getByRole('region', { name: 'First steps' }).getByRole('button', { name });

test('the camera is filtered by three interactions', async () => {
  const { page, editor } = open;
  const camera = await editor.picture();
  await start('Filter the camera').click();
  await page.keyboard.type('sepia');
  await page.keyboard.press('Enter');
  await editor.node('sepia').waitFor();
  await editor.settled();
  expect(countDifferent(await editor.picture(), camera, 24).pixels).toBeGreaterThan(300);
  await page.keyboard.press('Control+z');
  await editor.node('sepia').waitFor({ state: 'detached' });
  await editor.settled();
});

test('a blank project offers an object, which is drawn over the camera; the history leads back to the saved version and forth', async () => {
  const { page, editor } = open;
  const camera = await editor.picture();
  await start('Filter the camera').waitFor();
  expect(await axeFindings(page)).toEqual([]);

  await start('Place an object in the room').click();
  await editor.settled();
  const placed = await editor.picture();
  expect(countDifferent(placed, camera, 24).pixels).toBeGreaterThan(300);
  await page.getByText('Not saved', { exact: true }).waitFor();
  await start('Filter the camera').waitFor({ state: 'hidden' });

  await page.keyboard.press('Shift+U');
  await expect(step('Opened').getByText('Saved').count()).resolves.toBe(1);
  expect(await axeFindings(page)).toEqual([]);
  await step('Opened').click();
  await eventually(async () => expect(await page.locator('.react-flow__node').count()).toBe(2));
  await page.getByText('Saved', { exact: true }).first().waitFor();
  await step('Place an object').click();
  await eventually(async () => expect(await page.locator('.react-flow__node').count()).toBe(7));

  await page.getByRole('button', { name: 'File', exact: true }).click();
  await page.getByRole('menuitem', { name: 'Revert to saved' }).click();
  await eventually(async () => expect(await page.locator('.react-flow__node').count()).toBe(2));
  await page.keyboard.press('Control+z');
  await eventually(async () => expect(await page.locator('.react-flow__node').count()).toBe(7));
});

test('the image before stays, and the preview is busy, until a step of the history that changes the device is drawn', async () => {
  const { page, editor } = open;
  await editor.settled();
  const placed = await editor.picture();
  const preview = await frameOf(page);
  await preview.evaluate(() => {
    for (const canvas of document.querySelectorAll('canvas')) canvas.dataset.before = '';
    (window as unknown as { framesHeld: boolean }).framesHeld = true;
  });
  await page.keyboard.press('Control+z');
  await preview.locator('canvas#picture:not([data-before])').waitFor({ state: 'attached' });
  await page.getByText('Loading…', { exact: true }).waitFor();
  await expect(page.locator('.stage').getAttribute('aria-busy')).resolves.toBe('true');
  // The message over the image.
  expect(countDifferent(await editor.picture(), placed, 24).pixels).toBeLessThan(3000);
  await preview.evaluate(() => {
    (window as unknown as { framesHeld: boolean }).framesHeld = false;
  });
  await editor.settled();
  // The preview is a process of its own, whose frame appears after the editor knows of it.
  const camera = await editor.imageOtherThan(placed, 300);
  expect(countDifferent(camera, placed, 24).pixels).toBeLessThan(camera.width * camera.height * 0.5);
  await page.keyboard.press('Control+y');
  await editor.node('primitive').waitFor();
  await editor.settled();
  await editor.imageSameAs(placed);
});

test('the camera without the object is shown while B is held', async () => {
  const { page, editor } = open;
  await page.locator('.react-flow__pane').click({ position: { x: 10, y: 10 } });
  await editor.settled();
  const placed = await editor.picture();
  await page.keyboard.down('b');
  await eventually(async () => expect(countDifferent(await editor.picture(), placed, 24).pixels).toBeGreaterThan(300));
  await page.keyboard.up('b');
  await eventually(async () => expect(countDifferent(await editor.picture(), placed, 24).pixels).toBe(0));
});

test('a changed param is marked, and a double-click on its label resets it', async () => {
  const { page, editor } = open;
  await editor.node('directional').locator('.node-title').click();
  const row = editor.inspector.locator('[data-param="intensity"]');
  const field = row.getByRole('textbox').or(row.getByRole('spinbutton')).first();
  const initial = await field.inputValue();
  await expect(row.getAttribute('data-changed')).resolves.toBeNull();
  await field.fill('2.5');
  await page.keyboard.press('Enter');
  await eventually(async () => expect(await row.getAttribute('data-changed')).toBe(''));
  await row.locator('label').dblclick();
  await eventually(async () => expect(await row.getAttribute('data-changed')).toBeNull());
  await expect(field.inputValue()).resolves.toBe(initial);
});
