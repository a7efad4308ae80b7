import { readFile } from 'node:fs/promises';
import { describe, expect, test } from '@jest/globals';
import { checkStrings } from './check.ts';
import { collectStrings } from './main.ts';
import { printTable, readStrings, STRINGS_TABLE } from './read-strings.ts';

const kindsAndTexts = (path: string, source: string) => readStrings(path, source).map(({ kind, text }) => [kind, text]);

describe('strings that a user reads', () => {
  test('are found by the place where they stand', () => {
    const source = `
      import { x } from 'Not a string';
      export const command = { label: 'Save all', run: save };
      const message = \`The file \${name} is empty.\`;
      export const port = { type: 'layer', label: 'Layer', keywords: ['Not this one'] };
      if (bad) throw new Error('Only programmers read this.');
      report({ code, message, fix: ok ? 'Choose a file.' : 'Choose a folder.' });
      view.textContent = 'Two words';
      match(/x/, 'nothing');`;
    expect(kindsAndTexts('renderer/a.ts', source)).toEqual([
      ['command', 'Save all'],
      ['problem', 'The file {} is empty.'],
      ['label', 'Layer'],
      ['remedy', 'Choose a file.'],
      ['remedy', 'Choose a folder.'],
      ['text', 'Two words'],
    ]);
  });

  test('are found in elements and their attributes', () => {
    const source = '<p className="Not this"><b title="A hint">Press</b> {key} to stop<Row label={on ? "On" : "Off"} /></p>';
    expect(kindsAndTexts('renderer/a.tsx', `export const view = ${source};`)).toEqual([
      ['ui', '{} {} to stop{}'],
      ['ui', 'Press'],
      ['ui', 'A hint'],
      ['ui', 'On'],
      ['ui', 'Off'],
    ]);
  });

  test('are found in the headers of shaders', () => {
    const header = '/*{ "SCRIM_TITLE": "LUT", "INPUTS": [{ "NAME": "a", "LABEL": "Amount", "DOC": "How \\"much\\"." }] }*/ void main() {}';
    expect(kindsAndTexts('shader-library/filters/a.fs', header)).toEqual([
      ['title', 'LUT'],
      ['label', 'Amount'],
      ['doc', 'How "much".'],
    ]);
  });

  test('are found in the projects of examples', () => {
    const project = '{ "title": "Sepia", "page": { "description": "Brown tones." }, "graphs": { "main": { "title": "Not this" } } }';
    expect(kindsAndTexts('examples/sepia/project.scrim.json', project)).toEqual([
      ['title', 'Sepia'],
      ['doc', 'Brown tones.'],
    ]);
  });
});

test('each kind has its rules', () => {
  const faults = (kind: 'command' | 'problem' | 'remedy', text: string) => checkStrings([{ file: 'a.ts', kind, text }]);
  expect(faults('command', 'Import Shadertoy…')).toEqual([]);
  expect(faults('command', 'Save')).toEqual([]);
  expect(faults('command', 'Save Page')).toHaveLength(1);
  expect(faults('command', 'Go to the next key.')).toHaveLength(2);
  expect(faults('problem', 'Input “{}” is not connected.')).toEqual([]);
  expect(faults('problem', 'Input “{}” is not connected')).toHaveLength(1);
  expect(faults('problem', `This is ${'very '.repeat(20)}long.`)).toHaveLength(1);
  expect(faults('remedy', 'Connect a layer.')).toEqual([]);
  expect(faults('remedy', 'There is a layer.')).toHaveLength(1);
  const twice = ['Choose another file, please.', 'Choose another file, please!'];
  expect(checkStrings(twice.map((text) => ({ file: 'a.ts', kind: 'text', text })))).toEqual([expect.stringContaining('Nearly equal')]);
});

test(`${STRINGS_TABLE} is what \`npm run strings\` writes, and keeps the rules`, async () => {
  const strings = await collectStrings('.');
  expect(await readFile(STRINGS_TABLE, 'utf8')).toBe(printTable(strings));
  expect(checkStrings(strings)).toEqual([]);
});
