import { mkdir, readFile } from 'node:fs/promises';
import { join } from 'node:path';
import { expect } from '@jest/globals';
import type { Page } from 'playwright-core';
import { EditorDriver } from './editor-driver.ts';
import { countColors, countDifferent } from './pixels.ts';
import { OUTPUT_FOLDER } from './this-test.ts';

export interface StoryOptions {
  /** A page with the editor, before `project` is opened. */
  readonly page: Page;
  /** A writable copy of a project. A layer is connected to its Output. */
  readonly project: string;
  /** A folder that does not exist yet. */
  readonly exportTo: string;
  /** Answers the folder dialog of the shell, before or after it opens. */
  readonly answerFolder: (path: string) => Promise<void>;
}

const WORKING = 'gl_FragColor = ';

/**
 * A typical session by pointer and keys: adds and connects a filter, changes params, breaks and fixes its shader, adds an input,
 * saves, reloads and exports. Runs in every shell.
 */
export async function playEditorStory(options: StoryOptions): Promise<void> {
  try {
    await play(options);
  } catch (error) {
    const path = join(OUTPUT_FOLDER, 'editor-story.png');
    await mkdir(OUTPUT_FOLDER, { recursive: true });
    const seen = await options.page.screenshot({ path }).then(
      () => path,
      () => 'gone',
    );
    throw new Error(`The story broke off, ${String(error)}; the window then: ${seen}`, { cause: error });
  }
}

async function play({ page, project, exportTo, answerFolder }: StoryOptions): Promise<void> {
  const editor = new EditorDriver(page);
  const { screen, source } = await readScreen(project);

  // The example plays.
  await editor.settled();
  const untouched = await editor.rewind();
  expect(countColors(untouched)).toBeGreaterThan(100);

  // A filter, found by search and connected by hand, changes the image.
  await editor.addNode('sepia');
  const sepia = await editor.nodeId('sepia');
  await editor.wire(source, [sepia, 'inputImage']);
  await editor.wire([sepia, 'layer'], [screen, 'layer']);
  const brown = await editor.imageOtherThan(untouched);

  // A param in the inspector changes it without a compile. Undo reverts both.
  const compiled = await compileStatus(page);
  await editor.node(sepia).locator('.node-title').click();
  const slider = editor.inspector.getByRole('slider').first();
  await slider.focus();
  await page.keyboard.press('Home');
  const plain = await editor.imageOtherThan(brown);
  // Edges may differ: without a filter, objects are drawn directly to the output, with its antialiasing.
  expect(countDifferent(plain, untouched, 8).pixels).toBeLessThan(0.03 * plain.width * plain.height);
  expect(await compileStatus(page)).toBe(compiled);
  await page.keyboard.press('Control+z');
  await editor.imageSameAs(brown, 'undone');
  await page.keyboard.press('Control+Shift+Z');
  await editor.imageSameAs(plain, 'redone');
  await page.keyboard.press('Control+z');
  await editor.imageSameAs(brown, 'undone again');

  // An invalid shader is marked on its line; the last valid program plays.
  await editor.press('Edit shader');
  await page.locator('.monaco-editor .view-line').first().waitFor();
  const broken = await typeIntoLine(page, WORKING, 'nonsense ');
  await page.locator('.monaco-editor .squiggly-error').first().waitFor();
  await page.getByText('Showing the last working version').waitFor();
  await page.locator('.status-bar').getByText('error').click();
  const problem = page.getByRole('list', { name: 'Problems' }).getByRole('button').first();
  expect(await problem.textContent()).toMatch(new RegExp(`shaders/sepia[^:]*\\.fs:${broken}`));
  await editor.imageSameAs(brown, 'broken');
  await editor.press('Play');
  const frame = await editor.frame();
  await page.waitForFunction((f) => Number(document.querySelector('.transport-time span')?.textContent) > f + 1, frame);
  await editor.rewind();
  await editor.imageSameAs(brown, 'rewound');

  // A click on the problem goes to the line; a fix removes the mark.
  await problem.click();
  await page.locator('.monaco-editor.focused').waitFor();
  // Undo in the text works by words. Further undo steps do nothing.
  for (let i = 0; i < 4; i++) await page.keyboard.press('Control+z');
  await page.locator('.monaco-editor .squiggly-error').first().waitFor({ state: 'detached' });
  await page.getByText('Showing the last working version').waitFor({ state: 'detached' });
  await editor.imageSameAs(brown, 'mended');

  // A new input in the header becomes a port and a param.
  await typeIntoLine(page, '"INPUTS"', '', ' { "NAME": "darken", "TYPE": "float", "LABEL": "Darken", "MIN": 0, "MAX": 1, "DEFAULT": 0 },');
  await editor.inspector.getByRole('textbox', { name: 'Darken' }).waitFor();
  await typeIntoLine(page, WORKING, '', ' gl_FragColor.rgb *= 1.0 - darken;');
  await editor.settled();
  await editor.inspector.getByRole('textbox', { name: 'Darken' }).fill('0.5');
  await page.keyboard.press('Enter');
  const dark = await editor.imageOtherThan(brown);

  // Saved, and there again after a reload.
  await page.keyboard.press('Control+s');
  await page.locator('.unsaved').waitFor({ state: 'detached' });
  await page.reload();
  await editor.settled();
  await editor.rewind();
  await editor.imageSameAs(dark, 'reloaded');
  expect(await editor.node(sepia).count()).toBe(1);

  // Exported.
  const answered = answerFolder(exportTo);
  await page.getByRole('button', { name: 'Export', exact: true }).first().click();
  await answered;
  await page.getByText(/^Exported to/).waitFor();
}

async function compileStatus(page: Page): Promise<string | undefined> {
  return /Compiled in \d+ ms/.exec((await page.locator('.status-bar').textContent()) ?? '')?.[0];
}

/** The Output node of a project and the node connected to it. */
async function readScreen(project: string): Promise<{ screen: string; source: readonly [node: string, port: string] }> {
  const { graphs } = JSON.parse(await readFile(join(project, 'project.scrim.json'), 'utf8')) as {
    graphs: { main: { nodes: Record<string, { type: string }>; wires: string[] } };
  };
  const { nodes, wires } = graphs.main;
  const screen = Object.keys(nodes).find((id) => nodes[id]?.type === 'output/screen');
  const wire = wires.find((text) => text.endsWith(` -> ${screen}.layer`));
  const [node, port] = wire?.split(' -> ')[0]?.split('.') ?? [];
  if (screen === undefined || node === undefined || port === undefined) throw new Error(`${project} has no screen with a layer.`);
  return { screen, source: [node, port] };
}

/** Types at the start and end of the first line that contains `mark`. Returns its line number. */
async function typeIntoLine(page: Page, mark: string, atStart: string, atEnd = ''): Promise<number> {
  const editor = new EditorDriver(page);
  await editor.findInText(mark);
  await page.locator('.monaco-editor .view-line', { hasText: mark }).first().waitFor();
  const number = await editor.lineNumber();
  await page.keyboard.press('Home');
  await editor.type(atStart);
  await page.keyboard.press('End');
  await editor.type(atEnd);
  return number;
}
