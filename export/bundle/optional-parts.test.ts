import { readdir, readFile } from 'node:fs/promises';
import { join, resolve } from 'node:path';
import { expect, test } from '@jest/globals';
import { build } from 'esbuild';
import { DEFINITIONS } from '../../nodes/generated/definitions.gen.ts';
import { MOVED_TYPES, STILL_TYPES } from '../program/may-rest.ts';
import { VIEW_READERS } from '../program/reads-view.ts';
import { PANORAMA_MAKERS } from './optional/part.ts';
import { CAMERA_MEAN_READERS } from './optional/runtime-parts.ts';
import { SHADOW_CATCHERS } from './optional/scene-parts.ts';
import { OPTIONAL_PARTS } from './optional-parts.ts';
import { DIRECTIONS, RADIAL } from './program-use.ts';
import { LOCAL_LIGHTS } from './shrink/three-parts.ts';

const ROOT = resolve(import.meta.dirname, '../..');

/** Names of the values that a text exports. */
function exportedNames(text: string): string[] {
  const declared = [...text.matchAll(/^export (?:async )?(?:const|function|class) (\w+)/gm)].map(([, name]) => name ?? '');
  const listed = [...text.matchAll(/^export \{([^}]*)\}/gm)].flatMap(([, list = '']) => list.split(','));
  return [...declared, ...listed.map((part) => part.trim().split(' as ').pop() ?? '')].sort();
}

test.each(OPTIONAL_PARTS)('what stands for $file exports the same names', async ({ file, otherwise }) => {
  const text = await readFile(join(ROOT, file), 'utf8');
  expect(exportedNames(text).length).toBeGreaterThan(0);
  expect(exportedNames(otherwise)).toEqual(exportedNames(text));
});

/** Node types with a source file that contains a text. */
async function typesWith(text: string): Promise<readonly string[]> {
  const files = (await readdir(join(ROOT, 'nodes'), { recursive: true })).filter((file) => /^[^.]+\.ts$/.test(file));
  const found = new Set<string>();
  for (const file of files) {
    const [category, name, ...rest] = file.split(/[/\\]/);
    if (rest.length === 0 || category === 'kit' || category === 'generated') continue;
    if ((await readFile(join(ROOT, 'nodes', file), 'utf8')).includes(text)) found.add(`${category}/${name}`);
  }
  return [...found].sort();
}

test.each([
  ['.cameraMean', CAMERA_MEAN_READERS],
  ['.createEnvironment(', PANORAMA_MAKERS],
  ["kind: 'shadow-catcher'", SHADOW_CATCHERS],
  ['kit/local-lights.ts', LOCAL_LIGHTS],
  ["kind: 'mask'", ['layer/object-mask']],
  ["kind: 'probe'", ['world/light-estimate']],
])('the node types with “%s” are known', async (text, types) => {
  expect(await typesWith(text)).toEqual(types);
});

test('the node types that read the pose or the projection of a view are known', async () => {
  const files = (await readdir(join(ROOT, 'nodes'), { recursive: true })).filter((file) =>
    /^(?!kit|generated)\w+[/\\][\w-]+[/\\]runtime\.ts$/.test(file),
  );
  const { outputFiles } = await build({
    absWorkingDir: ROOT,
    entryPoints: files.map((file) => join('nodes', file)),
    outdir: 'unused',
    bundle: true,
    write: false,
    format: 'esm',
    external: ['three'],
  });
  const readers = outputFiles.filter(({ text }) => /worldFromView|viewFromWorld|clipFromView/.test(text));
  const types = readers.map(({ path }) => path.split(/[/\\]/).slice(-3, -1).join('/'));
  expect(types.sort()).toEqual(VIEW_READERS);
});

test('the texts of techniques that read the direction field or the curvature are known', async () => {
  const radial = await readFile(join(ROOT, 'export/runtime/scenes/materials/curvature/radial-parts.ts'), 'utf8');
  expect(radial).toContain(`includes('${RADIAL}')`);
  const text = await readFile(join(ROOT, 'export/runtime/scenes/materials/curvature/direction-parts.ts'), 'utf8');
  for (const field of DIRECTIONS) expect(text).toContain(`includes('${field}')`);
});

test('the node types that say when they change are known', async () => {
  const files = (await readdir(join(ROOT, 'nodes'), { recursive: true })).filter((file) =>
    /^\w[\w-]*[/\\][\w-]+[/\\]runtime\.ts$/.test(file),
  );
  const found: string[] = [];
  for (const file of files) {
    const text = await readFile(join(ROOT, 'nodes', file), 'utf8');
    if (/^ {4}(?:get version\(\)|version: 0,)/m.test(text)) found.push(file.split(/[/\\]/).slice(0, 2).join('/'));
  }
  expect(found.sort()).toEqual(STILL_TYPES);
});

test('each node type that lists objects says when they change, or is compared', () => {
  const listed = DEFINITIONS.filter(({ outputs }) => Object.values(outputs).some(({ type }) => type === 'objects'));
  const types = listed.map(({ type }) => type);
  expect(types.filter((type) => !STILL_TYPES.includes(type) && !MOVED_TYPES.includes(type))).toEqual([]);
  expect(MOVED_TYPES.filter((type) => STILL_TYPES.includes(type) || !types.includes(type))).toEqual([]);
});
