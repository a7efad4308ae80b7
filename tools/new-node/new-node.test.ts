import { execFile } from 'node:child_process';
import { cp, mkdtemp, readFile, rm, symlink } from 'node:fs/promises';
import { tmpdir } from 'node:os';
import { join, resolve } from 'node:path';
import process from 'node:process';
import { promisify } from 'node:util';
import { afterAll, beforeAll, describe, expect, test } from '@jest/globals';
import { loadProject } from '../../export/graph/load.ts';
import { LIBRARY } from '../../tests/support/library.ts';
import { refuseType } from './scaffold.ts';

const run = promisify(execFile);
const repository = resolve(import.meta.dirname, '../..');

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
  let root: string;

  beforeAll(async () => {
    root = await mkdtemp(join(tmpdir(), 'scrim-new-node-'));
    for (const path of [...PARTS, ...FILES]) await cp(join(repository, path), join(root, path), { recursive: true });
    await symlink(join(repository, 'node_modules'), join(root, 'node_modules'));
    await node('tools/gen.mjs');
    for (const type of TYPES) await node('tools/new-node.mjs', type);
    await node('tools/gen.mjs');
  }, 60_000);
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

  test('its definitions and runtimes have the right types', async () => {
    await node('node_modules/typescript/bin/tsc', '-p', 'nodes/tsconfig.json');
    await node('node_modules/typescript/bin/tsc', '-p', 'nodes/tsconfig.runtime.json');
  }, 60_000);

  test('its files are formatted and lint clean', async () => {
    await node(
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
    expect(await node('tools/layers.mjs')).toContain('keep to the table');
  });

  test('its tests pass', async () => {
    const output = await node('node_modules/jest/bin/jest.js', 'try-it', '--selectProjects', 'unit');
    expect(output).toMatch(/Tests: +4 passed, 4 total/);
  }, 60_000);

  test.each(TYPES)('the example of %s can be opened and uses it', async (type) => {
    const folder = join(root, 'nodes', type, 'example');
    const { output, diagnostics } = loadProject({
      project: await readFile(join(folder, 'project.scrim.json'), 'utf8'),
      layout: await readFile(join(folder, 'project.layout.json'), 'utf8'),
      sources: {},
    });
    expect(diagnostics).toEqual([]);
    expect(Object.values(output?.graphs.main?.nodes ?? {}).map((placed) => placed.type)).toContain(type);
  });

  test('a folder that is there is left alone', async () => {
    const path = join(root, 'nodes/value/try-it/definition.ts');
    const before = await readFile(path, 'utf8');
    await expect(node('tools/new-node.mjs', 'value/try-it')).rejects.toThrow('There is a node type value/try-it already');
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
