import { mkdtemp, readdir, readFile, rm, writeFile } from 'node:fs/promises';
import { tmpdir } from 'node:os';
import { join, resolve } from 'node:path';
import process from 'node:process';
import { afterAll, afterEach, beforeAll, beforeEach, describe, expect, test } from '@jest/globals';
import type { Page } from 'playwright-core';
import { type EditorServer, startServer } from '../../app/server/start-server.ts';
import { installationAt } from '../../app/services/installation.ts';
import { collectErrors, useBrowser } from '../support/browser.ts';
import { EditorDriver } from '../support/editor-driver.ts';
import { eventually } from '../support/patience.ts';
import { projectText, writeProject } from '../support/project-kit.ts';

const ROOT = resolve(import.meta.dirname, '../..');
const chromium = useBrowser();

let base = '';
let project = '';
let server: EditorServer;
const pages: Page[] = [];

beforeAll(async () => {
  base = await mkdtemp(join(tmpdir(), 'scrim-windows-'));
});
afterAll(() => rm(base, { recursive: true, force: true }));
beforeEach(async () => {
  project = await mkdtemp(join(base, 'project-'));
  await writeProject(project, { 'project.scrim.json': projectText({ title: 'Shared', nodes: {}, wires: [] }) });
  const log = (message: string) => process.stderr.write(`${message}\n`);
  server = await startServer({ installation: installationAt(ROOT, '0.0.0'), startPath: project, log });
});
afterEach(async () => {
  for (const page of pages.splice(0)) await page.close();
  await server.close();
});

async function openTab(): Promise<Page> {
  const page = await chromium.browser.newPage({ viewport: { width: 1280, height: 800 } });
  pages.push(page);
  await page.goto(server.invite());
  await page.locator('.top-title h1').filter({ hasText: 'Shared' }).waitFor();
  await page.getByRole('textbox', { name: 'Title' }).waitFor();
  return page;
}

async function retitle(page: Page, title: string): Promise<void> {
  const field = page.getByRole('textbox', { name: 'Title' });
  await field.fill(title);
  await field.press('Tab');
  await page.locator('.unsaved').waitFor();
}

async function save(page: Page): Promise<void> {
  await page.keyboard.press('Control+s');
  await page.locator('.unsaved').waitFor({ state: 'detached' });
}

function shows(page: Page, title: string): Promise<void> {
  return page.locator('.top-title h1').filter({ hasText: title }).waitFor();
}

async function titleOnDisk(): Promise<string> {
  return (JSON.parse(await readFile(join(project, 'project.scrim.json'), 'utf8')) as { title: string }).title;
}

const menu = async (page: Page, name: string, item: string) => {
  await page.getByRole('button', { name, exact: true }).click();
  await page.getByRole('menuitem', { name: item }).click();
};

describe('two tabs on one project', () => {
  test('the second window is notified and follows the first, and no work is replaced without asking', async () => {
    const first = await openTab();
    const second = await openTab();
    await second.getByText('This project is also open in another window.').waitFor();
    expect(await first.getByText('This project is also open in another window.').count()).toBe(0);

    await retitle(first, 'From the first');
    await save(first);
    await shows(second, 'From the first');

    await retitle(second, 'From the second');
    await retitle(first, 'First again');
    await save(first);
    const question = second.getByRole('dialog', { name: 'Project changed on disk' });
    await question.waitFor();
    expect(await titleOnDisk()).toBe('First again');
    await shows(second, 'From the second');
    await question.getByRole('button', { name: 'Not now' }).click();

    // Saving asks again, and does what is answered.
    await second.keyboard.press('Control+s');
    await question.waitFor();
    expect(await titleOnDisk()).toBe('First again');
    await question.getByRole('button', { name: 'Overwrite' }).click();
    await second.locator('.unsaved').waitFor({ state: 'detached' });
    expect(await titleOnDisk()).toBe('From the second');
    await shows(first, 'From the second');
  });
});

describe('a project that another program writes', () => {
  test('is loaded again; with unsaved work the person decides, and can take the version on disk', async () => {
    const page = await openTab();
    const write = (title: string) => writeFile(join(project, 'project.scrim.json'), projectText({ title, nodes: {}, wires: [] }));
    await write('Written outside');
    await shows(page, 'Written outside');
    await retitle(page, 'Mine');
    await write('Written again');
    const question = page.getByRole('dialog', { name: 'Project changed on disk' });
    await question.getByRole('button', { name: 'Load from disk' }).click();
    await shows(page, 'Written again');
    await page.locator('.unsaved').waitFor({ state: 'detached' });
  });
});

describe('unsaved work', () => {
  test('is offered after the tab died, and not after it was given up', async () => {
    const page = await openTab();
    await retitle(page, 'Not saved');
    await untilUnsavedIs(1);
    await page.close();
    const next = await openTab();
    const offer = next.getByRole('dialog', { name: 'Unsaved changes found' });
    // Only an answer closes the question: going on without one would write over that work.
    await next.keyboard.press('Escape');
    await offer.getByRole('button', { name: 'Restore' }).click();
    await shows(next, 'Not saved');

    await menu(next, 'File', 'New…');
    await next
      .getByRole('dialog', { name: /Save the changes/ })
      .getByRole('button', { name: 'Do not save' })
      .click();
    const folder = join(base, 'given-up');
    const question = next.getByRole('dialog', { name: 'New project' });
    await question.getByRole('textbox', { name: 'Name' }).fill('Given up');
    await question.getByRole('textbox', { name: 'Folder' }).fill(folder);
    await question.getByRole('button', { name: 'Create' }).click();
    await shows(next, 'Given up');
    // It is forgotten a moment after the new project stands there.
    await untilUnsavedIs(0);
    const third = await openTab();
    expect(await third.getByRole('dialog').count()).toBe(0);
  });

  /** As many files of unsaved work lie in the project; the editor keeps it two seconds after it was done. */
  async function untilUnsavedIs(count: number): Promise<void> {
    await eventually(async () => {
      const names = await readdir(join(project, '.scrim')).catch(() => []);
      expect(names.filter((name) => name.startsWith('unsaved-'))).toHaveLength(count);
    });
  }
});

describe('a new project', () => {
  test('begins with what was chosen, and plays', async () => {
    const page = await openTab();
    await menu(page, 'File', 'New…');
    const question = page.getByRole('dialog', { name: 'New project' });
    expect(await question.getByRole('radio').count()).toBe(3);
    expect(await question.getByRole('radio', { name: /^Empty/ }).isChecked()).toBe(true);
    await question.getByRole('radio', { name: /^Filter/ }).check();
    await question.getByRole('textbox', { name: 'Name' }).fill('Größe 2/3');
    const field = question.getByRole('textbox', { name: 'Folder' });
    expect(await field.inputValue()).toMatch(/größe-2-3$/);
    await field.fill('not/whole');
    await question.getByRole('button', { name: 'Create' }).click();
    await page.getByText('not/whole is not a full path.').waitFor();
    expect(await field.getAttribute('aria-invalid')).toBe('true');
    const errors = collectErrors(page);
    const folder = join(base, 'ink-room');
    await field.fill(folder);
    await page.keyboard.press('Enter');
    // The name is the one that was typed, whatever the folder.
    await shows(page, 'Größe 2/3');
    const editor = new EditorDriver(page);
    await editor.settled();
    expect(await editor.node('lines').count()).toBe(1);
    expect(errors).toEqual([]);
    expect(JSON.parse(await readFile(join(folder, 'project.scrim.json'), 'utf8'))).toMatchObject({ title: 'Größe 2/3' });

    // A reload shows it again, and an address of the command line the project of the command line.
    await page.reload();
    await shows(page, 'Größe 2/3');
    await editor.settled();
    await page.goto('about:blank');
    await page.goto(server.invite());
    await shows(page, 'Shared');
  });
});
