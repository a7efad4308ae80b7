import { expect, test } from '@jest/globals';
import { type GraphText, saveGraphs, useOneEditor } from '../support/open-editor.ts';
import { eventually } from '../support/patience.ts';

/** A sepia without a connection, to be two subgraphs deep; an alpha over in the main graph is not connected either. */
const GRAPH: GraphText = {
  nodes: {
    'video-aaaa': { type: 'source/camera-video' },
    'sepia-aaaa': { type: 'filter/sepia' },
    'over-aaaa': { type: 'operator/over' },
    'screen-aaaa': { type: 'output/screen' },
  },
  wires: ['video-aaaa.layer -> screen-aaaa.layer', 'sepia-aaaa.layer -> over-aaaa.top'],
  places: { 'video-aaaa': [0, 0], 'sepia-aaaa': [0, 220], 'over-aaaa': [300, 220], 'screen-aaaa': [600, 0] },
};

const open = useOneEditor(GRAPH, {}, async () => {
  const { page, editor } = open;
  await editor.hold();
  await editor.node('sepia').locator('.node-title').click();
  for (const name of ['Inner', 'Outer']) {
    await page.keyboard.press('Control+g');
    const field = editor.inspector.getByRole('textbox', { name: 'Name' });
    await field.fill(name);
    await page.keyboard.press('Enter');
    await editor.node('subgraph').locator('.node-title').getByText(name).waitFor();
    await editor.node('subgraph').locator('.node-title').click();
  }
});

/** The titles of the graphs on the way to the open one. */
async function way(): Promise<readonly string[]> {
  const trail = open.page.getByRole('navigation', { name: 'Subgraphs' });
  return (await trail.count()) === 0 ? [] : trail.locator('button, [aria-current]').allTextContents();
}

async function expectAt(graphs: readonly string[], node: string): Promise<void> {
  await open.editor.inspector.getByRole('heading', { name: node, exact: true }).waitFor();
  await eventually(async () => expect(await way()).toEqual(graphs));
}

test('a problem leads to its node, also two subgraphs deep, and from there back to the main graph', async () => {
  const { page } = open;
  await page.keyboard.press('Control+m');
  const problems = page.getByRole('list', { name: 'Problems' });
  // A warning: nothing on screen depends on it.
  await problems.getByRole('button', { name: /^warning.*of Sepia is not connected/ }).click();
  await expectAt(['Main graph', 'Outer', 'Inner'], 'Sepia');
  await problems.getByRole('button', { name: /^warning.*of Alpha over is not connected/ }).click();
  await expectAt([], 'Alpha over');
  await page.keyboard.press('Control+m');
});

test('what is found in a graph is shown with the whole way to it, so that its picture is the one that it has there', async () => {
  const { page, editor } = open;
  await page.keyboard.press('Control+f');
  await page.getByRole('combobox', { name: 'Name or value' }).fill('sepia');
  await page.keyboard.press('Enter');
  await expectAt(['Main graph', 'Outer', 'Inner'], 'Sepia');
  await page.keyboard.press('u');
  await page.getByRole('navigation', { name: 'Subgraphs' }).waitFor();
  expect(await way()).toEqual(['Main graph', 'Outer']);
  await page.keyboard.press('u');
  await editor.node('screen').waitFor();
});

test('a command is found by the beginning of its name before the middle', async () => {
  const { page } = open;
  await page.keyboard.press('Control+k');
  await page.getByRole('combobox', { name: 'Command' }).fill('re');
  const first = page.getByRole('listbox', { name: 'Commands' }).getByRole('option').first();
  await first.getByText(/^Re/).waitFor();
  await page.keyboard.press('Escape');
  expect(Object.keys(await saveGraphs(open))).toHaveLength(3);
});
