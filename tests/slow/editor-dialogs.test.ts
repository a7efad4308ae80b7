import { mkdir, readFile, rm, utimes, writeFile } from 'node:fs/promises';
import { basename, dirname, join } from 'node:path';
import { afterAll, beforeAll, expect, test } from '@jest/globals';
import type { Locator } from 'playwright-core';
import { axeFindings } from '../support/axe.ts';
import { useBrowser } from '../support/browser.ts';
import { type GraphText, type OpenEditor, openEditor } from '../support/open-editor.ts';

const GRAPH: GraphText = {
  nodes: {
    'video-aaaa': { type: 'source/camera-video' },
    'sepia-aaaa': { type: 'filter/sepia' },
    'screen-aaaa': { type: 'output/screen' },
  },
  wires: ['video-aaaa.layer -> sepia-aaaa.inputImage', 'sepia-aaaa.layer -> screen-aaaa.layer'],
  places: { 'video-aaaa': [0, 0], 'sepia-aaaa': [240, 0], 'screen-aaaa': [480, 0] },
};

const chromium = useBrowser();
let open: OpenEditor;
beforeAll(async () => {
  open = await openEditor(chromium.browser, GRAPH);
  await open.editor.settled();
  await open.editor.hold();
});
afterAll(async () => {
  // The browser itself says so of every call that is refused.
  expect(open.errors.filter((error) => !error.includes('422'))).toEqual([]);
  await open.close();
});

async function expectNothingFound(): Promise<void> {
  for (const colorScheme of ['dark', 'light'] as const) {
    await open.page.emulateMedia({ colorScheme, reducedMotion: 'reduce' });
    expect([colorScheme, await axeFindings(open.page)]).toEqual([colorScheme, []]);
  }
}

/** Runs a command of the editor by its name. */
async function run(command: string): Promise<void> {
  const { page } = open;
  await page.keyboard.press('Control+k');
  await page.getByRole('combobox', { name: 'Command' }).fill(command);
  await page
    .getByRole('option', { name: new RegExp(`^${command}`) })
    .first()
    .click();
}

async function close(dialog: Locator): Promise<void> {
  await open.page.keyboard.press('Escape');
  await dialog.waitFor({ state: 'detached' });
}

test.each([
  ['New', 'New project', 'Create', 'Folder'],
  ['Save as', 'Save a copy', 'Save', 'Folder'],
  ['Render frames', 'Render frames', 'Render', 'Folder'],
] as const)('what is wrong with the folder of “%s” stands in the dialog until it closes, and in no message behind it', async (...row) => {
  const [command, title, action, label] = row;
  const { page, project } = open;
  await run(command);
  const dialog = page.getByRole('dialog', { name: title });
  await dialog.waitFor();
  await expectNothingFound();
  // The folder of the open project holds files.
  await dialog.getByRole('textbox', { name: label, exact: true }).fill(project);
  await dialog.getByRole('button', { name: action, exact: true }).click();
  await dialog.getByRole('alert').getByText(/\w/).first().waitFor();
  const field = dialog.getByRole('textbox', { name: label, exact: true });
  expect(await field.getAttribute('aria-invalid')).toBe('true');
  const described = page.locator(`[id="${await field.getAttribute('aria-describedby')}"]`);
  expect(await described.textContent()).toMatch(/\w/);
  await expect(page.getByRole('log', { name: 'Messages' }).locator('.toast-error').count()).resolves.toBe(0);
  await expectNothingFound();
  await close(dialog);
  await expect(page.getByRole('log', { name: 'Messages' }).locator('.toast-error').count()).resolves.toBe(0);
});

test('folders are chosen from a list: the name of a new one stays, and an existing project is opened', async () => {
  const { page, project } = open;
  const above = dirname(project);
  await run('New');
  const made = page.getByRole('dialog', { name: 'New project' });
  const folder = made.getByRole('textbox', { name: 'Folder' });
  await folder.fill(join(project, 'my-effect'));
  await made.getByRole('button', { name: 'Browse' }).click();
  await made.getByRole('region', { name: `Folders in ${project}` }).waitFor();
  await expectNothingFound();
  await made.getByRole('button', { name: `Up to ${above}` }).click();
  await made.getByRole('region', { name: `Folders in ${above}` }).waitFor();
  expect(await folder.inputValue()).toBe(join(above, 'my-effect'));
  await close(made);

  await run('Open');
  const opened = page.getByRole('dialog', { name: 'Open project' });
  await opened.getByRole('textbox', { name: 'Project folder' }).fill(above);
  await opened.getByRole('button', { name: 'Browse' }).click();
  await opened.getByRole('button', { name: `${basename(project)} Project` }).click();
  expect(await opened.getByRole('textbox', { name: 'Project folder' }).inputValue()).toBe(project);
  await opened.getByRole('button', { name: 'Open', exact: true }).click();
  await opened.waitFor({ state: 'detached' });
  await open.editor.settled();
});

test('a folder that exists is not suggested for a new project', async () => {
  const { page, project } = open;
  const made = page.getByRole('dialog', { name: 'New project' });
  // The projects folder is that of the person who runs this test, so the name is one that nobody has.
  const name = `taken-${basename(project)}`;
  await run('New');
  await made.getByRole('textbox', { name: 'Name' }).fill(name);
  const first = await made.getByRole('textbox', { name: 'Folder' }).inputValue();
  expect(basename(first)).toBe(name.toLowerCase());
  await close(made);
  await mkdir(first, { recursive: true });
  await run('New');
  await made.getByRole('textbox', { name: 'Name' }).fill(name);
  await page.waitForFunction((path) => [...document.querySelectorAll('input')].some(({ value }) => value === path), `${first}-2`);
  await close(made);
  await rm(first, { recursive: true });
});

test('a folder without a project is refused in the dialog that opens projects', async () => {
  const { page } = open;
  await run('Open');
  const dialog = page.getByRole('dialog', { name: 'Open project' });
  await dialog.waitFor();
  await expectNothingFound();
  await dialog.getByRole('textbox', { name: 'Project folder' }).fill('/nowhere/at/all');
  await page.keyboard.press('Enter');
  await dialog.getByRole('alert').getByText(/\w/).first().waitFor();
  await expectNothingFound();
  await close(dialog);
});

test.each([
  ['Import Shadertoy', 'Import Shadertoy'],
  ['Keyboard shortcuts', 'Keyboard and pointer shortcuts'],
] as const)('the dialog of “%s”', async (command, title) => {
  await run(command);
  const dialog = open.page.getByRole('dialog', { name: title });
  await dialog.waitFor();
  await expectNothingFound();
  await close(dialog);
});

test('the palette, as it opens and with a search', async () => {
  const { page } = open;
  await page.locator('.canvas').focus();
  await page.keyboard.press('Shift+A');
  const field = page.getByRole('combobox', { name: 'Search nodes' });
  await field.waitFor();
  await expectNothingFound();
  await field.fill('blur');
  await expectNothingFound();
  await page.keyboard.press('Escape');
  await field.waitFor({ state: 'detached' });
});

test('menus, with ticks and headings, and the list of preview sources', async () => {
  const { page, editor } = open;
  await editor.press('View');
  await page.getByRole('menuitemcheckbox', { name: 'Thumbnails' }).waitFor();
  await expectNothingFound();
  await page.keyboard.press('Escape');
  await editor.press('Preview options');
  await page.getByRole('menuitemradio', { name: 'Render size: 720p' }).waitFor();
  await expectNothingFound();
  await page.keyboard.press('Escape');
  await page.getByRole('combobox', { name: 'Preview source' }).click();
  await page.getByRole('group', { name: 'Emulated rooms' }).waitFor();
  await expectNothingFound();
  await page.keyboard.press('Escape');
});

test.each(['Assets', 'History', 'Problems', 'Timeline'])('the panel of “%s”, and its tick in the menu', async (name) => {
  const { page, editor } = open;
  await run(name);
  await expectNothingFound();
  await editor.press('View');
  const item = page.getByRole('menuitemcheckbox', { name });
  await expect(item.getAttribute('aria-checked')).resolves.toBe('true');
  await item.click();
  await editor.press('View');
  await expect(item.getAttribute('aria-checked')).resolves.toBe('false');
  await page.keyboard.press('Escape');
});

/** An owner of files on another machine, whose processes cannot be looked up. */
const ELSEWHERE = '00000000-1-1';

test('the question about a project that another machine is saving', async () => {
  const { page, project } = open;
  await mkdir(join(project, '.scrim'), { recursive: true });
  await writeFile(join(project, '.scrim', 'lock'), `${ELSEWHERE} 00`);
  await page.getByRole('textbox', { name: 'Title', exact: true }).fill('Locked');
  await page.keyboard.press('Enter');
  await page.keyboard.press('Control+s');
  const dialog = page.getByRole('dialog', { name: 'Project is locked' });
  await dialog.waitFor();
  await expectNothingFound();
  await dialog.getByRole('button', { name: 'Break lock' }).click();
  await page.locator('.unsaved').waitFor({ state: 'detached' });
});

test('the question about unsaved changes of a Scrim that was killed', async () => {
  const { page, project } = open;
  const left = join(project, '.scrim', `unsaved-${ELSEWHERE}-00.json`);
  const text = await readFile(join(project, 'project.scrim.json'), 'utf8');
  await writeFile(left, JSON.stringify({ project: text.replace('Locked', 'Left behind'), layout: null, sources: {} }));
  const daysAgo = new Date(Date.now() - 2 * 24 * 3600 * 1000);
  await utimes(left, daysAgo, daysAgo);
  await page.reload();
  const dialog = page.getByRole('dialog', { name: 'Unsaved changes found' });
  await dialog.waitFor();
  await expectNothingFound();
  await dialog.getByRole('button', { name: 'Restore' }).click();
  await dialog.waitFor({ state: 'detached' });
  expect(await page.getByRole('textbox', { name: 'Title', exact: true }).inputValue()).toBe('Left behind');
});
