import { mkdir, mkdtemp, rm, writeFile } from 'node:fs/promises';
import { tmpdir } from 'node:os';
import { dirname, join } from 'node:path';
import { afterEach, describe, expect, jest, test } from '@jest/globals';
import { checkFiles } from './check.ts';
import { main } from './main.ts';
import { LAYERS } from './table.ts';

function check(path: string, text: string): string[] {
  return checkFiles([{ path, text }]);
}

/** [what it proves, the file, what it says, words of the complaint] */
const VIOLATIONS: readonly (readonly [string, string, string, string])[] = [
  ['kit imports nothing', 'nodes/kit/definition.ts', `import { z } from 'zod';`, 'kit may not import zod'],
  ['kit runtime takes types only', 'nodes/kit/runtime.ts', `import { Mesh } from 'three';`, 'only types of three'],
  [
    'definitions never three',
    'nodes/layer/scene/definition.ts',
    `import type { Mesh } from 'three';`,
    'node definition may not import three',
  ],
  ['definitions only kit', 'nodes/layer/scene/definition.ts', `import { x } from './runtime.ts';`, 'node definition may not import node'],
  [
    'definitions never the runtime contract',
    'nodes/a/b/definition.ts',
    `import type { Clock } from '../../kit/runtime.ts';`,
    'kit runtime',
  ],
  ['nodes never other nodes', 'nodes/layer/scene/runtime.ts', `import { x } from '../shadow/runtime.ts';`, 'another of its kind'],
  [
    'nodes never other nodes’ definitions',
    'nodes/layer/scene/runtime.ts',
    `import { x } from '../shadow/definition.ts';`,
    'node definition',
  ],
  ['nodes never the compiler', 'nodes/layer/scene/runtime.ts', `import type { x } from '../../../export/compiler/x.ts';`, 'compiler'],
  [
    'program takes types of the kit only',
    'export/program/program.ts',
    `import { x } from '../../nodes/kit/definition.ts';`,
    'only types of kit',
  ],
  ['graph never React', 'export/graph/load.ts', `import { useState } from 'react';`, 'react'],
  ['graph never Node', 'export/graph/load.ts', `import { readFile } from 'node:fs/promises';`, 'node:fs/promises'],
  ['glsl never the graph', 'export/glsl/link.ts', `import type { Project } from '../graph/project.ts';`, 'graph'],
  ['compiler never the runtime', 'export/compiler/x.ts', `import type { Player } from '../runtime/player.ts';`, 'runtime'],
  ['compiler never three', 'export/compiler/x.ts', `import type { Mesh } from 'three';`, 'three'],
  ['runtime never the compiler', 'export/runtime/player.ts', `import { compile } from '../compiler/compile.ts';`, 'compiler'],
  ['runtime never the graph', 'export/runtime/player.ts', `import type { Project } from '../graph/project.ts';`, 'graph'],
  ['runtime never zustand', 'export/runtime/player.ts', `import { create } from 'zustand';`, 'zustand'],
  ['image passes never load three', 'export/runtime/player.ts', `import { Mesh } from 'three';`, 'only types of three'],
  ['image passes never load scenes', 'export/runtime/player.ts', `import { x } from './scenes/create-scenes.ts';`, 'scenes'],
  ['emulator never in the page', 'export/page/main.ts', `import { x } from '../emulator/device.ts';`, 'emulator'],
  ['emulator never in the bundle', 'export/bundle/write.ts', `import type { x } from '../emulator/device.ts';`, 'emulator'],
  [
    'recordings never in the page',
    'export/page/main.ts',
    `import { x } from '../runtime/sessions/recorded/session.ts';`,
    'recorded session',
  ],
  ['recordings never in the runtime at large', 'export/runtime/player.ts', `import './sessions/recorded/session.ts';`, 'recorded session'],
  ['page never Electron', 'export/page/main.ts', `import { app } from 'electron';`, 'electron'],
  ['bundle never React', 'export/bundle/write.ts', `import type { FC } from 'react';`, 'react'],
  ['app never the renderer', 'app/services/files.ts', `import { x } from '../../renderer/state/store.ts';`, 'editor'],
  ['server shell never Electron', 'app/server/server.ts', `import { app } from 'electron';`, 'electron'],
  ['editor never Electron', 'renderer/shell/app.tsx', `import { ipcRenderer } from 'electron';`, 'electron'],
  ['editor never Node', 'renderer/shell/app.tsx', `import { join } from 'node:path';`, 'node:path'],
  ['editor never services', 'renderer/shell/app.tsx', `import type { x } from '../../app/services/files.ts';`, 'services'],
  [
    'editor takes types of the contract',
    'renderer/shell/app.tsx',
    `import { HOST_CONTRACT } from '../../app/contract/contract.ts';`,
    'only types',
  ],
  ['editor never the preview', 'renderer/shell/app.tsx', `import { x } from '../preview/main.ts';`, 'preview'],
  [
    'preview never the host contract',
    'renderer/preview/main.ts',
    `import type { Host } from '../../app/contract/contract.ts';`,
    'contract',
  ],
  ['nothing imports tests', 'export/graph/load.ts', `import { x } from '../../tests/support/serve.ts';`, 'tests'],
  ['nothing imports a test beside it', 'export/graph/load.ts', `import { x } from './save.test.ts';`, 'tests'],
  ['no TypeScript in the shader library', 'shader-library/filters/sepia.ts', 'export const x = 1;', 'holds no code'],
  ['every file has a layer', 'export/other/x.ts', 'export const x = 1;', 'belongs to no layer'],
  ['imports have their extension', 'export/graph/load.ts', `import { x } from './save';`, 'file extension'],
  ['imports stay inside', 'export/graph/load.ts', `import { x } from '../../../x.ts';`, 'outside the repository'],
  ['computed imports', 'export/graph/load.ts', 'export const x = (name: string) => import(name);', 'computed import'],
  ['files stay short', 'export/graph/load.ts', 'export {};\n'.repeat(401), '401 lines'],
];

describe('layers', () => {
  test.each(VIOLATIONS)('%s', (_rule, path, text, words) => {
    const problems = check(path, text);
    expect(problems).toHaveLength(1);
    expect(problems[0]).toContain(`${path}:`);
    expect(problems[0]).toContain(words);
  });

  test.each([
    ['import type', `import type { Mesh } from 'three';`],
    ['import of a type by name', `import { type Mesh } from 'three';`],
    ['export of a type', `export type { Mesh } from 'three';`],
    ['export of all', `export * from 'three';`],
    ['import() of a type', `export type M = import('three').Mesh;`],
    ['import()', `export const m = await import('three');`],
    ['import for its effect', `import 'three';`],
    ['require', `export const m = require('three');`],
    ['import = require', `import m = require('three');`],
    ['a subpath', `import { x } from 'three/addons/x.js';`],
    ['a reference', `/// <reference types="three" />\nexport {};`],
  ])('%s counts as an import', (_kind, text) => {
    expect(check('export/compiler/x.ts', text)).toEqual([expect.stringContaining('compiler may not import three')]);
  });

  test('a worker named by URL counts as an import', () => {
    const text = `export const url = new URL('../emulator/worker.ts', import.meta.url);`;
    expect(check('export/page/x.ts', text)).toEqual([expect.stringContaining('page may not import emulator')]);
  });

  test('what the table allows passes', () => {
    expect(
      check('nodes/layer/scene/runtime.ts', `import { Mesh } from 'three';\nimport type { definition } from './definition.ts';`),
    ).toEqual([]);
    expect(check('nodes/kit/runtime.ts', `import type { Mesh } from 'three';`)).toEqual([]);
    expect(check('export/runtime/scenes/lights.ts', `import { Mesh } from 'three';\nimport '../player.ts';`)).toEqual([]);
    expect(check('export/graph/load.test.ts', `import { test } from '@jest/globals';\nimport '../../tests/support/serve.ts';`)).toEqual([]);
  });

  test('each problem says its line', () => {
    expect(check('export/graph/load.ts', `export {};\n\nimport 'react';\n`)[0]).toMatch(/^export\/graph\/load\.ts:3: /);
  });

  test('the table names only layers that it has', () => {
    const names = new Set(LAYERS.map((layer) => layer.name));
    const unknown = LAYERS.flatMap((layer) => (layer.imports ?? []).filter((name) => !names.has(name)));
    expect(unknown).toEqual([]);
  });
});

describe('circles', () => {
  const circlesOf = (files: Readonly<Record<string, string>>) =>
    checkFiles(Object.entries(files).map(([path, target]) => ({ path, text: target && `import type { X } from '${target}';\n` })));

  test('files that import each other, types included, are named in order', () => {
    expect(circlesOf({ 'export/graph/a.ts': './b.ts', 'export/graph/b.ts': './c.ts', 'export/graph/c.ts': './a.ts' })).toEqual([
      'export/graph/a.ts:1: files import each other in a circle: export/graph/a.ts → export/graph/b.ts → export/graph/c.ts → export/graph/a.ts.',
    ]);
  });

  test('rows of the table do not import each other, by whichever files', () => {
    const problems = circlesOf({ 'nodes/kit/runtime.ts': '../../export/program/a.ts', 'export/program/b.ts': '../../nodes/kit/curve.ts' });
    expect(problems).toContainEqual(expect.stringContaining('folders import each other in a circle: export/program → nodes/kit'));
    expect(problems).toContainEqual(expect.stringContaining('export/program/b.ts imports nodes/kit/curve.ts'));
  });

  test('folders of the editor that stand side by side do not import each other', () => {
    expect(circlesOf({ 'renderer/state/files/a.ts': '../clipboard/b.ts', 'renderer/state/clipboard/c.ts': '../files/d.ts' })).toEqual([
      expect.stringContaining('renderer/state/clipboard → renderer/state/files → renderer/state/clipboard'),
    ]);
  });

  test('a folder and its subfolders may import each other', () => {
    expect(circlesOf({ 'renderer/state/a.ts': './files/b.ts', 'renderer/state/files/c.ts': '../d.ts' })).toEqual([]);
  });
});

describe('file names', () => {
  const namesOf = (...paths: readonly string[]) => checkFiles(paths.map((path) => ({ path, text: '' })));

  test('are unique in the folders that the table lists', () => {
    expect(namesOf('app/services/notices.ts', 'export/page/notices.ts')).toEqual([
      'export/page/notices.ts:1: has the same name as app/services/notices.ts. Give it a name that tells which one it is.',
    ]);
  });

  test('may be equal for entries and tests, and outside of these folders', () => {
    expect(namesOf('app/cli/main.ts', 'app/electron/main.ts', 'app/cli/open.test.ts', 'export/page/open.test.ts')).toEqual([]);
    expect(namesOf('app/services/routes.ts', 'renderer/state/routes.ts')).toEqual([]);
  });
});

describe('raw globals', () => {
  test.each([
    ['Date.now', 'export const t = Date.now();'],
    ['new Date', 'export const t = new Date();'],
    ['performance.now', 'export const t = performance.now();'],
    ['Math.random', 'export const x = Math.random();'],
    ['setTimeout', 'setTimeout(() => {}, 5);'],
    ['setInterval', 'window.setInterval(() => {}, 5);'],
    ['requestAnimationFrame', 'globalThis.requestAnimationFrame(() => {});'],
    ['fetch', `export const load = () => fetch('x');`],
    ['fetch', 'export const io = { fetch };'],
    ['Math.random', 'export const random = (x: unknown) => x ?? Math.random;'],
    ['Date.now', 'export const t = globalThis.Date.now();'],
    ['Date.now', `export const t = Date['now']();`],
    ['Date.now', 'export const t = (Date.now as () => number)();'],
  ])('%s is refused', (name, text) => {
    expect(check('export/compiler/x.ts', text)).toEqual([expect.stringContaining(`raw ${name}:`)]);
  });

  test.each([
    ['an injected one', 'export const load = (fetch: (url: string) => unknown) => fetch("x");'],
    ['a member of that name', 'export const load = (io: { fetch(url: string): unknown }) => io.fetch("x");'],
    ['a session’s own frames', 'export const start = (session: XRSession) => session.requestAnimationFrame(() => {});'],
    ['a key', 'export const names = { setTimeout: 1 };'],
    ['a type', 'export interface Io { fetch: typeof fetch; now: typeof Date.now }'],
    ['a conversion', 'export const day = (timeMs: number) => new Date(timeMs);'],
  ])('%s is fine', (_what, text) => {
    expect(check('export/compiler/x.ts', text)).toEqual([]);
  });

  test('the files named after them may use them', () => {
    expect(check('export/runtime/sessions/clock.ts', 'export const now = () => performance.now();')).toEqual([]);
    expect(check('renderer/state/random.ts', 'export const random = () => Math.random();')).toEqual([]);
    expect(check('export/compiler/clock.ts', 'export const now = () => performance.now();')).toHaveLength(1);
  });
});

describe('the tool', () => {
  let root: string | undefined;
  afterEach(async () => {
    jest.restoreAllMocks();
    if (root) await rm(root, { recursive: true });
  });

  async function runOver(files: Readonly<Record<string, string>>): Promise<number> {
    root = await mkdtemp(join(tmpdir(), 'scrim-layers-'));
    for (const [path, text] of Object.entries(files)) {
      await mkdir(dirname(join(root, path)), { recursive: true });
      await writeFile(join(root, path), text);
    }
    return main([], { root, version: '' });
  }

  test('fails on a tree with a violation and names the place', async () => {
    const errors = jest.spyOn(console, 'error').mockImplementation(() => {});
    jest.spyOn(console, 'log').mockImplementation(() => {});
    expect(await runOver({ 'export/graph/a.ts': `import 'react';\n`, 'node_modules/x/y.ts': `import 'react';\n` })).toBe(1);
    expect(errors.mock.calls).toEqual([['export/graph/a.ts:1: graph may not import react.']]);
  });

  test('passes a tree without one', async () => {
    const log = jest.spyOn(console, 'log').mockImplementation(() => {});
    expect(await runOver({ 'export/graph/a.ts': `import '../../nodes/kit/definition.ts';\n` })).toBe(0);
    expect(log.mock.calls).toEqual([['Layers: 1 files keep to the table.']]);
  });
});
