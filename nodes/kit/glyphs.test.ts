import { describe, expect, test } from '@jest/globals';
import { charactersOf, readGlyphs, subsetGlyphs } from './glyphs.ts';

const FONT = '1490\t1984\t-494\n \t516\t\nA\t1529\tM254 0L52 0L593 1490Z\né\t1200\tM0 0Z';

describe('glyphs', () => {
  test('a subset has the characters of a text that the font has, each once', () => {
    expect(subsetGlyphs(FONT, 'A Aß')).toBe('1490\t1984\t-494\n \t516\t\nA\t1529\tM254 0L52 0L593 1490Z');
    expect(subsetGlyphs(FONT, '')).toBe('1490\t1984\t-494');
  });

  test('reads sizes, advances and paths', () => {
    const { capitalHeight, ascender, descender, byCharacter } = readGlyphs(FONT);
    expect([capitalHeight, ascender, descender]).toEqual([1490, 1984, -494]);
    expect([...byCharacter]).toEqual([
      [' ', { advance: 516, path: '' }],
      ['A', { advance: 1529, path: 'M254 0L52 0L593 1490Z' }],
      ['é', { advance: 1200, path: 'M0 0Z' }],
    ]);
    expect(() => readGlyphs('A\t1\t2')).toThrow('no sizes');
  });

  test('accents that follow their letter are one character with it', () => {
    expect(charactersOf('e\u0301A')).toEqual(['é', 'A']);
    expect(subsetGlyphs(FONT, 'e\u0301')).toContain('é');
  });
});
