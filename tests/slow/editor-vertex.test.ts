import { readdir, readFile, writeFile } from 'node:fs/promises';
import { join } from 'node:path';
import { expect, test } from '@jest/globals';
import type { Locator } from 'playwright-core';
import { type GraphText, saveGraphs, useEditor } from '../support/open-editor.ts';
import { eventually } from '../support/patience.ts';

const openEditor = useEditor();

const FRAGMENT = `/*{ "ISFVSN": "2", "INPUTS": [
  { "NAME": "inputImage", "TYPE": "image" },
  { "NAME": "amount", "TYPE": "float", "DOC": "How far aside.", "DEFAULT": 0.25 }
] }*/
varying vec2 beside;
void main() {
  gl_FragColor = IMG_NORM_PIXEL(inputImage, beside);
}
`;

const VERTEX = `varying vec2 beside;
void main() {
  isf_vertShaderInit();
  beside = isf_FragNormCoord * amount;
}
`;

/** The camera's picture, taken from elsewhere by a filter that has a vertex shader. */
const ASIDE: GraphText = {
  nodes: {
    'video-aaaa': { type: 'source/camera-video' },
    'aside-aaaa': { type: 'filter/aside' },
    'screen-aaaa': { type: 'output/screen' },
  },
  wires: ['video-aaaa.layer -> aside-aaaa.inputImage', 'aside-aaaa.layer -> screen-aaaa.layer'],
  places: { 'video-aaaa': [0, 0], 'aside-aaaa': [260, 0], 'screen-aaaa': [520, 0] },
  shaders: { 'aside.fs': FRAGMENT, 'aside.vs': VERTEX },
};

function topOf(line: Locator): Promise<number> {
  return line.evaluate((element) => (element as HTMLElement).offsetTop);
}

test('the vertex shader beside an ISF file is edited, marked, renamed with its file and followed outside', async () => {
  const opened = await openEditor(ASIDE);
  const { page, editor, project } = opened;
  await editor.settled();
  const near = await editor.rewind();
  await editor.openCode('aside-aaaa');
  const files = page.getByRole('group', { name: 'File' });
  const header = page.locator('.view-line', { hasText: 'How far aside' });
  await files.getByRole('button', { name: 'Vertex' }).click();
  await page.locator('.view-line', { hasText: 'isf_vertShaderInit' }).waitFor();

  // What is typed plays, and knows the header of the other file.
  await editor.findInText('amount');
  await editor.type('2.0 * ');
  await page.locator('.status-bar').getByText('No problems').waitFor();
  await editor.imageOtherThan(near);

  // An input's name leads to the header in the other file.
  await editor.findInText('amount');
  await page.keyboard.press('F12');
  await page.locator('.view-line', { hasText: 'IMG_NORM_PIXEL' }).waitFor();
  await page.locator('.monaco-editor.focused').waitFor();
  await files.getByRole('button', { name: 'Fragment', pressed: true }).waitFor();
  // The editor draws lines and cursor in a later frame.
  await eventually(async () => expect(await topOf(page.locator('.monaco-editor .cursor').first())).toBe(await topOf(header)));
  await files.getByRole('button', { name: 'Vertex' }).click();
  await page.locator('.view-line', { hasText: 'isf_vertShaderInit' }).waitFor();

  // A mistake is marked here, and its problem leads back here from the other file.
  await editor.findInText('2.0');
  await editor.type('nowhere * ');
  await page.locator('.monaco-editor .squiggly-error').first().waitFor();
  await files.getByRole('button', { name: 'Fragment' }).click();
  await page.locator('.view-line', { hasText: 'IMG_NORM_PIXEL' }).waitFor();
  await page.locator('.status-problems').click();
  const problem = page.getByRole('list', { name: 'Problems' }).getByRole('button', { name: 'nowhere' });
  expect(await problem.textContent()).toContain('shaders/aside.vs:4');
  await problem.click();
  await page.locator('.view-line', { hasText: 'nowhere' }).waitFor();
  await page.locator('.monaco-editor.focused').waitFor();
  await page.keyboard.press('Control+Delete');
  await page.keyboard.press('Delete');
  await page.keyboard.press('Delete');
  await page.locator('.status-bar').getByText('No problems').waitFor();

  // What one hands on to the other is renamed in both, as one step.
  const both = async () => {
    await saveGraphs(opened);
    return Promise.all(['aside.fs', 'aside.vs'].map((name) => readFile(join(project, 'shaders', name), 'utf8')));
  };
  const before = await both();
  await editor.findInText('beside =');
  await page.keyboard.press('F2');
  await page.locator('.rename-box input:focus').fill('elsewhere');
  await page.keyboard.press('Enter');
  await page.locator('.view-line', { hasText: 'elsewhere = ' }).waitFor();
  await files.getByRole('button', { name: 'Fragment' }).click();
  await page.locator('.view-line', { hasText: 'IMG_NORM_PIXEL(inputImage, elsewhere)' }).waitFor();
  await page.locator('.status-bar').getByText('No problems').waitFor();
  expect(await both()).toEqual(before.map((text) => text.replaceAll('beside', 'elsewhere')));
  await editor.node('screen-aaaa').locator('.node-title').click();
  await page.keyboard.press('Control+z');
  await page.locator('.view-line', { hasText: 'IMG_NORM_PIXEL(inputImage, beside)' }).waitFor();
  expect(await both()).toEqual(before);

  // Saved elsewhere, it is followed, and to be read only.
  await files.getByRole('button', { name: 'Vertex' }).click();
  await writeFile(join(project, 'shaders', 'aside.vs'), VERTEX);
  await page.locator('.code-bar').getByText('saved by another program').waitFor();
  await page.locator('.view-line', { hasText: 'isf_FragNormCoord * amount' }).waitFor();
  await editor.imageSameAs(near);
});

/** The camera's picture through a filter of the library. */
const TINTED: GraphText = {
  nodes: {
    'video-aaaa': { type: 'source/camera-video' },
    'sepia-aaaa': { type: 'filter/sepia' },
    'screen-aaaa': { type: 'output/screen' },
  },
  // In the order in which projects are saved.
  wires: ['sepia-aaaa.layer -> screen-aaaa.layer', 'video-aaaa.layer -> sepia-aaaa.inputImage'],
  places: { 'video-aaaa': [0, 0], 'sepia-aaaa': [260, 0], 'screen-aaaa': [520, 0] },
};

test('a vertex shader is begun beside a filter of the library, and taken away', async () => {
  const opened = await openEditor(TINTED);
  const { page, editor, project } = opened;
  await editor.settled();
  const before = await editor.rewind();
  const graphs = await saveGraphs(opened);
  const files = async () => (await readdir(join(project, 'shaders')).catch(() => [])).sort();
  await editor.openCode('sepia-aaaa');
  const add = page.getByRole('button', { name: 'Add vertex shader' });
  await add.click();

  // The filter is the project's own now, and the corners are where they were.
  await page.locator('.view-line', { hasText: 'isf_vertShaderInit' }).waitFor();
  await editor.imageSameAs(before);
  expect((await saveGraphs(opened)).main?.nodes['sepia-aaaa']).toMatchObject({ type: 'filter/sepia-2' });
  expect(await files()).toEqual(['sepia-2.fs', 'sepia-2.vs']);

  // What is written in it moves the picture.
  await editor.findInText('isf_vertShaderInit();');
  await page.keyboard.press('End');
  await editor.type(' gl_Position.x *= 0.5;');
  await page.locator('.status-bar').getByText('No problems').waitFor();
  await editor.imageOtherThan(before);

  // Taken away, the filter is as it was, on the disk too; undo goes all the way back.
  await page.getByRole('button', { name: 'Remove vertex shader' }).click();
  await add.waitFor();
  await page.locator('.view-line', { hasText: '/*{' }).first().waitFor();
  await editor.imageSameAs(before);
  await saveGraphs(opened);
  expect(await files()).toEqual(['sepia-2.fs']);
  await editor.node('screen-aaaa').locator('.node-title').click();
  for (let steps = 0; steps < 3; steps++) await page.keyboard.press('Control+z');
  await page.getByRole('button', { name: 'Undo' }).and(page.locator(':disabled')).waitFor();
  expect(await saveGraphs(opened)).toEqual(graphs);
  expect(await files()).toEqual([]);
});
