import { readFileSync } from 'node:fs';
import { resolve } from 'node:path';
import { expect, test } from '@jest/globals';
import { compile } from '../../export/compiler/compile.ts';
import { loadProject } from '../../export/graph/load.ts';
import type { Program } from '../../export/program/program.ts';
import { RECIPES } from '../../tools/examples/paper/recipes.ts';
import type { Played } from '../browser/runtime-examples.page.ts';
import { useModule } from '../support/browser.ts';
import { LIBRARY } from '../support/library.ts';

const page = useModule('tests/browser/runtime-examples.page.ts', { mounts: { '/examples/': resolve('examples') } });

const CAMERA = [100, 150, 200, 255];
const ROOM_M = 3;

function compileExample(folder: string): Program {
  const text = readFileSync(`examples/${folder}/project.scrim.json`, 'utf8');
  const { output: project, diagnostics } = loadProject({ project: text, layout: null, sources: {} });
  const compiled = project ? compile({ project, library: LIBRARY }) : null;
  if (!compiled?.output) throw new Error(JSON.stringify([diagnostics, compiled?.diagnostics]));
  return compiled.output;
}

test.each(RECIPES.map(({ folder }) => folder))('the example %s plays without a word, and shows something', async (folder) => {
  const { diagnostics, error, corner } = await page.call<Played>(
    'play',
    compileExample(folder),
    `examples/${folder}/`,
    0.5,
    CAMERA,
    ROOM_M,
  );
  expect({ diagnostics, error }).toEqual({ diagnostics: [], error: 0 });
  expect(corner[3]).toBe(255);
});
