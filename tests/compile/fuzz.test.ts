import { describe, expect, test } from '@jest/globals';
import fc from 'fast-check';
import { createCompiler } from '../../export/compiler/compile.ts';
import { describeProgram } from '../../export/compiler/describe.ts';
import type { ProjectTexts } from '../../export/graph/load.ts';
import { loadProject } from '../../export/graph/load.ts';
import type { Project } from '../../export/graph/project.ts';
import { saveProject } from '../../export/graph/save.ts';
import { DIAGNOSTICS, type Diagnostic } from '../../nodes/kit/diagnostics.ts';
import { LIBRARY } from '../support/library.ts';
import { readArchive } from './archive.ts';
import { movedParams, subgraphs } from './graphs.ts';
import { programFaults } from './program-faults.ts';

/** Whatever a project file holds, opening and compiling it gives a program or says why not, and never throws. */

const { compile } = createCompiler();
const archive = await readArchive();
const VALID: readonly ProjectTexts[] = [
  ...archive.map(({ texts }) => texts),
  saveProject(movedParams().project),
  saveProject(subgraphs().project),
];

const counts = { loaded: 0, compiled: 0 };

function expectAnAnswer(texts: ProjectTexts): void {
  const loaded = loadProject(texts);
  expectWords(loaded.diagnostics);
  if (loaded.output === null) {
    expectAReason(loaded.diagnostics);
    return;
  }
  counts.loaded++;
  expectBytesToLast(loaded.output);
  const { output, diagnostics } = compile({ project: loaded.output, library: LIBRARY, options: { reportUnused: true } });
  expectWords(diagnostics);
  if (output === null) {
    expectAReason(diagnostics);
    return;
  }
  counts.compiled++;
  expect(programFaults(output)).toEqual([]);
  expect(JSON.parse(JSON.stringify(output))).toEqual(output);
  expect(describeProgram(output)).not.toBe('');
}

function expectAReason(diagnostics: readonly Diagnostic[]): void {
  expect(diagnostics.some(({ severity }) => severity === 'error')).toBe(true);
}

function expectWords(diagnostics: readonly Diagnostic[]): void {
  for (const { code, message, line, column } of diagnostics) {
    expect(Object.hasOwn(DIAGNOSTICS, code)).toBe(true);
    expect(message.trim()).not.toBe('');
    expect(message.length).toBeLessThan(2000);
    expect(line ?? 1).toBeGreaterThanOrEqual(1);
    expect(column ?? 1).toBeGreaterThanOrEqual(1);
  }
}

function expectBytesToLast(project: Project): void {
  const saved = saveProject(project);
  expect(saveProject(loadProject(saved).output as Project)).toEqual(saved);
}

type Json = null | boolean | number | string | Json[] | { [key: string]: Json };

/** All places of a JSON value, as ways to change what is there. */
function places(json: Json): ((change: (part: Json) => Json | undefined) => void)[] {
  if (typeof json !== 'object' || json === null) return [];
  const keys = Array.isArray(json) ? json.keys() : Object.keys(json);
  return [...keys].flatMap((key) => {
    const holder = json as Record<string | number, Json>;
    const here = (change: (part: Json) => Json | undefined) => {
      const changed = change(holder[key] as Json);
      if (changed === undefined) delete holder[key];
      else Object.defineProperty(holder, key, { value: changed, enumerable: true, configurable: true, writable: true });
    };
    return [here, ...places(holder[key] as Json)];
  });
}

/** What may stand where something else should: of every kind, and what projects are full of, in the wrong place. */
const ODDITIES: readonly Json[] = [
  null,
  true,
  0,
  -0,
  -1,
  1e308,
  5e-324,
  2 ** 53,
  '',
  'main',
  '__proto__',
  'constructor',
  'toString',
  'graph/main',
  'graph/look',
  'graph/constructor',
  'filter/sepia',
  'filter/__proto__',
  'output/screen',
  'video-a.layer -> screen-a.layer',
  'screen-a.layer -> screen-a.layer',
  'a'.repeat(100_000),
  '\u0000\u2028\ud800',
  [],
  {},
  [[]],
  [Number.MAX_VALUE],
  { port: 1 },
  { port: null },
  { expression: 'time' },
  { expression: 'time +' },
  { expression: '('.repeat(9000) },
  { expression: '1 / 0' },
  { track: { keys: [] } },
  {
    track: {
      keys: [
        { timeS: 1, value: 1 },
        { timeS: 1, value: 2 },
      ],
    },
  },
  { track: { keys: [{ timeS: 0, value: [1, 2] }], repeat: 'loop' } },
  {
    track: {
      keys: [
        { timeS: 0, value: 1 },
        { timeS: 1e-300, value: 2, easing: 'ease-in' },
      ],
      repeat: 'mirror',
    },
  },
  { value: 1 },
];

const part = fc.oneof(fc.constantFrom(...ODDITIES), fc.jsonValue({ maxDepth: 2 }) as fc.Arbitrary<Json>);

/** Some of its parts replaced, removed, doubled, or put in each other's place. */
function changed(texts: ProjectTexts, changes: readonly (readonly [at: number, how: string, part: Json])[]): ProjectTexts {
  const files = { project: JSON.parse(texts.project) as Json, layout: JSON.parse(texts.layout ?? '{}') as Json };
  for (const [at, how, given] of changes) {
    const all = [...places(files.project), ...places(files.layout)];
    let taken: Json = given;
    if (how === 'swap')
      all[(at * 7919) % all.length]?.((there) => {
        taken = structuredClone(there);
        return there;
      });
    all[at % all.length]?.((there) => {
      if (how === 'remove') return undefined;
      if (how === 'double' && Array.isArray(there)) return [...there, ...structuredClone(there)];
      return structuredClone(taken);
    });
  }
  return { ...texts, project: JSON.stringify(files.project), layout: JSON.stringify(files.layout) };
}

const change = fc.tuple(fc.nat(100_000), fc.constantFrom('replace', 'remove', 'double', 'swap', 'swap'), part);

describe('a valid project', () => {
  test('with any of its parts changed is a program, or told what is wrong', () => {
    fc.assert(
      fc.property(fc.constantFrom(...VALID), fc.array(change, { minLength: 1, maxLength: 3 }), (texts, changes) =>
        expectAnAnswer(changed(texts, changes)),
      ),
      { seed: 21, numRuns: 300 },
    );
    // Were nothing left to compile, nothing would have been proved of the compiler.
    expect(counts.loaded).toBeGreaterThan(60);
    expect(counts.compiled).toBeGreaterThan(15);
  });

  test('cut off or with bytes changed anywhere is told where', () => {
    fc.assert(
      fc.property(
        fc.constantFrom(...VALID),
        fc.double({ min: 0, max: 1, noNaN: true }),
        fc.string({ unit: 'binary', maxLength: 3 }),
        (texts, at, text) => {
          const end = Math.floor(at * texts.project.length);
          expectAnAnswer({ ...texts, project: texts.project.slice(0, end) });
          expectAnAnswer({ ...texts, project: texts.project.slice(0, end) + text + texts.project.slice(end + text.length) });
        },
      ),
      { seed: 22, numRuns: 40 },
    );
  });

  test('with any key written twice is told so', () => {
    const { project } = VALID[0] as ProjectTexts;
    const keys = [...project.matchAll(/^( *)("[^"]+"): ("[^"]*"|\d+)(,?)$/gm)];
    expect(keys.length).toBeGreaterThan(20);
    for (const { 0: line, index, 2: key } of keys) {
      const twice = `${project.slice(0, index)}${line.replace(/,?$/, ',')}\n${project.slice(index)}`;
      const { output, diagnostics } = loadProject({ ...(VALID[0] as ProjectTexts), project: twice });
      expect(output).toBeNull();
      expect(diagnostics).toMatchObject([{ code: 'SCR002', message: expect.stringContaining(`The key ${key} occurs twice`) }]);
    }
  });

  test('with brackets, nested 100,000 deep, in the place of any part is refused', () => {
    const deep = `${'['.repeat(100_000)}${']'.repeat(100_000)}`;
    const texts = VALID[0] as ProjectTexts;
    for (const whole of [
      deep,
      texts.project.replace(/"graphs": \{/, `"graphs": {"deep": ${deep},`),
      texts.project.replace(/"title": "[^"]*"/, `"title": ${deep}`),
    ]) {
      const { output, diagnostics } = loadProject({ ...texts, project: whole });
      expect(output).toBeNull();
      expectAReason(diagnostics);
      expectWords(diagnostics);
    }
  });
});
