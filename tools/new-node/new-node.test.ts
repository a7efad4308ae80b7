import { readFile } from 'node:fs/promises';
import { join } from 'node:path';
import { afterAll, beforeAll, describe, expect, test } from '@jest/globals';
import { loadProject } from '../../export/graph/load.ts';
import { LIBRARY } from '../../tests/support/library.ts';
import { definitionProblems } from '../../tests/support/node-contract.ts';
import { copyRepository, type RepositoryCopy } from '../../tests/support/repository-copy.ts';
import { chooseTemplate, refuseType, scaffold, TEMPLATE_NAMES, type TemplateName } from './scaffold.ts';

/** What a new folder is made from and checked with. */
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

/** One type per template, with the template where the category does not select it. */
const NODES: readonly (readonly [type: string, template?: TemplateName])[] = [
  ['value/try-it'],
  ['pulse/try-it'],
  ['input/try-it'],
  ['source/try-it'],
  ['world/try-it'],
  ['light/try-it'],
  ['objects/try-it'],
  ['layer/try-it'],
  ['layer/try-it-pass', 'pass'],
];
const TYPES = NODES.map(([type]) => type);

/** In a copy of the repository, so that the working tree does not change. */
describe('npm run new-node', () => {
  let copy: RepositoryCopy;

  beforeAll(async () => {
    copy = await copyRepository([...PARTS, ...FILES]);
    await copy.node('tools/run.mjs', 'gen/main.ts');
    for (const [type, ...template] of NODES)
      await copy.node('tools/run.mjs', 'new-node/main.ts', type, ...template.filter((name) => name !== undefined));
    await copy.node('tools/run.mjs', 'gen/main.ts');
  });
  afterAll(() => copy.dispose());

  test('there is a type for each template', () => {
    expect(NODES.map(([type, template]) => chooseTemplate(type, template))).toEqual(TEMPLATE_NAMES);
  });

  test('the registry contains the new types', async () => {
    const registry = await readFile(join(copy.root, 'nodes/generated/definitions.gen.ts'), 'utf8');
    expect(TYPES.filter((type) => !registry.includes(`'../${type}/definition.ts'`))).toEqual([]);
  });

  test('its definitions keep the contract of nodes', () => {
    const problems = NODES.flatMap(([type, template = chooseTemplate(type, undefined)]) => {
      const files = scaffold(type, template ?? 'value', LIBRARY);
      const json = /defineNode\((.*)\);/.exec(files[`nodes/${type}/definition.ts`] ?? '')?.[1] ?? '';
      return definitionProblems(JSON.parse(json), (name) => Object.hasOwn(files, `nodes/${name}`));
    });
    expect(problems).toEqual([]);
  });

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
      ...TYPES.map((type) => `nodes/${type}`),
    );
  });

  test('its files keep to the layers', async () => {
    expect(await copy.node('tools/run.mjs', 'layers/main.ts')).toContain('keep to the table');
  });

  test('its tests pass', async () => {
    const output = await copy.node('node_modules/jest/bin/jest.js', 'try-it', '--selectProjects', 'unit');
    expect(output).toMatch(/Tests: +10 passed, 10 total/);
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

  test('an existing folder does not change', async () => {
    const path = join(copy.root, 'nodes/value/try-it/definition.ts');
    const before = await readFile(path, 'utf8');
    await expect(copy.node('tools/run.mjs', 'new-node/main.ts', 'value/try-it')).rejects.toThrow(
      'The node type value/try-it exists already',
    );
    expect(await readFile(path, 'utf8')).toBe(before);
  });
});

describe('names of new nodes', () => {
  test.each([
    ['layer/fog', null],
    ['value/math', 'exists already'],
    ['fog', 'Use CATEGORY/NAME'],
    ['Layer/Fog', 'Use CATEGORY/NAME'],
    ['../layer/fog', 'Use CATEGORY/NAME'],
    ['filter/fog', 'shader-library/filters/fog.fs'],
    ['kit/fog', 'not a category'],
  ])('%s', (type, refusal) => {
    if (refusal === null) expect(refuseType(type, LIBRARY)).toBeNull();
    else expect(refuseType(type, LIBRARY)).toContain(refusal);
  });

  test('a category without a template, and an unknown template, are refused', () => {
    expect([chooseTemplate('physics/body', undefined), chooseTemplate('layer/fog', 'shader')]).toEqual([null, null]);
    expect(chooseTemplate('physics/body', 'value')).toBe('value');
  });
});
