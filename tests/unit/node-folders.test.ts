import { existsSync, readdirSync, readFileSync } from 'node:fs';
import { join } from 'node:path';
import { describe, expect, test } from '@jest/globals';
import { loadProject } from '../../export/graph/load.ts';
import { validateProject } from '../../export/graph/validate/validate.ts';
import { SHADERS } from '../../nodes/generated/definitions.gen.ts';
import { RUNTIMES } from '../../nodes/generated/runtimes.gen.ts';
import { LIBRARY } from '../support/library.ts';
import { definitionProblems } from '../support/node-contract.ts';

/** Folders that are no categories of nodes; what is in `binding` plays what params are bound to. */
const OTHERS = ['kit', 'generated', 'binding', 'part'];

const FOLDERS = subfolders('nodes')
  .filter((category) => !OTHERS.includes(category))
  .flatMap((category) => subfolders(join('nodes', category)).map((name) => `${category}/${name}`));

function subfolders(path: string): string[] {
  return readdirSync(path, { withFileTypes: true })
    .filter((entry) => entry.isDirectory())
    .map((entry) => entry.name);
}

test('there are nodes', () => {
  expect(FOLDERS).toContain('value/math');
});

describe.each(FOLDERS)('nodes/%s', (type) => {
  const folder = join('nodes', type);
  const definition = LIBRARY.definition(type);

  test('has a definition whose type is its path', () => {
    expect(existsSync(join(folder, 'definition.ts'))).toBe(true);
    expect(definition?.type).toBe(type);
  });

  test('is documented, consistent and in range', () => {
    expect(definition && definitionProblems(definition, (name) => Object.hasOwn(SHADERS, name))).toEqual([]);
  });

  test('has a runtime, unless a shader, a worker or the screen is all there is to it', () => {
    const kind = definition?.lowering.kind;
    const hasRuntime = kind !== 'image' && kind !== 'present' && kind !== 'cpu';
    expect(existsSync(join(folder, 'runtime.ts'))).toBe(hasRuntime);
    const hasWorker = kind === 'cpu' || definition?.worker === true;
    expect(existsSync(join(folder, 'worker.ts'))).toBe(hasWorker);
    const played = RUNTIMES[type] ?? {};
    expect('create' in played && typeof played.create === 'function').toBe(hasRuntime);
    expect('worker' in played && played.worker !== '').toBe(hasWorker);
  });

  test('says whether its runtime reads input', () => {
    const path = join(folder, 'runtime.ts');
    const text = existsSync(path) ? readFileSync(path, 'utf8') : '';
    const reads = /\b(tapCount|pointerCount|pointerById|frame\.input)\b|\(\{[^)]*\binput\b[^)]*\}/.test(text);
    expect(definition?.readsInput ?? false).toBe(reads);
  });

  test('has a test', () => {
    expect(readdirSync(folder).filter((name) => name.endsWith('.test.ts'))).not.toEqual([]);
  });

  test('has an example that uses it and has no mistakes', () => {
    const { output: project, diagnostics } = loadProject(readExample(join(folder, 'example')));
    expect(diagnostics).toEqual([]);
    if (!project) throw new Error('The example cannot be read.');
    expect(Object.values(project.graphs).flatMap((graph) => Object.values(graph.nodes).map((node) => node.type))).toContain(type);
    expect(validateProject(project, LIBRARY)).toEqual([]);
    const missing = Object.values(project.assets).filter((asset) => !existsSync(join(folder, 'example', asset.path)));
    expect(missing).toEqual([]);
  });
});

function readExample(folder: string): Parameters<typeof loadProject>[0] {
  const layout = join(folder, 'project.layout.json');
  return {
    project: readFileSync(join(folder, 'project.scrim.json'), 'utf8'),
    layout: existsSync(layout) ? readFileSync(layout, 'utf8') : null,
    sources: {},
  };
}
