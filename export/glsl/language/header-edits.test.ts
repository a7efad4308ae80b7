import { describe, expect, test } from '@jest/globals';
import { moveImported, moveInHeader, readHeaderForm, setInHeader } from './header-edits.ts';

const SOURCE = `/*{
  // Whose it is.
  "CREDIT": "me", "FUTURE_KEY": { "deep": [1, 2] },
  "INPUTS": [
    { "NAME": "inputImage", "TYPE": "image" }, // the picture
    { "NAME": "amount", "TYPE": "float", // how much
      "MIN": 0, "X": null }
  ]
}*/
void main() { gl_FragColor = vec4(amount); }
`;

const only = (from: string, to: string) => SOURCE.replace(from, to);

describe('editing a header', () => {
  test.each([
    ['a value', ['CREDIT'], 'you', only('"me"', '"you"')],
    ['a text that would end the comment', ['CREDIT'], 'a */ b', only('"me"', '"a *\\/ b"')],
    ['a number', ['INPUTS', 1, 'MIN'], -1.5, only('"MIN": 0', '"MIN": -1.5')],
    ['a new key of an object on one line', ['INPUTS', 0, 'LABEL'], 'Picture', only('"image" }', '"image", "LABEL": "Picture" }')],
    ['a new key on a line of its own', ['PASSES'], [{ TARGET: 'a' }], only('  ]\n}*/', '  ],\n  "PASSES": [{ "TARGET": "a" }]\n}*/')],
    ['a list that is not there yet', ['CATEGORIES', 0], 'Blur', only('  ]\n}*/', '  ],\n  "CATEGORIES": ["Blur"]\n}*/')],
    ['another item', ['INPUTS', 2], { NAME: 'b', TYPE: 'bool' }, only('"X": null }', '"X": null },\n    { "NAME": "b", "TYPE": "bool" }')],
    ['a key that goes', ['CREDIT'], undefined, only('"CREDIT": "me", ', '')],
    ['the last key that goes', ['INPUTS', 1, 'X'], undefined, only(', "X": null', '')],
    ['a key before a comment', ['INPUTS', 1, 'MIN'], undefined, only('"MIN": 0, ', '')],
    [
      'the last item that goes',
      ['INPUTS', 1],
      undefined,
      only(
        ' // the picture\n    { "NAME": "amount", "TYPE": "float", // how much\n      "MIN": 0, "X": null }',
        ' // the picture\n    ',
      ).replace('" },', '" }'),
    ],
  ] as const)('%s, and nothing else', (_, path, value, expected) => {
    const edited = setInHeader(SOURCE, path, value) ?? '';
    expect(edited).toBe(expected);
    expect(readHeaderForm(edited)).not.toBeNull();
  });

  test('items change places with all that is theirs', () => {
    const moved = moveInHeader(SOURCE, ['INPUTS'], 1, 0) ?? '';
    expect(readHeaderForm(moved)?.inputs.map(({ NAME }) => NAME)).toEqual(['amount', 'inputImage']);
    expect(moved).toContain('// how much');
    expect(moveInHeader(SOURCE, ['INPUTS'], 1, 2)).toBeNull();
  });

  test('imported pictures are found where they are now, in every way of naming them', () => {
    const moved = new Map([
      ['a.png', '../assets/a-2.png'],
      ['x.png', '../assets/x.png'],
    ]);
    const list = '/*{ "IMPORTED": [{ "NAME": "a", "PATH": "a.png" }, { "NAME": "b", "PATH": "b.png" }] }*/';
    expect(moveImported(list, moved)).toBe(list.replace('a.png', '../assets/a-2.png'));
    const cube = '/*{ "IMPORTED": { "c": { "PATH": ["x.png", "b.png", "x.png"] }, "a": { "PATH": "a.png" } } }*/';
    expect(moveImported(cube, moved)).toBe(cube.replaceAll('x.png', '../assets/x.png').replace('a.png', '../assets/a-2.png'));
    expect(moveImported(SOURCE, moved)).toBe(SOURCE);
  });

  test('a header that cannot be read is left alone', () => {
    expect(moveImported('/*{ "IMPORTED": [ */', new Map([['a', 'b']]))).toBe('/*{ "IMPORTED": [ */');
    expect(setInHeader('/*{ "INPUTS": [ */', ['CREDIT'], 'x')).toBeNull();
    expect(readHeaderForm('void main() {}')).toBeNull();
  });

  test('a form shows what stands there', () => {
    expect(readHeaderForm(SOURCE)).toMatchObject({
      credit: 'me',
      inputs: [{ NAME: 'inputImage' }, { NAME: 'amount', MIN: 0 }],
      passes: [],
    });
  });
});
