import { readdirSync, readFileSync } from 'node:fs';
import { join } from 'node:path';
import { expect, test } from '@jest/globals';
import { readMasters, syncCopies } from './copies.ts';

const LIBRARY = 'shader-library';

function read(folder: string, extension: string): Record<string, string> {
  const names = readdirSync(join(LIBRARY, folder)).filter((name) => name.endsWith(extension));
  return Object.fromEntries(names.map((name) => [`${folder}/${name}`, readFileSync(join(LIBRARY, folder, name), 'utf8')]));
}

const masters = readMasters(read('chunks/isf', '.glsl'));
const shaders = ['filters', 'operators', 'generators'].flatMap((folder) => Object.entries(read(folder, '.fs')));

test.each(shaders)('%s holds shared functions as their masters say; otherwise run `npm run sync-chunks`', (_path, text) => {
  expect(text).toBe(syncCopies(text, masters));
});

test.each([...masters.keys()])('%s is a copy in at least two files, declared once in each', (name) => {
  const declared = shaders.map(([, text]) => text.split(new RegExp(`^\\w+ ${name}\\(`, 'm')).length - 1);
  expect(declared.filter((count) => count > 0).length).toBeGreaterThanOrEqual(2);
  expect(Math.max(...declared)).toBe(1);
});

test('no function is in two files without a master', () => {
  const holders = new Map<string, Set<string>>();
  for (const [path, text] of shaders) {
    for (const [, body = ''] of text.matchAll(/^(\w+ \w+\([^)]*\) \{\n(?:[^}][^\n]*\n|\n)*\}\n)/gm)) {
      holders.set(body, (holders.get(body) ?? new Set()).add(path));
    }
  }
  const bodies = [...masters.values()].map((text) => text.replace(/^(\/\/[^\n]*\n)*/, ''));
  const loose = [...holders].filter(([body, paths]) => paths.size > 1 && !bodies.includes(body));
  expect(loose).toEqual([]);
});

test('a changed copy is put right, with its comment, and the rest of the file is left alone', () => {
  const before = 'uniform float a;\n\n// Old.\nfloat wrap(float whole) {\n  return whole;\n}\n\nvoid main() {\n  wrap(a);\n}\n';
  const after = syncCopies(before, masters);
  expect(after).toBe(before.replace('// Old.\nfloat wrap(float whole) {\n  return whole;\n}\n', masters.get('wrap') ?? ''));
  expect(after).not.toBe(before);
});

test.each([
  ['another name', 'float warp(float x) {\n  return x;\n}\n'],
  ['two functions', 'float wrap(float x) {\n  return x;\n}\nfloat b(float x) {\n  return x;\n}\n'],
  ['a constant', 'const float A = 1.0;\nfloat wrap(float x) {\n  return x;\n}\n'],
])('a master with %s is refused', (_what, text) => {
  expect(() => readMasters({ 'chunks/isf/wrap.glsl': text })).toThrow('chunks/isf/wrap.glsl does not hold exactly the function wrap.');
});
