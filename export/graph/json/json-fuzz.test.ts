import { describe, expect, test } from '@jest/globals';
import fc from 'fast-check';
import { loadProject } from '../load.ts';
import { saveProject } from '../save.ts';

const VALID = JSON.stringify({
  format: 'scrim-project',
  version: 1,
  title: 'T',
  page: { language: 'de' },
  graphs: {
    main: {
      nodes: {
        'video-a1b2': { type: 'source/camera-video', version: 1 },
        'sepia-k7q2': {
          type: 'filter/sepia',
          version: 1,
          muted: true,
          unfused: true,
          params: {
            amount: 0.5,
            tint: [1, 0, 0, 1],
            a: { port: 1 },
            b: { expression: 'x' },
            c: { track: { keys: [{ timeS: 0, value: 1 }] } },
          },
        },
      },
      wires: ['video-a1b2.layer -> sepia-k7q2.inputImage'],
      exposed: { inputs: [{ name: 'in', node: 'sepia-k7q2', port: 'inputImage' }], outputs: [] },
    },
  },
  assets: { 'fox-aaaa': { path: 'assets/fox.glb', kind: 'model' } },
});

/** What the loader promises of any text: an answer, with a reason where there is no project, and a project that saves. */
function expectAnAnswer(text: string): void {
  const { output, diagnostics } = loadProject({ project: text, layout: text, sources: {} });
  if (output === null) {
    expect(diagnostics.some(({ severity }) => severity === 'error')).toBe(true);
    return;
  }
  const saved = saveProject(output);
  expect(loadProject(saved)).toEqual({ output, diagnostics: [] });
}

const anyJson = fc.json({ maxDepth: 6 });

/** Replaces any part of the valid document, keys included, by something else. */
function withPart(json: unknown, at: number, part: unknown): { readonly value: unknown; readonly left: number } {
  if (at === 0) return { value: part, left: -1 };
  if (typeof json !== 'object' || json === null) return { value: json, left: at - 1 };
  let left = at - 1;
  const entries = Object.entries(json).map(([key, value]) => {
    const inner = left < 0 ? { value, left } : withPart(value, left, part);
    left = inner.left;
    return [key, inner.value] as const;
  });
  const value = Array.isArray(json) ? entries.map(([, item]) => item) : Object.fromEntries(entries);
  return { value, left };
}

describe('whatever the file holds', () => {
  test('any JSON gives an answer', () => {
    fc.assert(fc.property(anyJson, expectAnAnswer), { seed: 1, numRuns: 300 });
  });

  test('any text gives an answer', () => {
    fc.assert(fc.property(fc.string({ unit: 'binary', maxLength: 200 }), expectAnAnswer), { seed: 1, numRuns: 300 });
  });

  test('a document cut off anywhere gives an answer', () => {
    for (let end = 0; end < VALID.length; end += 3) expectAnAnswer(VALID.slice(0, end));
  });

  test('a document with any part replaced gives an answer', () => {
    const parts = fc.oneof(
      fc.jsonValue({ maxDepth: 3 }),
      fc.constantFrom('__proto__', 'a-b.c -> d-e.f', 1e308, -0, { port: [1] }, { constructor: 1 }),
    );
    fc.assert(
      fc.property(fc.nat(40), parts, (at, part) => expectAnAnswer(JSON.stringify(withPart(JSON.parse(VALID), at, part).value))),
      { seed: 1, numRuns: 500 },
    );
  });

  test('a document with any character changed gives an answer', () => {
    fc.assert(
      fc.property(fc.nat(VALID.length - 1), fc.string({ unit: 'binary-ascii', minLength: 1, maxLength: 1 }), (at, character) =>
        expectAnAnswer(VALID.slice(0, at) + character + VALID.slice(at + 1)),
      ),
      { seed: 1, numRuns: 500 },
    );
  });
});
