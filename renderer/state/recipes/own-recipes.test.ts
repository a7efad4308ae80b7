import { describe, expect, test } from '@jest/globals';
import { MAIN_GRAPH } from '../../../export/graph/project.ts';
import { RECIPE_GRAPH } from '../../../export/graph/read-recipe.ts';
import { saveProject } from '../../../export/graph/save.ts';
import { openTestEditor } from '../../../tests/support/test-editor.ts';
import { undo } from '../document/apply.ts';
import { graphOf, nodeOf } from '../editor/document.ts';
import type { Editor } from '../editor/editor.ts';
import { selectOnly } from '../editor/selection.ts';
import { filesOf } from '../files/files.ts';
import { addNodeFromPalette, connect } from '../graph/edit-graph.ts';
import { recipeOfEntry, recipesOf } from '../graph/recipes.ts';
import { addRecipeShown } from '../graph/show-recipe.ts';
import { createSubgraph } from '../graph/subgraphs.ts';
import { editParam } from '../params/edit-params.ts';
import { listRecipes } from './list-recipes.ts';
import { recipeOfSelection } from './recipe-of-selection.ts';
import { describeRecipe, recipeTitleProblem, removeRecipe, saveRecipe } from './save-recipe.ts';

const AT = { x: 0, y: 0 };
const TYPE = 'combination/own-old-film';

function add(editor: Editor, type: string): string {
  const definition = editor.document.getState().library.definition(type);
  const id = definition && addNodeFromPalette(editor, { definition, port: null }, AT, null);
  if (!id) throw new Error(`There is no ${type}.`);
  return id;
}

/** Camera → sepia → blur → screen, with the filters selected. */
async function filmed() {
  const { editor, host } = await openTestEditor();
  const [camera, sepia, blur, screen] = ['source/camera-video', 'filter/sepia', 'filter/gaussian-blur', 'output/screen'].map((type) =>
    add(editor, type),
  ) as [string, string, string, string];
  connect(editor, { node: camera, port: 'layer' }, { node: sepia, port: 'inputImage' });
  connect(editor, { node: sepia, port: 'layer' }, { node: blur, port: 'inputImage' });
  connect(editor, { node: blur, port: 'layer' }, { node: screen, port: 'layer' });
  editParam(editor, sepia, 'amount', 0.4);
  selectOnly(editor.selection, [sepia, blur]);
  return { editor, host, camera, sepia, blur, screen };
}

function projectOf(editor: Editor) {
  const recipe = recipeOfSelection(editor);
  if ('problem' in recipe) throw new Error(recipe.problem);
  return recipe.project;
}

const problemOf = (editor: Editor) => {
  const recipe = recipeOfSelection(editor);
  return 'problem' in recipe ? recipe.problem : null;
};

const saveOldFilm = (editor: Editor) =>
  saveRecipe(editor, projectOf(editor), { title: 'Old film', description: 'Brown and soft.', keywords: ['celluloid'] });
const wiresOf = (editor: Editor) => {
  const typeOf = (id: string) => nodeOf(editor.document.getState(), id)?.type.split('/')[1];
  return graphOf(editor.document.getState()).wires.map(({ from, to }) => `${typeOf(from.node)} > ${typeOf(to.node)}.${to.port}`);
};

describe('a recipe of the selected nodes', () => {
  test('has the wires to nodes outside as ports, and the params', async () => {
    const { editor, sepia, blur } = await filmed();
    const graph = projectOf(editor).graphs[RECIPE_GRAPH];
    expect(graph?.exposed).toEqual({
      inputs: [{ name: 'inputImage', node: sepia, port: 'inputImage' }],
      outputs: [{ name: 'layer', node: blur, port: 'layer' }],
    });
    expect(graph?.nodes[sepia]?.params).toEqual({ amount: { value: 0.4 } });
    expect(describeRecipe(editor, projectOf(editor))).toBe('Adds Gaussian blur and Sepia.');
  });

  test('without wires has its required inputs and its last output as ports', async () => {
    const { editor } = await openTestEditor();
    const sepia = add(editor, 'filter/sepia');
    selectOnly(editor.selection, [sepia]);
    expect(projectOf(editor).graphs[RECIPE_GRAPH]?.exposed).toEqual({
      inputs: [{ name: 'inputImage', node: sepia, port: 'inputImage' }],
      outputs: [{ name: 'layer', node: sepia, port: 'layer' }],
    });
  });

  test('is found by the palette at once, and comes shown, in one step', async () => {
    const { editor } = await filmed();
    const before = filesOf(editor);
    expect(await saveOldFilm(editor)).toBe(true);
    expect(filesOf(editor)).toEqual(before);
    const recipe = recipeOfEntry(editor, TYPE);
    expect(recipe?.definition).toMatchObject({ title: 'Old film', doc: 'Brown and soft.' });
    if (!recipe) return;
    addRecipeShown(editor, recipe, undefined, AT);
    expect(wiresOf(editor).sort()).toEqual([
      'camera-video > sepia.inputImage',
      'gaussian-blur > screen.layer',
      'gaussian-blur > sepia.inputImage',
      'sepia > gaussian-blur.inputImage',
      'sepia > gaussian-blur.inputImage',
    ]);
    const copies = Object.values(graphOf(editor.document.getState()).nodes).filter(({ type }) => type === 'filter/sepia');
    expect(copies.map(({ params }) => params)).toEqual([{ amount: { value: 0.4 } }, { amount: { value: 0.4 } }]);
    undo(editor);
    expect(filesOf(editor)).toEqual(before);
  });

  test('may be made inside a subgraph, whose exposed ports are ports of it, too', async () => {
    const { editor, sepia, blur } = await filmed();
    createSubgraph(editor);
    editor.document.setState({ graph: 'subgraph', trail: [MAIN_GRAPH] });
    selectOnly(editor.selection, [sepia, blur]);
    expect(projectOf(editor).graphs[RECIPE_GRAPH]?.exposed.inputs).toEqual([{ name: 'inputImage', node: sepia, port: 'inputImage' }]);
  });

  test('refuses by name what only this project has, and the output', async () => {
    const { editor, screen, sepia } = await filmed();
    selectOnly(editor.selection, [sepia, screen]);
    expect(problemOf(editor)).toMatch(/^Output must stay in the main graph. Leave it out of the recipe/);
    selectOnly(editor.selection, [sepia]);
    createSubgraph(editor);
    expect(problemOf(editor)).toBe('“Subgraph” is a subgraph of this project. Ungroup it, or leave it out of the selection.');
    const image = add(editor, 'source/image-file');
    editor.document.setState(({ project }) => ({ project: { ...project, assets: { cup: { path: 'assets/cup.png', kind: 'image' } } } }));
    editParam(editor, image, 'file', 'cup');
    selectOnly(editor.selection, [image]);
    expect(problemOf(editor)).toMatch(/uses the file assets\/cup\.png of this project/);
  });

  test('needs a name that no other has', async () => {
    const { editor } = await filmed();
    await saveOldFilm(editor);
    const { getState } = editor.recipes;
    expect(recipeTitleProblem(getState(), 'OLD film')).toBe('There already is a recipe of this name.');
    expect(recipeTitleProblem(getState(), ' ')).toBe('The recipe needs a name.');
    expect(recipeTitleProblem(getState(), 'Alter Film')).toBeNull();
  });
});

describe('the library of recipes', () => {
  test('leaves out broken ones, and says once which and why; the others stay', async () => {
    const { editor, host } = await filmed();
    const good = saveProject({ ...projectOf(editor), title: 'Old film' });
    const bad = saveProject({ ...projectOf(editor), title: 'From afar' });
    const place = (name: string) => ({ name, path: `/home/me/Scrim/recipes/${name}`, problem: null });
    host.answer('recipe.list', () => [
      { ...place('cut-off'), files: { ...good, project: good.project.slice(0, 80) } },
      { ...place('from-afar'), files: { ...bad, project: bad.project.replace('filter/sepia', 'filter/nowhere') } },
      { ...place('locked'), files: null, problem: { code: 'SCR004', severity: 'error', message: 'No permission.' } },
      { ...place('old-film'), files: good },
    ]);
    await listRecipes(editor);
    const toasts = () => editor.ui.getState().toasts.map(({ text }) => text);
    expect(toasts()).toEqual([
      expect.stringMatching(/^The recipe “cut-off” was left out\. project\.scrim\.json:\d+: /),
      expect.stringMatching(/^The recipe “from-afar” was left out\. .*filter\/nowhere/),
      'The recipe “locked” was left out. No permission.',
    ]);
    const own = recipesOf(editor.document.getState().library, editor.recipes.getState().own).filter(({ definition }) =>
      definition.type.startsWith('combination/own-'),
    );
    expect(own.map(({ definition }) => definition.title)).toEqual(['Old film']);
    editor.ui.setState({ toasts: [] });
    await listRecipes(editor);
    expect(toasts()).toEqual([]);
  });

  test('follows the title of a recipe that was edited as a project, and lets one go', async () => {
    const { editor, host } = await filmed();
    await saveOldFilm(editor);
    const [saved] = await host.call('recipe.list', {});
    if (!saved?.files) throw new Error('Nothing was saved.');
    const renamed = { ...saved, files: { ...saved.files, project: saved.files.project.replace('"Old film"', '"Silent film"') } };
    host.answer('recipe.list', () => [renamed]);
    await listRecipes(editor);
    expect(recipeOfEntry(editor, TYPE)?.definition.title).toBe('Silent film');
    host.answer('recipe.list', () => []);
    await removeRecipe(editor, saved);
    expect(recipeOfEntry(editor, TYPE)).toBeUndefined();
  });
});
