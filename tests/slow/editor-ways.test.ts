import { cp, mkdtemp, rm } from 'node:fs/promises';
import { tmpdir } from 'node:os';
import { join, resolve } from 'node:path';
import { afterAll, beforeAll, expect, test } from '@jest/globals';
import type { Page } from 'playwright-core';
import { startServer } from '../../app/server/start-server.ts';
import { installationAt } from '../../app/services/installation.ts';
import { centerOf } from '../../tools/lib/center-of.ts';
import { axeFindings } from '../support/axe.ts';
import { collectErrors, useBrowser } from '../support/browser.ts';
import { EditorDriver } from '../support/editor-driver.ts';
import { takeTour } from '../support/tour.ts';

const ROOT = resolve(import.meta.dirname, '../..');
const browser = useBrowser();
let base = '';
let page: Page;
let errors: readonly string[] = [];
let close = async () => {};
beforeAll(async () => {
  base = await mkdtemp(join(tmpdir(), 'scrim-ways-'));
  // Unsaved work stays beside the project it is of: not in the examples that everybody has.
  const installation = { ...installationAt(ROOT, '0.0.0'), examplesDir: join(base, 'examples') };
  const { examplesDir, sessionsDir } = installationAt(ROOT, '0.0.0');
  await cp(examplesDir, installation.examplesDir, { recursive: true, filter: (from) => from !== sessionsDir });
  const server = await startServer({ installation, startPath: null, log: () => {} });
  page = await browser.browser.newPage({ viewport: { width: 1440, height: 900 }, colorScheme: 'dark' });
  errors = collectErrors(page);
  await page.goto(server.invite());
  close = async () => {
    await page.close();
    await server.close();
  };
});
afterAll(async () => {
  await close();
  await rm(base, { recursive: true, force: true });
  expect(errors).toEqual([]);
});

const theme = () => page.evaluate(() => [document.documentElement.dataset.theme, getComputedStyle(document.body).backgroundColor]);
const isLightColor = (color: string | undefined) => Number(/\d+/.exec(color ?? '')?.[0]) > 200;

// The tests go on from one another, as a newcomer does.
test('the start screen shows templates and examples with their pictures', async () => {
  const start = page.getByRole('dialog', { name: 'Scrim' });
  await start.waitFor();
  const cards = start.locator('.image-card');
  expect(await cards.count()).toBeGreaterThan(20);
  const shown = await start.locator('.image-card img').evaluateAll(async (images) => {
    for (const image of images) await (image as HTMLImageElement).decode();
    return images.map((image) => (image as HTMLImageElement).naturalWidth);
  });
  expect(shown.filter((width) => width === 240)).toHaveLength(await cards.count());
  expect(await axeFindings(page)).toEqual([]);
});

test('the tour goes through the window in five steps, by keys alone', async () => {
  await page.getByRole('button', { name: 'Take the tour' }).focus();
  await page.keyboard.press('Enter');
  const card = page.locator('.tour-card');
  await takeTour(page, async (step) => {
    if (step === 1) expect(await axeFindings(page)).toEqual([]);
    if (step !== 2) return;
    await page.keyboard.press('ArrowLeft');
    await card.getByText('1 of 5').waitFor();
    await page.keyboard.press('ArrowRight');
    await card.getByText('2 of 5').waitFor();
  });
});

test('commands are found by name, and do what they say', async () => {
  await page.keyboard.press('Control+k');
  const dialog = page.getByRole('dialog', { name: 'Commands' });
  expect(await axeFindings(page)).toEqual([]);
  await dialog.getByRole('combobox').fill('light dark');
  await page.keyboard.press('Enter');
  await page.waitForFunction(() => document.documentElement.dataset.theme === 'light');
  expect(isLightColor((await theme())[1])).toBe(true);
  await page.keyboard.press('Control+k');
  await dialog.getByRole('combobox').fill('less motion');
  await page.keyboard.press('Enter');
  await page.waitForFunction(() => document.documentElement.dataset.motion === 'reduced');
  expect(await page.evaluate(() => getComputedStyle(document.documentElement).getPropertyValue('--calm'))).toMatch(/^0m?s$/);
});

test('keys are chosen in the sheet, and hold in the next window', async () => {
  const editor = new EditorDriver(page);
  const sheet = page.getByRole('dialog', { name: 'Keyboard and pointer shortcuts' });
  await page.getByRole('button', { name: 'Help', exact: true }).click();
  await page.getByRole('menuitem', { name: /Keyboard shortcuts/ }).click();
  await sheet.getByRole('button', { name: 'Keys for Problems' }).click();
  await page.keyboard.press('Control+f');
  await sheet.getByText('removed from Find in the graph').waitFor();
  expect(await axeFindings(page)).toEqual([]);
  await page.keyboard.press('Escape');
  await sheet.waitFor({ state: 'detached' });
  const panel = page.getByRole('region', { name: 'Problems' });
  await page.keyboard.press('Control+f');
  await panel.waitFor();

  await page.reload();
  // The window opens the project again that it showed.
  await page.locator('.react-flow__node').first().waitFor();
  expect((await theme())[0]).toBe('light');
  await editor.settled();
  await page.keyboard.press('Control+f');
  await panel.waitFor();
});

test('a problem is fixed by its button', async () => {
  const editor = new EditorDriver(page);
  await editor.node('depth-occlusion').or(editor.node('hide')).first().waitFor();
  const place = await editor.emptyPlace();
  await page.mouse.dblclick(place.x, place.y);
  await page.getByRole('combobox', { name: 'Search nodes' }).fill('sepia');
  await page.keyboard.press('Enter');
  const list = page.getByRole('list', { name: 'Problems' });
  const fix = list
    .getByRole('button', { name: 'Find a node' })
    .or(list.getByRole('button', { name: 'Delete Sepia' }))
    .first();
  await fix.waitFor();
  const label = await fix.textContent();
  await fix.click();
  if (label?.startsWith('Delete')) await editor.node('sepia').waitFor({ state: 'detached' });
  else {
    await page.getByRole('combobox', { name: 'Search nodes' }).waitFor();
    await page.keyboard.press('Escape');
  }
});

test('keyframes are set by the diamond beside a value, dragged in the panel, and taken away', async () => {
  const editor = new EditorDriver(page);
  await editor.node('warm').locator('.node-title').click();
  await editor.hold();
  await editor.press('Go to first frame');
  await page.waitForFunction(() => document.querySelector('.transport-time span')?.textContent === '0');
  const row = editor.inspector
    .getByRole('group')
    .filter({ has: page.locator('.key-button') })
    .first();
  const label = (await row.getAttribute('aria-label')) ?? '';
  const number = row.getByRole('textbox', { name: label, exact: true });
  const first = Number.parseFloat(await number.inputValue());
  await row.getByRole('button', { name: `Set a keyframe of ${label}` }).click();
  const panel = page.getByRole('region', { name: 'Timeline' });
  await panel.getByRole('button', { name: /^Keyframe 1/ }).waitFor();

  // Another value at a later moment is another key.
  const ruler = (await panel.locator('.timeline-ruler').boundingBox()) ?? { x: 0, y: 0, width: 0, height: 0 };
  await page.mouse.click(ruler.x + 0.8 * ruler.width, ruler.y + ruler.height / 2);
  await page.waitForFunction(() => Number.parseFloat(document.querySelector('.transport-time')?.textContent ?? '') > 2.5);
  await row.getByRole('slider').focus();
  await page.keyboard.press('End');
  const second = panel.getByRole('button', { name: /^Keyframe 2/ });
  await second.waitFor();
  expect(Number.parseFloat(await number.inputValue())).toBeGreaterThan(first);
  expect(await axeFindings(page)).toEqual([]);

  // Dragged to the left; one undo takes all of the drag back.
  const timeOf = async () => Number(/, ([\d.]+) s/.exec((await second.getAttribute('aria-label')) ?? '')?.[1]);
  const before = await timeOf();
  const from = await centerOf(second);
  await editor.drag(from, { x: from.x - 0.2 * ruler.width, y: from.y });
  expect(await timeOf()).toBeLessThan(before - 0.5);
  await page.keyboard.press('Control+z');
  expect(await timeOf()).toBeCloseTo(before, 2);

  // By keys.
  await second.focus();
  await page.keyboard.press('ArrowLeft');
  expect(await timeOf()).toBeCloseTo(before - 0.1, 2);
  await page.keyboard.press('Delete');
  await second.waitFor({ state: 'detached' });
});
