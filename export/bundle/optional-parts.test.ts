import { readdir, readFile } from 'node:fs/promises';
import { join, resolve } from 'node:path';
import { expect, test } from '@jest/globals';
import { CAMERA_MEAN_READERS, OPTIONAL_PARTS } from './optional-parts.ts';

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

test('the node types that read the mean color of the camera are known', async () => {
  const files = (await readdir(join(ROOT, 'nodes'), { recursive: true })).filter((file) => /^[^.]+\.ts$/.test(file));
  const readers = new Set<string>();
  for (const file of files) {
    const [category, name, ...rest] = file.split(/[/\\]/);
    if (rest.length === 0 || category === 'kit' || category === 'generated') continue;
    if ((await readFile(join(ROOT, 'nodes', file), 'utf8')).includes('.cameraMean')) readers.add(`${category}/${name}`);
  }
  expect([...readers].sort()).toEqual(CAMERA_MEAN_READERS);
});
