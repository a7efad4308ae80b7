import { describe, expect, test } from '@jest/globals';
import fc from 'fast-check';
import { parseExpression } from './expression-parser.ts';

const NAMES = ['a', 'b', 'c', 'd'];

/** The postfix, or the message and where. */
function read(text: string, count = 1): string | readonly [message: string, column: number] {
  const parsed = parseExpression(text, count, NAMES);
  return parsed.ok ? parsed.parts.join(' | ') : [parsed.message, parsed.column];
}

describe('an expression becomes postfix', () => {
  test.each([
    ['1', '1'],
    ['.5', '0.5'],
    ['1.5e-3', '0.0015'],
    [' time*2 ', 'time 2 *'],
    ['1 + 2 * 3', '1 2 3 * +'],
    ['(1 + 2) * 3', '1 2 + 3 *'],
    ['1 - 2 - 3', '1 2 - 3 -'],
    ['2 ^ 3 ^ 2', '2 3 2 ^ ^'],
    ['-a ^ 2', 'a 2 ^ negate'],
    ['2 ^ -a', '2 a negate ^'],
    ['-a * b', 'a negate b *'],
    ['--a', 'a negate negate'],
    ['+a', 'a'],
    ['!a == b', 'a ! b =='],
    ['a < b && c >= d || !a', 'a b < c d >= && a ! ||'],
    ['a ? b : c ? d : 1', 'a b c d 1 ?: ?:'],
    ['a > 1 ? b + 1 : c', 'a 1 > b 1 + c ?:'],
    ['pow(a, 2) + mod(b, 3) % 4', 'a 2 ^ b 3 % 4 % +'],
    ['min(a, b, c, d)', 'a b min c min d min'],
    ['tau / pi', '6.283185307179586 3.141592653589793 /'],
    ['smoothstep(0, 1, fract(time))', '0 1 time fract smoothstep'],
    ['frame % 2', 'frame 2 %'],
    ['a − b × c ÷ 2 ≤ 1', 'a b c * 2 / - 1 <='],
  ])('%s → %s', (text, postfix) => {
    expect(read(text)).toBe(postfix);
  });

  test('a list gives a postfix for each of its numbers', () => {
    expect(read('[sin(time), 0, a ? 1 : 2]', 3)).toBe('time sin | 0 | a 1 2 ?:');
  });
});

describe('what cannot be read is told with its column', () => {
  test.each([
    ['', 1, 'Expected a number, a name or a bracket instead of the end'],
    ['1 +', 4, 'instead of the end'],
    ['1 2', 3, 'Expected an operator or the end instead of “2”'],
    ['(1', 3, 'Expected “)” instead of the end'],
    ['1)', 2, 'Expected an operator or the end instead of “)”'],
    ['1 # 2', 3, '“#” is not expected here'],
    ['1 + 🦊', 5, '“🦊” is not expected here'],
    ['speed * 2', 1, 'Unknown name “speed”; use one of a, b, c, d, time, frame, pi, tau'],
    ['constructor', 1, 'Unknown name “constructor”'],
    ['2 * sine(a)', 5, 'Unknown function “sine”; use one of sin, cos, tan, asin'],
    ['eval(1)', 1, 'Unknown function'],
    ['sin', 4, 'Expected the “(” of sin(angle)'],
    ['mix(1, 2)', 1, 'mix(from, to, amount) takes 3 arguments but has 2'],
    ['sin(1, 2)', 1, 'sin(angle) takes at most 1 argument'],
    ['a < b < c', 7, 'write a < b && b < c'],
    ['a ? b', 6, 'the “:” of “? :”'],
    ['[1, 2, 3]', 1, 'Expected one number'],
    ['1e999', 1, '1e999 is too large'],
    ['a = 1', 3, '“=” is not expected here'],
    ['a.b', 2, '“.” is not expected here'],
    ['"x"', 1, '“"” is not expected here'],
    ['a; b', 2, '“;” is not expected here'],
  ])('%s at %d', (text, column, message) => {
    const [told, at] = read(text) as readonly [string, number];
    expect(told).toContain(message);
    expect(at).toBe(column);
  });

  test.each([
    ['brackets', '('.repeat(10_000), 65],
    ['signs', `${'-'.repeat(10_000)}1`, 65],
    ['powers', `${'1^'.repeat(5000)}1`, 129],
  ])('thousands of %s within each other', (_, text, column) => {
    expect(read(text)).toEqual(['Brackets and operations are nested more than 64 deep', column]);
  });

  test('a list has as many numbers as are wanted', () => {
    expect(read('1', 3)).toEqual(['Expected 3 numbers in brackets: [0, 0, 0]', 1]);
    expect(read('[1, 2]', 3)).toEqual(['Expected 3 numbers in brackets: [0, 0, 0]', 1]);
    expect(read('[1, 2, 3', 3)).toEqual(['Expected “]” instead of the end', 9]);
  });
});

test('any text gives an answer, and long ones soon', () => {
  const bits = fc.constantFrom(...'0 1 a b time ( ) [ ] , ? : + - * / % ^ < == && ! sin min mix . _ é'.split(' '));
  const texts = fc.oneof(
    fc.string({ unit: 'binary', maxLength: 60 }),
    fc.array(bits, { maxLength: 40 }).map((words) => words.join(' ')),
  );
  fc.assert(
    fc.property(texts, fc.integer({ min: 1, max: 4 }), (text, count) => {
      const parsed = parseExpression(text, count, NAMES);
      if (parsed.ok) return expect(parsed.parts).toHaveLength(count);
      expect(parsed.message).not.toBe('');
      expect(parsed.column).toBeGreaterThanOrEqual(1);
      expect(parsed.column).toBeLessThanOrEqual(text.length + 1);
    }),
    { seed: 1, numRuns: 600 },
  );
  expect(read(`${'1 + '.repeat(20_000)}1`)).toHaveLength(80_001);
});
