import { readdirSync, readFileSync } from 'node:fs';
import { describe, expect, test } from '@jest/globals';
import { decode } from 'fast-png';
import { compile } from '../../export/compiler/compile.ts';
import { makeProject } from '../../tools/examples/paper/recipe.ts';
import { RECIPES } from '../../tools/examples/paper/recipes.ts';
import { expectMadeByScript } from '../support/example-files.ts';
import { LIBRARY } from '../support/library.ts';

/** What they look like is proved in `tests/slow/paper-examples.test.ts`, and to be seen in `docs/gallery.jpg`. */
describe.each(RECIPES.map((recipe) => [recipe.folder, recipe] as const))('the example %s', (folder, recipe) => {
  const project = makeProject(LIBRARY, recipe);

  test('is what the script makes of its recipe, with all its files', () => expectMadeByScript(folder, project));

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

describe('the picture of hands', () => {
  const bytes = readFileSync('examples/skin-colour/assets/hands.png');
  const { width, height, data } = decode(bytes);
  const pixel = (u: number, v: number): number[] =>
    [0, 1, 2].map((i) => data[(Math.floor(v * height) * width + Math.floor(u * width)) * 4 + i] ?? 0);
  /** D. Chai and K. N. Ngan 1999, with Cb and Cr of BT.601. */
  const isSkin = ([r = 0, g = 0, b = 0]: number[]) => {
    const cb = 128 + (-37.797 * r - 74.203 * g + 112 * b) / 255;
    const cr = 128 + (112 * r - 93.786 * g - 18.214 * b) / 255;
    return cb >= 77 && cb <= 127 && cr >= 133 && cr <= 173;
  };

  test('has skin from light to dark where the hands are, and nowhere else', () => {
    const palms = [pixel(0.16, 0.66), pixel(0.38, 0.56), pixel(0.63, 0.68), pixel(0.84, 0.57)];
    expect(palms.map(isSkin)).toEqual([true, true, true, true]);
    const lights = palms.map(([r = 0, g = 0, b = 0]) => 0.3 * r + 0.6 * g + 0.1 * b);
    expect(lights).toEqual([...lights].sort((a, b) => b - a));
    const others = [
      pixel(0.1, 0.2),
      pixel(0.45, 0.1),
      pixel(0.51, 0.31),
      pixel(0.95, 0.6),
      pixel(0.12, 0.9),
      pixel(0.4, 0.85),
      pixel(0.6, 0.9),
      pixel(0.88, 0.85),
      pixel(0.5, 0.95),
    ];
    expect(others.filter(isSkin)).toEqual([]);
  });
});
