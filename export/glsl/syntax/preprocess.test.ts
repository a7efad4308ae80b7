import { describe, expect, test } from '@jest/globals';
import { preprocess } from './preprocess.ts';
import { GlslError } from './token.ts';

function text(source: string): string {
  return preprocess(source)
    .slice(0, -1)
    .map((token) => token.text)
    .join(' ');
}

function failure(source: string): GlslError {
  try {
    preprocess(source);
  } catch (error) {
    if (error instanceof GlslError) return error;
  }
  throw new Error(`Nothing is wrong with ${source}`);
}

describe('macros', () => {
  test.each([
    ['objects', '#define A 1 + 2\nA * A', '1 + 2 * 1 + 2'],
    ['functions', '#define F(x, y) x * (y)\nF(1, f(2, 3))', '1 * ( f ( 2 , 3 ) )'],
    ['a name that is followed by no bracket', '#define F(x) x\nF + F (1)', 'F + 1'],
    ['a space before the bracket makes an object', '#define F (x)\nF', '( x )'],
    ['no parameters', '#define F() 1\nF() F( )', '1 1'],
    ['an empty argument', '#define F(x) [x]\nF()', '[ ]'],
    ['macros in macros', '#define A B\n#define B C\nA', 'C'],
    ['macros in arguments', '#define A 1\n#define F(x) x x\nF(A)', '1 1'],
    ['a macro that names itself', '#define A A + 1\nA', 'A + 1'],
    ['macros that name each other', '#define A B\n#define B A\nA B', 'A B'],
    ['a function macro that comes out of an object', '#define A F\n#define F(x) x + 1\nA(2)', '2 + 1'],
    // The C standard's own example of rescanning (C11 §6.10.3.5, example 3), shortened.
    [
      'rescanning',
      '#define x 3\n#define f(a) f(x * (a))\n#undef x\n#define x 2\n#define g f\n#define z z[0]\nf(f(z)) g(x + (3, 4))',
      'f ( 2 * ( f ( 2 * ( z [ 0 ] ) ) ) ) f ( 2 * ( 2 + ( 3 , 4 ) ) )',
    ],
    ['arguments over several lines', '#define F(x, y) x y\nF(1,\n 2\n)', '1 2'],
    ['joined lines', '#define A 1 \\\n + 2\nA', '1 + 2'],
    ['comments', '#define A 1 // one\nA /* two */ + A', '1 + 1'],
    ['words glued together', '#define CAT(a, b) a##b\n#define F(n) CAT(f, n) + my ## n\nF(1) CAT(, x) CAT(1.5, e3)', 'f1 + my1 x 1.5e3'],
    ['what is glued is not expanded before, but after', '#define A 1\n#define AB 2\n#define CAT(a, b) a ## b\nCAT(A, B)', '2'],
    ['the line', 'a\n__LINE__\n#define L __LINE__\nL', 'a 2 4'],
  ])('%s', (_, source, wanted) => {
    expect(text(source)).toBe(wanted);
  });

  test('what a macro brings has the place of its use, what it is given its own', () => {
    const tokens = preprocess('#define F(x) x + 1\n\n  F(\n abc)');
    expect(tokens.map(({ text: t, line, column }) => [t, line, column])).toEqual([
      ['abc', 4, 2],
      ['+', 3, 3],
      ['1', 3, 3],
      ['', 4, 6],
    ]);
  });
});

describe('conditions', () => {
  test.each([
    ['#if 1\na\n#else\nb\n#endif', 'a'],
    ['#if 0\na\n#elif 2 > 1\nb\n#elif 1\nc\n#else\nd\n#endif', 'b'],
    ['#ifdef SCRIM\na\n#endif', 'a'],
    ['#ifndef GL_ES\na\n#else\nb\n#endif', 'b'],
    ['#define A\n#if defined(A) && !defined B\na\n#endif', 'a'],
    ['#if __VERSION__ >= 300 && GL_ES == 1\na\n#endif', 'a'],
    ['#if (1 + 2 * 3 == 7) && (0x10 >> 2 == 4) && -1 < 0 && ~0 == -1 && (5 % 3 ^ 1) == 3\na\n#endif', 'a'],
    ['#define N 3\n#define M(x) (x) * N\n#if M(2) == 6\na\n#endif', 'a'],
    ['#if UNKNOWN\na\n#else\nb\n#endif', 'b'],
    ['#if 0\n#if 1\na\n#else\nb\n#endif\n#else\nc\n#endif', 'c'],
    ['#if 0\n“#nonsense”\n#error no\n#endif\na', 'a'],
    ['#if 1\n#if 0\n#elif 1\na\n#endif\n#endif', 'a'],
  ])('%j', (source, wanted) => {
    expect(text(source)).toBe(wanted);
  });
});

test.each([
  ['#if 1\na', 1, 2, '#endif'],
  ['a\n#endif', 2, 2, '#if'],
  ['#if 1\n#else\n#else\n#endif', 3, 2, '#else'],
  ['#if 1 +\n#endif', 1, 7, 'not complete'],
  ['#if 1.5\n#endif', 1, 5, '1.5'],
  ['#if 1 / 0\n#endif', 1, 7, 'zero'],
  ['#define F(x) x\nF(1, 2)', 2, 1, '1 argument, but 2'],
  ['#define F(x) x\n  F(1', 2, 3, 'never closed'],
  ['#define F(a) a ## +\n F(x)', 2, 2, '"x+"'],
  ['#define 3', 1, 9, 'name of a macro'],
  ['#define F(a +', 1, 13, 'list of names'],
  ['#define F(a', 1, 9, 'list of names'],
  ['\n  #error too old', 2, 3, 'too old'],
  ['#pragmatic', 1, 2, 'pragmatic'],
  ['/* open', 1, 1, '*/'],
])('%j is refused at its place', (source, line, column, word) => {
  const error = failure(source);
  expect(error.place).toEqual({ line, column });
  expect(error.message).toContain(word);
});
