import { readFile } from 'node:fs/promises';
import { join } from 'node:path';
import { afterAll, beforeAll, describe, expect, test } from '@jest/globals';
import { loadProject } from '../../export/graph/load.ts';
import { LIBRARY } from '../../tests/support/library.ts';
import { copyRepository, type RepositoryCopy } from '../../tests/support/repository-copy.ts';
import { refuseType } from './scaffold.ts';

/** All that a new folder is made from and checked with. */
const PARTS = ['nodes/kit', 'export', 'tools', 'tests/support', 'app/services/chromium.ts'];
const FILES = [
  '.gitignore',
  'package.json',
  'jest.config.mjs',
  'biome.json',
  'tsconfig.base.json',
  'text-modules.d.ts',
  'nodes/tsconfig.json',
  'nodes/tsconfig.runtime.json',
];

const TYPES = ['value/try-it', 'objects/try-it', 'layer/try-it'];

/** In a copy of the repository, so that nothing that is being worked on is touched. */
describe('npm run new-node', () => {
  let copy: RepositoryCopy;

  beforeAll(async () => {
    copy = await copyRepository([...PARTS, ...FILES]);
    await copy.node('tools/gen.mjs');
    for (const type of TYPES) await copy.node('tools/new-node.mjs', type);
    await copy.node('tools/gen.mjs');
  });
  afterAll(() => copy.dispose());

  test('its definitions and runtimes have the right types', async () => {
    await copy.node('node_modules/typescript/bin/tsc', '-p', 'nodes/tsconfig.json');
    await copy.node('node_modules/typescript/bin/tsc', '-p', 'nodes/tsconfig.runtime.json');
  });

  test('its files are formatted and lint clean', async () => {
    await copy.node(
      'node_modules/@biomejs/biome/bin/biome',
      'check',
      '--vcs-enabled=false',
      '--error-on-warnings',
      'nodes/value',
      'nodes/objects',
      'nodes/layer',
    );
  });

  test('its files keep to the layers', async () => {
    expect(await copy.node('tools/layers.mjs')).toContain('keep to the table');
  });

  test('its tests pass', async () => {
    const output = await copy.node('node_modules/jest/bin/jest.js', 'try-it', '--selectProjects', 'unit');
    expect(output).toMatch(/Tests: +4 passed, 4 total/);
  });

  test.each(TYPES)('the example of %s can be opened and uses it', async (type) => {
    const folder = join(copy.root, 'nodes', type, 'example');
    const { output, diagnostics } = loadProject({
      project: await readFile(join(folder, 'project.scrim.json'), 'utf8'),
      layout: await readFile(join(folder, 'project.layout.json'), 'utf8'),
      sources: {},
    });
    expect(diagnostics).toEqual([]);
    expect(Object.values(output?.graphs.main?.nodes ?? {}).map((placed) => placed.type)).toContain(type);
  });

  test('a folder that is there is left alone', async () => {
    const path = join(copy.root, 'nodes/value/try-it/definition.ts');
    const before = await readFile(path, 'utf8');
    await expect(copy.node('tools/new-node.mjs', 'value/try-it')).rejects.toThrow('There is a node type value/try-it already');
    expect(await readFile(path, 'utf8')).toBe(before);
  });
});

describe('names of new nodes', () => {
  test.each([
    ['layer/fog', null],
    ['value/math', 'already'],
    ['fog', 'write CATEGORY/NAME'],
    ['Layer/Fog', 'write CATEGORY/NAME'],
    ['../layer/fog', 'write CATEGORY/NAME'],
    ['filter/fog', 'shader-library/filters/fog.fs'],
    ['kit/fog', 'no category'],
  ])('%s', (type, refusal) => {
    if (refusal === null) expect(refuseType(type, LIBRARY)).toBeNull();
    else expect(refuseType(type, LIBRARY)).toContain(refusal);
  });
});
