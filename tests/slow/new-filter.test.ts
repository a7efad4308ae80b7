import { execFile } from 'node:child_process';
import { cp, mkdtemp, readFile, rm, symlink, writeFile } from 'node:fs/promises';
import { tmpdir } from 'node:os';
import { join, resolve } from 'node:path';
import process from 'node:process';
import { promisify } from 'node:util';
import { afterAll, beforeAll, describe, expect, test } from '@jest/globals';

const run = promisify(execFile);
const repository = resolve(import.meta.dirname, '../..');

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
  let root: string;

  beforeAll(async () => {
    root = await mkdtemp(join(tmpdir(), 'scrim-new-filter-'));
    for (const path of [...PARTS, ...FILES]) await cp(join(repository, path), join(root, path), { recursive: true });
    await symlink(join(repository, 'node_modules'), join(root, 'node_modules'));
    await node('tools/new-filter.mjs', 'try-it');
    await node('tools/gen.mjs');
  });
  afterAll(() => rm(root, { recursive: true }));

  /** Output of a script in the copy; its failure is the test's, with all that it said. */
  async function node(...args: string[]): Promise<string> {
    const env = { ...process.env, NODE_OPTIONS: '--experimental-vm-modules --disable-warning=ExperimentalWarning' };
    try {
      const { stdout, stderr } = await run(process.execPath, args, { cwd: root, env });
      return stdout + stderr;
    } catch (error) {
      const { stdout, stderr } = error as { stdout: string; stderr: string };
      throw new Error(`${args.join(' ')}:\n${stdout}${stderr}`);
    }
  }

  test('its filter is among the nodes, documented', async () => {
    const generated = await readFile(join(root, 'nodes/generated/definitions.gen.ts'), 'utf8');
    expect(generated).toContain('filter/try-it');
    expect(generated).toContain('Darkens the picture towards its corners.');
  });

  test('its test is formatted, and holds the filter to its formula', async () => {
    const path = 'tests/browser/filters/try-it.test.ts';
    await node('node_modules/@biomejs/biome/bin/biome', 'check', '--vcs-enabled=false', '--error-on-warnings', path);
    const jest = ['node_modules/jest/bin/jest.js', path, '--selectProjects', 'browser'];
    expect(await node(...jest)).toMatch(/Tests: +3 passed, 3 total/);
    // A test that cannot fail would prove nothing.
    const filter = join(root, 'shader-library/filters/try-it.fs');
    const text = await readFile(filter, 'utf8');
    await writeFile(filter, text.replace('far * far', 'far'));
    await expect(node(...jest)).rejects.toThrow(/Tests: +2 failed, 1 passed, 3 total/);
    await writeFile(filter, text);
  });

  test('a filter that is there is left alone', async () => {
    const path = join(root, 'shader-library/filters/sepia.fs');
    const before = await readFile(path, 'utf8');
    await expect(node('tools/new-filter.mjs', 'sepia')).rejects.toThrow('There is a filter sepia already');
    await expect(node('tools/new-filter.mjs', '../sepia')).rejects.toThrow('no name of a filter');
    expect(await readFile(path, 'utf8')).toBe(before);
  });
});
