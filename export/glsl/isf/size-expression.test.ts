import { describe, expect, test } from '@jest/globals';
import fc from 'fast-check';
import { playSize, SIZE_STACK_BOTTOM } from '../../../nodes/kit/play-size.ts';
import type { NamedSize } from './isf-shader.ts';
import { isSizeProblem, parseSizeExpression } from './size-expression.ts';

const PARAMS = new Map([['radius', 3]]);

function evaluate(text: string, width = 640, height = 360): number {
  const size = parseSizeExpression(text, (name) => PARAMS.has(name));
  if (isSizeProblem(size)) throw new Error(size.message);
  return run(size, width, height);
}

function run(size: NamedSize, width: number, height: number): number {
  const stack = new Float64Array(SIZE_STACK_BOTTOM + size.length);
  const put = ({ param }: { readonly param: string }, values: typeof PARAMS, into: Float64Array, at: number) => {
    into[at] = values.get(param) ?? Number.NaN;
  };
  expect(playSize(size, width, height, put, PARAMS, stack)).toBe(true);
  return stack[SIZE_STACK_BOTTOM] ?? Number.NaN;
}

describe('size expressions', () => {
  test.each([
    ['$WIDTH/2.0', 320],
    ['floor(max($WIDTH*0.25,1.0))', 160],
    ['$radius', 3],
    ['  $HEIGHT - 2 * $radius ', 354],
    ['($WIDTH + $HEIGHT) / 10', 100],
    ['-3 + 10 - 4 - 1', 2],
    ['100 / 10 / 5', 2],
    ['min(1e2, abs(-.5e1)) % 3', 2],
    ['round(sqrt(ceil(8.2)))', 3],
    ['2 * -3 + +9', 3],
    ['pow(2, $radius) + 2 ^ 3 ^ 2 - 512', 8],
    ['-2 ^ 2 + 2 * 3 ^ 2', 14],
    ['log2($WIDTH / 10)', 6],
    ['mod($WIDTH, 7)', 3],
    ['-7 % 3', 2],
    ['mod(7, -3)', -2],
    ['-7 % -3', -1],
    ['$WIDTH > $HEIGHT ? $WIDTH : $HEIGHT', 640],
    ['$radius == 1 ? 1 : $radius == 3 ? 30 : 5', 30],
    ['(1 < 2) + (2 <= 2) + (3 >= 3) + (4 > 3) + (1 != 2) + (1 == 1)', 6],
    ['(2 < 1) + (2 <= 1) + (2 >= 3) + (3 > 3) + (2 != 2) + (1 == 2)', 0],
    ['1 + 1 == 2 && !(1 > 2 || 0) ? 4 : 8', 4],
    ['0 || 1 && 0', 0],
    ['max($WIDTH > 100 ? 2 : 1, 1)', 2],
  ])('%s', (text, value) => {
    expect(evaluate(text)).toBe(value);
  });

  test.each([
    ['', 0],
    ['$WIDTH +', 8],
    ['$NOTHING', 0],
    ['2 $WIDTH', 2],
    ['sin(2)', 0],
    ['1 ? 2', 5],
    ['1 = 2', 2],
    ['1 < ', 4],
    ['2 !', 2],
    ['max(1)', 5],
    ['(1 + 2', 6],
    ['1 + #', 4],
    ['$WIDTH / 2px', 10],
  ])('"%s" is refused at character %d', (text, offset) => {
    const problem = parseSizeExpression(text, () => false);
    expect(isSizeProblem(problem) && problem.offset).toBe(offset);
  });

  test('sums and products come out as JavaScript has them', () => {
    const term = fc.tuple(fc.integer({ min: 1, max: 50 }), fc.constantFrom('+', '-', '*', '/'));
    fc.assert(
      fc.property(fc.array(term, { minLength: 1, maxLength: 8 }), (terms) => {
        const text = `${terms.map(([value, operator]) => `${value} ${operator}`).join(' ')} 1`;
        // Only digits and operators of our own making.
        expect(evaluate(text)).toBeCloseTo(Number(new Function(`return ${text}`)()), 9);
      }),
      { seed: 7 },
    );
  });
});
