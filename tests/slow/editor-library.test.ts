import { expect, test } from '@jest/globals';
import { axeFindings } from '../support/axe.ts';
import { type GraphText, openEditor, saveGraphs, useOneEditor } from '../support/open-editor.ts';

/** The camera's picture, blurred and yellowed, goes to the screen. */
const GRAPH: GraphText = {
  nodes: {
    'video-aaaa': { type: 'source/camera-video' },
    'gaussian-blur-aaaa': { type: 'filter/gaussian-blur' },
    'sepia-aaaa': { type: 'filter/sepia' },
    'screen-aaaa': { type: 'output/screen' },
  },
  wires: [
    'video-aaaa.layer -> gaussian-blur-aaaa.inputImage',
    'gaussian-blur-aaaa.layer -> sepia-aaaa.inputImage',
    'sepia-aaaa.layer -> screen-aaaa.layer',
  ],
  places: { 'video-aaaa': [0, 0], 'gaussian-blur-aaaa': [240, 0], 'sepia-aaaa': [480, 0], 'screen-aaaa': [720, 0] },
};
const OTHER: GraphText = {
  nodes: { 'video-bbbb': { type: 'source/camera-video' }, 'screen-bbbb': { type: 'output/screen' } },
  wires: ['video-bbbb.layer -> screen-bbbb.layer'],
  places: { 'video-bbbb': [0, 0], 'screen-bbbb': [520, 0] },
};

const open = useOneEditor(GRAPH, {}, async () => {
  await open.editor.hold();
});

const library = () => open.editor.inspector.getByRole('region', { name: 'Library' });
const title = (node: string) => open.editor.node(node).locator('.node-title');
const menuItem = (name: string) => open.page.getByRole('menuitem', { name, exact: true });

async function selectNothing(): Promise<void> {
  await open.page.keyboard.press('Escape');
  const { x, y } = await open.editor.emptyPlace();
  await open.page.mouse.click(x, y);
  await library().waitFor();
}

async function typesInMain(): Promise<readonly string[]> {
  const { main } = await saveGraphs(open);
  return Object.values(main?.nodes ?? {})
    .map(({ type }) => type)
    .sort();
}

/** Waits for so many nodes that stand for the subgraph. */
async function countOf(name: string, nodes: number): Promise<void> {
  await open.page.waitForFunction(
    ([text, count]) => [...document.querySelectorAll('.node-title')].filter((element) => element.textContent === text).length === count,
    [name, nodes] as const,
  );
}

test('a subgraph is saved to the library by its menu, and one says how to make the first', async () => {
  const { page, editor } = open;
  await selectNothing();
  await library().getByText('Select nodes and press Ctrl+G').waitFor();
  await title('gaussian-blur').click();
  await title('sepia').click({ modifiers: ['Shift'] });
  await page.keyboard.press('Control+g');
  await title('subgraph').click({ button: 'right' });
  await menuItem('Save to the library…').click();
  const dialog = page.getByRole('dialog', { name: 'Save to the library' });
  const name = dialog.getByRole('textbox', { name: 'Name' });
  await name.fill('42');
  await dialog.getByText('The name must begin with a letter.').waitFor();
  expect(await dialog.getByRole('button', { name: 'Save' }).isDisabled()).toBe(true);
  expect(await axeFindings(page)).toEqual([]);
  await name.fill('Old film');
  await page.keyboard.press('Enter');
  await dialog.waitFor({ state: 'detached' });
  await page.getByText('Saved “Old film” to the library of this project.').waitFor();
  await title('subgraph').getByText('Old film').waitFor();
  await page.keyboard.press('Control+z');
  await title('subgraph').getByText('Subgraph', { exact: true }).waitFor();
  await page.keyboard.press('Control+Shift+z');
  await title('subgraph').getByText('Old film').waitFor();
  expect(await editor.inspector.getByRole('button', { name: 'Save to the library…' }).count()).toBe(1);
});

test('the command is among all commands', async () => {
  const { page } = open;
  await title('subgraph').click();
  await page.keyboard.press('Control+k');
  await page.getByRole('combobox', { name: 'Command' }).fill('library');
  await page.keyboard.press('Enter');
  await page.getByRole('dialog', { name: 'Save to the library' }).getByText('Used by 1 node in the main graph').waitFor();
  await page.keyboard.press('Escape');
});

test('Tab finds it as a node of the project’s own; the list puts in more, by a press and by a drag', async () => {
  const { page, editor } = open;
  await editor.addNode('old fi');
  await countOf('Old film', 2);
  await selectNothing();
  await library().getByText('2×').waitFor();
  await library().getByRole('button', { name: 'Add Old film to the graph' }).click();
  await countOf('Old film', 3);
  await selectNothing();
  const { x, y } = await editor.emptyPlace();
  const canvas = await page.locator('.canvas').boundingBox();
  if (!canvas) throw new Error('There is no canvas.');
  await library()
    .getByText('Old film')
    .dragTo(page.locator('.canvas'), { targetPosition: { x: x - canvas.x, y: y - canvas.y } });
  await countOf('Old film', 4);
  const { x: left, y: top } = (await page.locator('.react-flow__node.selected').boundingBox()) ?? { x: 0, y: 0 };
  expect([Math.abs(left - x) < 12, Math.abs(top - y) < 12]).toEqual([true, true]);
  expect((await typesInMain()).filter((type) => type === 'graph/old-film')).toHaveLength(4);
});

test('what is changed in it once, all of them follow', async () => {
  const { page, editor } = open;
  await title('subgraph').first().dblclick();
  await title('sepia').click();
  await editor.inspector.getByRole('switch', { name: 'Amount, parameter' }).click();
  const way = page.getByRole('navigation', { name: 'Subgraphs' });
  await way.getByRole('button', { name: 'Main graph' }).click();
  await way.waitFor({ state: 'detached' });
  await title('subgraph').last().click();
  await editor.inspector.getByRole('textbox', { name: 'Amount' }).waitFor();
  await title('subgraph').first().click();
  await editor.inspector.getByRole('textbox', { name: 'Amount' }).waitFor();
});

test('renamed in the list, all of them take the name; a name that is taken is said', async () => {
  const { page } = open;
  await selectNothing();
  await library().getByRole('button', { name: 'More actions for Old film' }).click();
  expect(await axeFindings(page)).toEqual([]);
  await menuItem('Rename…').click();
  const dialog = page.getByRole('dialog', { name: 'Rename “Old film”' });
  await dialog.getByText('4 nodes in the main graph').waitFor();
  await dialog.getByRole('textbox', { name: 'Name' }).fill('Worn print');
  await dialog.getByRole('button', { name: 'Rename' }).click();
  await countOf('Worn print', 4);
  expect((await typesInMain()).filter((type) => type === 'graph/worn-print')).toHaveLength(4);
});

test('copied to another project, it brings its definition along, for its library too', async () => {
  const { page } = open;
  const other = await openEditor(open.browser, OTHER);
  try {
    await page.bringToFront();
    await title('subgraph').first().click();
    await page.keyboard.press('Control+c');
    await other.page.bringToFront();
    await other.page.keyboard.press('Control+v');
    await other.editor.node('worn-print').locator('.node-title').getByText('Worn print').waitFor();
    const graphs = await saveGraphs(other);
    expect(Object.keys(graphs)).toEqual(['main', 'worn-print']);
    expect(Object.values(graphs['worn-print']?.nodes ?? {}).map(({ type }) => type)).toEqual(['filter/gaussian-blur', 'filter/sepia']);
    await other.editor.addNode('worn');
    await other.page.waitForFunction(
      () => [...document.querySelectorAll('.node-title')].filter(({ textContent }) => textContent === 'Worn print').length === 2,
    );
    for (let step = 0; step < 2; step++) await other.page.keyboard.press('Control+z');
    expect(Object.keys(await saveGraphs(other))).toEqual(['main']);
    expect(other.errors).toEqual([]);
  } finally {
    await other.close();
  }
  await page.bringToFront();
});

test('removed from the library, it says what uses it, and leaves the picture as it was; undo brings all back', async () => {
  const { page, editor } = open;
  await selectNothing();
  const before = JSON.stringify(await saveGraphs(open));
  const picture = await editor.rewind();
  await library().getByText('Worn print').click({ button: 'right' });
  await menuItem('Remove…').click();
  const dialog = page.getByRole('dialog', { name: 'Remove “Worn print” from the library?' });
  await dialog.getByText('Used by 4 nodes in the main graph.').waitFor();
  expect(await axeFindings(page)).toEqual([]);
  await dialog.getByRole('button', { name: 'Ungroup and remove' }).click();
  await countOf('Worn print', 0);
  const graphs = await saveGraphs(open);
  expect(Object.keys(graphs)).toEqual(['main']);
  expect(Object.values(graphs.main?.nodes ?? {}).filter(({ type }) => type === 'filter/sepia')).toHaveLength(4);
  await editor.settled();
  await editor.imageSameAs(picture, 'unpacked');
  await page.keyboard.press('Control+z');
  await countOf('Worn print', 4);
  expect(JSON.stringify(await saveGraphs(open))).toBe(before);
});

test('one that nothing uses is taken out at once', async () => {
  const { page } = open;
  await page.keyboard.press('Control+a');
  await page.keyboard.press('Delete');
  await countOf('Worn print', 0);
  await library().getByText('not used').waitFor();
  await library().getByRole('button', { name: 'More actions for Worn print' }).click();
  await menuItem('Remove').click();
  await library().getByText('Worn print').waitFor({ state: 'detached' });
  for (let step = 0; step < 2; step++) await page.keyboard.press('Control+z');
  await countOf('Worn print', 4);
});
