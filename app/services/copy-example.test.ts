import { mkdir, mkdtemp, readdir, readFile, realpath, rm, writeFile } from 'node:fs/promises';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { afterEach, beforeEach, describe, expect, test } from '@jest/globals';
import { copyExample, isExample } from './copy-example.ts';
import { NODE_FILES } from './file-layer.ts';

const PROJECT = { format: 'scrim-project', version: 1, title: 'Sepia', graphs: { main: { nodes: {}, wires: [] } }, assets: {} };

let base = '';
beforeEach(async () => {
  base = await realpath(await mkdtemp(join(tmpdir(), 'scrim-example-')));
  await mkdir(join(base, 'examples', 'sepia', 'assets'), { recursive: true });
  await writeFile(join(base, 'examples', 'sepia', 'project.scrim.json'), JSON.stringify(PROJECT));
  await writeFile(join(base, 'examples', 'sepia', 'assets', 'cup.glb'), 'cup');
});
afterEach(() => rm(base, { recursive: true, force: true }));

const copy = () => copyExample({ example: join(base, 'examples', 'sepia'), projectsDir: join(base, 'Scrim'), files: NODE_FILES });

describe('an example', () => {
  test('is copied with its assets to a folder that did not exist', async () => {
    const path = await copy();
    expect(path).toBe(join(base, 'Scrim', 'sepia'));
    expect(JSON.parse(await readFile(join(path, 'project.scrim.json'), 'utf8')).title).toBe('Sepia');
    expect(await readFile(join(path, 'assets', 'cup.glb'), 'utf8')).toBe('cup');
  });

  test('is not copied again while its copy is unchanged', async () => {
    await copy();
    expect(await copy()).toBe(join(base, 'Scrim', 'sepia'));
    expect(await readdir(join(base, 'Scrim'))).toEqual(['sepia']);
  });

  test('gets another copy when the first was edited or is another project', async () => {
    const first = await copy();
    const edited = JSON.stringify({ ...PROJECT, title: 'Mine' });
    await writeFile(join(first, 'project.scrim.json'), edited);
    await mkdir(join(base, 'Scrim', 'sepia-2'));
    await writeFile(join(base, 'Scrim', 'sepia-2', 'notes.txt'), 'mine');
    expect(await copy()).toBe(join(base, 'Scrim', 'sepia-3'));
    expect(await readFile(join(first, 'project.scrim.json'), 'utf8')).toBe(edited);
    expect(await readdir(join(base, 'Scrim', 'sepia-2'))).toEqual(['notes.txt']);
  });

  test('is a folder directly in the examples', async () => {
    const examples = join(base, 'examples');
    expect(await isExample(join(examples, 'sepia'), examples)).toBe(true);
    expect(await isExample(join(examples, 'templates', 'empty'), examples)).toBe(false);
    expect(await isExample(examples, examples)).toBe(false);
    expect(await isExample(join(base, 'Scrim', 'sepia'), examples)).toBe(false);
    expect(await isExample(join(base, 'sepia'), join(base, 'missing'))).toBe(false);
  });
});
