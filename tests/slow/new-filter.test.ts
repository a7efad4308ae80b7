import { readFile, writeFile } from 'node:fs/promises';
import { join } from 'node:path';
import { afterAll, beforeAll, describe, expect, test } from '@jest/globals';
import { copyRepository, type RepositoryCopy } from '../support/repository-copy.ts';

/** All that a filter is made from and checked with. */
const PARTS = ['nodes', 'export', 'shader-library', 'tools', 'tests/support', 'app/services', 'app/contract'];
const FILES = [
  '.gitignore',
  'package.json',
  'jest.config.mjs',
  'biome.json',
  'tsconfig.base.json',
  ...['glsl-kit.ts', 'glsl.page.ts', 'shader-library-kit.ts'].map((file) => `tests/browser/${file}`),
];

/** In a copy of the repository, so that nothing that is being worked on is touched. */
describe('npm run new-filter', () => {
  let copy: RepositoryCopy;

  beforeAll(async () => {
    copy = await copyRepository([...PARTS, ...FILES]);
    await copy.node('tools/run.mjs', 'new-filter/main.ts', 'try-it');
    await copy.node('tools/run.mjs', 'gen/main.ts');
  });
  afterAll(() => copy.dispose());

  test('its filter is among the nodes, documented', async () => {
    const generated = await readFile(join(copy.root, 'nodes/generated/definitions.gen.ts'), 'utf8');
    expect(generated).toContain('filter/try-it');
    expect(generated).toContain('Darkens an image towards its corners.');
  });

  test('its test is formatted, and holds the filter to its formula', async () => {
    const path = 'tests/browser/try-it.test.ts';
    await copy.node('node_modules/@biomejs/biome/bin/biome', 'check', '--vcs-enabled=false', '--error-on-warnings', path);
    const jest = ['node_modules/jest/bin/jest.js', path, '--selectProjects', 'browser'];
    expect(await copy.node(...jest)).toMatch(/Tests: +3 passed, 3 total/);
    // A test that cannot fail would prove nothing.
    const filter = join(copy.root, 'shader-library/filters/try-it.fs');
    const text = await readFile(filter, 'utf8');
    await writeFile(filter, text.replace('far * far', 'far'));
    await expect(copy.node(...jest)).rejects.toThrow(/Tests: +2 failed, 1 passed, 3 total/);
    await writeFile(filter, text);
  });

  test('a filter that is there is left alone', async () => {
    const path = join(copy.root, 'shader-library/filters/sepia.fs');
    const before = await readFile(path, 'utf8');
    await expect(copy.node('tools/run.mjs', 'new-filter/main.ts', 'sepia')).rejects.toThrow('The filter sepia exists already.');
    await expect(copy.node('tools/run.mjs', 'new-filter/main.ts', '../sepia')).rejects.toThrow('is not a filter name');
    expect(await readFile(path, 'utf8')).toBe(before);
  });
});
