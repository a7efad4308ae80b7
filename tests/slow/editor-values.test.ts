import { expect, test } from '@jest/globals';
import type { Locator } from 'playwright-core';
import { type GraphText, saveGraphs, useOneEditor } from '../support/open-editor.ts';

/** The camera's picture, blurred, goes to the screen; a box stands by. */
const GRAPH: GraphText = {
  nodes: {
    'video-aaaa': { type: 'source/camera-video' },
    'gaussian-blur-aaaa': { type: 'filter/gaussian-blur' },
    'transform-aaaa': { type: 'objects/transform' },
    'screen-aaaa': { type: 'output/screen' },
  },
  wires: ['video-aaaa.layer -> gaussian-blur-aaaa.inputImage', 'gaussian-blur-aaaa.layer -> screen-aaaa.layer'],
  places: { 'video-aaaa': [0, 0], 'gaussian-blur-aaaa': [260, 0], 'transform-aaaa': [0, 220], 'screen-aaaa': [520, 0] },
};

const open = useOneEditor(GRAPH, {}, async () => {
  await open.editor.hold();
});

async function select(node: string): Promise<void> {
  await open.editor.node(node).locator('.node-title').click();
}

async function field(name: string): Promise<Locator> {
  const found = open.editor.inspector.getByRole('textbox', { name, exact: true });
  await found.waitFor();
  return found;
}

async function choose(param: string, action: string): Promise<void> {
  await open.editor.inspector.getByRole('group', { name: param, exact: true }).click({ button: 'right', position: { x: 8, y: 8 } });
  await open.page.getByRole('menuitem', { name: action, exact: true }).click();
}

/** The params of a node as the project's file has them. */
async function saved(node: string): Promise<unknown> {
  return (await saveGraphs(open)).main?.nodes[node]?.params;
}

test('sums are worked out, an expression binds the value, and the way back is one undo', async () => {
  const { page } = open;
  await select('gaussian-blur-aaaa');
  const radius = await field('Radius');
  await radius.fill('2*3+1');
  await page.keyboard.press('Enter');
  expect(await radius.inputValue()).toBe('7');
  await radius.fill('=4+sin(time)*2');
  await page.keyboard.press('Enter');
  expect(await (await field('Radius, expression')).inputValue()).toBe('4+sin(time)*2');
  expect(await saved('gaussian-blur-aaaa')).toEqual({ radius: { expression: '4+sin(time)*2' } });
  await page.keyboard.press('Control+z');
  expect(await (await field('Radius')).inputValue()).toBe('7');
});

test('an invalid expression stays for correction, and says what is wrong', async () => {
  const { page, editor } = open;
  await select('gaussian-blur-aaaa');
  const radius = await field('Radius');
  await radius.fill('=4+sine(time)');
  await page.keyboard.press('Enter');
  await page.getByRole('log').getByText('The expression of “Radius” is invalid: Unknown function “sine”').waitFor();
  expect(await radius.inputValue()).toBe('=4+sine(time)');
  await radius.fill('=time');
  await page.keyboard.press('Enter');
  const expression = await field('Radius, expression');
  await expression.fill('time +');
  await editor.inspector.getByRole('status').getByText('Expected a number, a name or a bracket').waitFor();
  expect(await expression.getAttribute('aria-invalid')).toBe('true');
  await expression.fill('');
  await page.keyboard.press('Enter');
  await field('Radius');
});

test('one part of a vector takes an expression and leaves the others', async () => {
  const { page } = open;
  await select('transform-aaaa');
  await (await field('Position X')).fill('0.5');
  await page.keyboard.press('Tab');
  const y = await field('Position Y');
  await y.fill('=sin(time)');
  await page.keyboard.press('Enter');
  const [expression] = Object.values((await saved('transform-aaaa')) as Record<string, { readonly expression?: string }>);
  expect(expression).toEqual({ expression: '[0.5, sin(time), 0]' });
});

test('a value is copied to another param, or to another node; what does not fit is refused', async () => {
  const { page } = open;
  await page.context().grantPermissions(['clipboard-read', 'clipboard-write']);
  await select('transform-aaaa');
  await choose('Position', 'Copy value');
  await choose('Rotation', 'Paste value');
  expect(await (await field('Rotation, expression')).inputValue()).toBe('[0.5, sin(time), 0]');
  await choose('Rotation', 'Use a value');
  await field('Rotation X');
  await select('gaussian-blur-aaaa');
  await choose('Radius', 'Paste value');
  await page.getByRole('log').getByText('The value on the clipboard does not fit “Radius”.').waitFor();
  await (await field('Radius')).fill('3');
  await page.keyboard.press('Enter');
});

test('a value is shown as a port on the node, and hidden again; by keys, too', async () => {
  const { page, editor } = open;
  await select('gaussian-blur-aaaa');
  const port = editor.port('gaussian-blur-aaaa', 'radius', 'target');
  await port.waitFor({ state: 'detached' });
  await editor.inspector.getByRole('button', { name: 'More actions for Radius' }).focus();
  await page.keyboard.press('Enter');
  for (const letter of ['s', 'Enter']) await page.keyboard.press(letter);
  await port.waitFor();
  expect(await page.evaluate(() => document.activeElement?.getAttribute('aria-label'))).toBe('More actions for Radius');
  await choose('Radius', 'Hide the port');
  await port.waitFor({ state: 'detached' });
});
