import { mkdir, readdir, readFile, writeFile } from 'node:fs/promises';
import { join } from 'node:path';
import { expect, test } from '@jest/globals';
import { axeFindings } from '../support/axe.ts';
import { type GraphText, type SavedGraph, saveGraphs, useOneEditor } from '../support/open-editor.ts';
import { eventually } from '../support/patience.ts';

/** The camera's picture, blurred and yellowed, goes to the screen. */
const GRAPH: GraphText = {
  nodes: {
    'video-aaaa': { type: 'source/camera-video' },
    'gaussian-blur-aaaa': { type: 'filter/gaussian-blur', params: { radius: 9 } },
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

const open = useOneEditor(GRAPH, { ownProjects: true }, async () => {
  await open.editor.hold();
});

const title = (node: string) => open.editor.node(node).locator('.node-title');
const dialog = (name: string) => open.page.getByRole('dialog', { name });
const recipes = () => join(open.project, 'projects', 'recipes');

/** Waits until the saved project has so many sepias and as many blurs; nodes outside of the view are not in the page. */
async function countOf(nodes: number): Promise<SavedGraph | undefined> {
  let main: SavedGraph | undefined;
  await eventually(async () => {
    main = (await saveGraphs(open)).main;
    const types = Object.values(main?.nodes ?? {}).map(({ type }) => type);
    for (const wanted of ['filter/sepia', 'filter/gaussian-blur']) expect(types.filter((type) => type === wanted)).toHaveLength(nodes);
  });
  return main;
}

async function openMyRecipes(): Promise<void> {
  await open.page.keyboard.press('Control+k');
  await open.page.getByRole('combobox', { name: 'Command' }).fill('my recipes');
  await open.page.keyboard.press('Enter');
  await dialog('My recipes').waitFor();
}

test('selected nodes are saved as a recipe by their menu', async () => {
  const { page } = open;
  await title('gaussian-blur').click();
  await title('sepia').click({ modifiers: ['Shift'] });
  await title('sepia').click({ button: 'right' });
  await page.getByRole('menuitem', { name: 'Save as recipe…', exact: true }).click();
  const form = dialog('Save as recipe');
  await form.getByText('Inputs: Layer. Outputs: Layer.').waitFor();
  expect(await form.getByRole('textbox', { name: 'Description' }).inputValue()).toBe('Adds Gaussian blur and Sepia.');
  await form.getByRole('textbox', { name: 'Name' }).fill(' ');
  await form.getByText('The recipe needs a name.').waitFor();
  expect(await form.getByRole('button', { name: 'Save' }).isDisabled()).toBe(true);
  expect(await axeFindings(page)).toEqual([]);
  await form.getByRole('textbox', { name: 'Name' }).fill('Old film');
  await form.getByRole('textbox', { name: 'Search words' }).fill('celluloid, cinema');
  await page.keyboard.press('Enter');
  await form.waitFor({ state: 'detached' });
  await page.getByText('Saved the recipe “Old film”. The node search finds it.').waitFor();
  expect(await readdir(recipes())).toEqual(['old-film']);
});

test('the palette adds it at once, shown, and one undo takes it away', async () => {
  await open.editor.addNode('celluloid');
  const main = await countOf(2);
  const blurs = Object.values(main?.nodes ?? {}).filter(({ type }) => type === 'filter/gaussian-blur');
  expect(blurs.map(({ params }) => params)).toEqual([{ radius: 9 }, { radius: 9 }]);
  // It continues what the output shows.
  const [added] = Object.keys(main?.nodes ?? {}).filter((id) => id.startsWith('sepia-') && id !== 'sepia-aaaa');
  expect(main?.wires).toContain(`${added}.layer -> screen-aaaa.layer`);
  await open.page.keyboard.press('Control+z');
  await countOf(1);
});

test('it is still there after a reload', async () => {
  await saveGraphs(open);
  await open.page.reload();
  await title('sepia').waitFor();
  await open.editor.addNode('old film');
  await countOf(2);
  await open.page.keyboard.press('Control+z');
  await countOf(1);
});

test('a broken one is left out with its name and the reason, and the others stay', async () => {
  const { page } = open;
  await mkdir(join(recipes(), 'torn'));
  await writeFile(join(recipes(), 'torn', 'project.scrim.json'), '{ "format": "scrim-project", "version": 1,');
  await open.editor.addNode('old film');
  await page.getByText(/The recipe “torn” was left out\. project\.scrim\.json:1: /).waitFor();
  await countOf(2);
  await page.keyboard.press('Control+z');
  await countOf(1);
});

test('“My recipes” opens one as a project, which renames it, and deletes it', async () => {
  const { page } = open;
  await saveGraphs(open);
  await openMyRecipes();
  await dialog('My recipes').getByText('The recipe “torn” was left out.').waitFor();
  expect(await axeFindings(page)).toEqual([]);
  await dialog('My recipes')
    .getByRole('button', { name: /^Old film/ })
    .click();
  await title('recipe').waitFor();
  await open.editor.inspector.getByRole('textbox', { name: 'Title' }).fill('Silent film');
  const words = open.editor.inspector.getByRole('textbox', { name: 'Search words' });
  expect(await words.inputValue()).toBe('celluloid, cinema');
  await words.press('End');
  await words.pressSequentially(', mute');
  await page.keyboard.press('Tab');
  await page.keyboard.press('Control+s');
  await page.locator('.unsaved').waitFor({ state: 'detached' });
  const saved = await readFile(join(recipes(), 'old-film', 'project.scrim.json'), 'utf8');
  expect(JSON.parse(saved).recipe).toEqual({ keywords: ['celluloid', 'cinema', 'mute'] });
  await openMyRecipes();
  await dialog('My recipes').getByRole('button', { name: 'Delete torn' }).click();
  await dialog('My recipes').getByText('was left out').waitFor({ state: 'detached' });
  // The open one stays.
  await dialog('My recipes').getByRole('button', { name: 'Delete Silent film' }).click();
  await page.getByText('This recipe is open. Open another project first.').waitFor();
  expect((await readdir(recipes())).sort()).toEqual(['.removed', 'old-film']);
  await page.keyboard.press('Escape');
});
