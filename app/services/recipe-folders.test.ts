import { mkdir, mkdtemp, readdir, readFile, rm, symlink, writeFile } from 'node:fs/promises';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { afterEach, beforeEach, expect, test } from '@jest/globals';
import { HOST_CONTRACT } from '../contract/contract.ts';
import { NODE_FILES } from './file-layer.ts';
import { listRecipes, removeRecipe, saveRecipe } from './recipe-folders.ts';

const TEXTS = { project: '{"title":"Glow"}\n', layout: '{}\n' };

let projects = '';
beforeEach(async () => {
  projects = await mkdtemp(join(tmpdir(), 'scrim-recipes-'));
});
afterEach(() => rm(projects, { recursive: true, force: true }));

const save = (name: string) => saveRecipe(projects, { name, files: TEXTS }, NODE_FILES);
const names = async () => (await listRecipes(projects)).map(({ name }) => name);

test('a recipe is a folder in the projects folder, and is listed by name with its texts', async () => {
  expect(await listRecipes(projects)).toEqual([]);
  const path = await save('soft-glow');
  await save('edge');
  expect(await readFile(join(projects, 'recipes', 'soft-glow', 'project.scrim.json'), 'utf8')).toBe(TEXTS.project);
  expect(await listRecipes(projects)).toEqual([
    expect.objectContaining({ name: 'edge', problem: null }),
    { name: 'soft-glow', path: join(projects, 'recipes', 'soft-glow'), files: { ...TEXTS, sources: {} }, problem: null },
  ]);
  expect(path.endsWith(join('recipes', 'soft-glow'))).toBe(true);
});

test('a name is taken once, and leads nowhere else', async () => {
  await save('edge');
  await expect(save('edge')).rejects.toMatchObject({ diagnostic: { code: 'SCR061' } });
  const isValid = (name: string) => HOST_CONTRACT['recipe.save'].input.safeParse({ name, files: TEXTS }).success;
  expect(['edge', 'été', '輪郭-2'].map(isValid)).toEqual([true, true, true]);
  expect(['', '..', '../edge', 'a/b', 'a\\b', '.hidden', 'c:x', 'a--b'].map(isValid)).toEqual(Array(8).fill(false));
});

test('a folder without a project comes with the reason; links and files are left out', async () => {
  await save('edge');
  await mkdir(join(projects, 'recipes', 'empty'));
  await writeFile(join(projects, 'recipes', 'notes.txt'), 'x');
  await symlink(join(projects, 'recipes', 'edge'), join(projects, 'recipes', 'link'));
  const listed = await listRecipes(projects);
  expect(listed.map(({ name, problem }) => [name, problem?.code ?? null])).toEqual([
    ['edge', null],
    ['empty', 'SCR004'],
  ]);
});

test('a removed one is kept beside the others, each time it is', async () => {
  for (const kept of ['edge', 'edge-2']) {
    await save('edge');
    expect(await removeRecipe(projects, 'edge', NODE_FILES)).toBe(join(projects, 'recipes', '.removed', kept));
  }
  expect(await names()).toEqual([]);
  expect((await readdir(join(projects, 'recipes', '.removed'))).sort()).toEqual(['edge', 'edge-2']);
  for (const name of ['edge', '.removed', '..', '../recipes', '.'])
    await expect(removeRecipe(projects, name, NODE_FILES)).rejects.toMatchObject({ diagnostic: { code: 'SCR004' } });
});
