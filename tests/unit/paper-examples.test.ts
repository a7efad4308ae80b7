import { readdirSync, readFileSync } from 'node:fs';
import { describe, expect, test } from '@jest/globals';
import { compile } from '../../export/compiler/compile.ts';
import { saveProject } from '../../export/graph/save.ts';
import { makeProject } from '../../tools/examples/paper/recipe.ts';
import { RECIPES } from '../../tools/examples/paper/recipes.ts';
import { makeStrokes } from '../../tools/examples/paper/strokes.ts';
import { LIBRARY } from '../support/library.ts';

/** What they look like is proved in `tests/slow/paper-examples.test.ts`, and to be seen in `docs/gallery.jpg`. */
describe.each(RECIPES.map((recipe) => [recipe.folder, recipe] as const))('the example %s', (folder, recipe) => {
  const project = makeProject(LIBRARY, recipe);

  test('is what the script makes of its recipe, with all its files', () => {
    const saved = saveProject(project);
    expect(readFileSync(`examples/${folder}/project.scrim.json`, 'utf8')).toBe(saved.project);
    expect(readFileSync(`examples/${folder}/project.layout.json`, 'utf8')).toBe(saved.layout);
    for (const { path } of Object.values(project.assets)) expect(readFileSync(`examples/${folder}/${path}`).length).toBeGreaterThan(1000);
  });

  test('compiles without a word', () => {
    const { output, diagnostics } = compile({ project, library: LIBRARY });
    expect(diagnostics).toEqual([]);
    expect(output).not.toBeNull();
  });

  test('says what it shows', () => {
    expect(recipe.title).not.toBe('');
    expect(recipe.description.length).toBeGreaterThan(40);
  });
});

test('every figure from 4 to 14 that shows a picture has an example', () => {
  const figures = new Set(RECIPES.map(({ figure }) => Number.parseInt(figure, 10)));
  // Figure 5 is the graphs of figure 4.
  expect([4, 6, 8, 9, 10, 11, 12, 13, 14].filter((figure) => !figures.has(figure))).toEqual([]);
});

test('no two examples have one name or one title', () => {
  for (const key of ['folder', 'title', 'figure'] as const) {
    const all = RECIPES.map((recipe) => recipe[key]);
    expect([key, all.filter((one, i) => all.indexOf(one) !== i)]).toEqual([key, []]);
  }
  expect(readdirSync('examples')).toEqual(expect.arrayContaining(RECIPES.map(({ folder }) => folder)));
});

test('the sheet of pencil strokes comes out the same every time', () => {
  expect(Buffer.compare(readFileSync('examples/sketchy-shadow/assets/strokes.png'), makeStrokes())).toBe(0);
});
