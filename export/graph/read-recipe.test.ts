import { describe, expect, test } from '@jest/globals';
import { RECIPES } from '../../nodes/generated/recipes.gen.ts';
import { LIBRARY } from '../../tests/support/library.ts';
import { newProject } from './new-project.ts';
import type { Project } from './project.ts';
import { RECIPE_GRAPH, readRecipe } from './read-recipe.ts';
import { saveProject } from './save.ts';
import { validateProject } from './validate/validate.ts';

const SHIPPED = Object.entries(RECIPES);
const SEPIA = { nodes: { 'sepia-a1b2': { type: 'filter/sepia', version: 1, params: {} } }, wires: [] };
const EXPOSED = {
  inputs: [{ name: 'picture', node: 'sepia-a1b2', port: 'inputImage' }],
  outputs: [{ name: 'layer', node: 'sepia-a1b2', port: 'layer' }],
};
const RECIPE: Project = {
  ...newProject('Old photo'),
  graphs: { ...newProject('').graphs, [RECIPE_GRAPH]: { ...SEPIA, exposed: EXPOSED } },
  recipe: { keywords: ['brown', 'age'] },
};

/** What is wrong with a project as a recipe. */
const problemsOf = (project: Project) => readRecipe(saveProject(project)).diagnostics.map(({ code, message }) => `${code}: ${message}`);

describe('a recipe', () => {
  test('is a project like any other, with keywords', () => {
    const { output, diagnostics } = readRecipe(saveProject(RECIPE));
    expect(diagnostics).toEqual([]);
    expect(output).toEqual(RECIPE);
  });

  test('without keywords stays a recipe', () => {
    const { output } = readRecipe(saveProject({ ...RECIPE, recipe: { keywords: [] } }));
    expect(output?.recipe).toEqual({ keywords: [] });
  });

  test('says of itself that it shows nothing, and where it is used', () => {
    const [problem, ...others] = validateProject(RECIPE, LIBRARY).filter(({ code }) => code === 'SCR017');
    expect(others).toEqual([]);
    expect(problem?.message).toContain('A recipe shows nothing by itself');
    expect(problem?.fix).toContain('from the palette');
  });

  test('has the key, a title and nodes', () => {
    const { recipe: _, ...ordinary } = RECIPE;
    expect(problemsOf(ordinary)).toEqual(['SCR002: The project is no recipe: the key “recipe” is missing.']);
    expect(problemsOf({ ...RECIPE, title: ' ' })).toEqual(['SCR002: The recipe has no title.']);
    expect(problemsOf({ ...RECIPE, graphs: newProject('').graphs })).toEqual(['SCR002: The recipe has no nodes in a subgraph “recipe”.']);
  });

  test('needs nothing of a project', () => {
    const glow = {
      nodes: { 'glow-a1b2': { type: 'graph/glow', version: 1, params: {} } },
      wires: [],
      exposed: { inputs: [], outputs: [] },
    };
    expect(problemsOf({ ...RECIPE, graphs: { ...RECIPE.graphs, [RECIPE_GRAPH]: glow } })).toEqual([
      'SCR002: The recipe contains the subgraph “glow”. Ungroup it.',
    ]);
    expect(problemsOf({ ...RECIPE, assets: { cup: { path: 'assets/cup.png', kind: 'image' } } })).toEqual([
      'SCR002: The recipe uses the file “assets/cup.png” of a project. Remove it.',
    ]);
  });

  test('of a wrong shape says where', () => {
    const text = saveProject(RECIPE).project.replace('["brown", "age"]', '["brown", 7]');
    const [problem] = readRecipe({ project: text, layout: null, sources: {} }).diagnostics;
    expect(problem).toMatchObject({ code: 'SCR002', file: 'project.scrim.json' });
    expect(text.split('\n')[(problem?.line ?? 0) - 1]).toContain('7');
  });
});

test.each(SHIPPED)('the recipe %s is written as Scrim saves it, and opens without problems', (_, texts) => {
  const { output } = readRecipe({ ...texts, sources: {} });
  if (output === null) throw new Error('It cannot be read.');
  expect(saveProject(output)).toMatchObject(texts);
  // It has no output of its own, and what its inputs need comes with the graph that it is added to.
  const { inputs } = output.graphs[RECIPE_GRAPH]?.exposed ?? { inputs: [] };
  const errors = validateProject(output, LIBRARY).filter(({ code, severity }) => severity === 'error' && code !== 'SCR017');
  expect(errors.filter(({ nodeId, port }) => !inputs.some((input) => input.node === nodeId && input.port === port))).toEqual([]);
});
