import { describe, expect, test } from '@jest/globals';
import fc from 'fast-check';
import type { NamedSize } from './isf-shader.ts';
import { isSizeProblem, parseSizeExpression } from './size-expression.ts';

const PARAMS = new Map([['radius', 3]]);

function evaluate(text: string, width = 640, height = 360): number {
  const size = parseSizeExpression(text, (name) => PARAMS.has(name));
  if (isSizeProblem(size)) throw new Error(size.message);
  return run(size, width, height);
}

/** The stack machine that the program format describes. */
function run(size: NamedSize, width: number, height: number): number {
  const stack: number[] = [];
  for (const item of size) {
    if (typeof item === 'number') stack.push(item);
    else if ('param' in item) stack.push(PARAMS.get(item.param) ?? Number.NaN);
    else if (item.op === 'width') stack.push(width);
    else if (item.op === 'height') stack.push(height);
    else if (item.op === 'negate') stack.push(-(stack.pop() ?? 0));
    else if (item.op === 'floor' || item.op === 'ceil' || item.op === 'round' || item.op === 'abs' || item.op === 'sqrt') {
      stack.push(Math[item.op](stack.pop() ?? 0));
    } else {
      const b = stack.pop() ?? 0;
      const a = stack.pop() ?? 0;
      stack.push({ '+': a + b, '-': a - b, '*': a * b, '/': a / b, '%': a % b, min: Math.min(a, b), max: Math.max(a, b) }[item.op]);
    }
  }
  expect(stack).toHaveLength(1);
  return stack[0] ?? Number.NaN;
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
  ])('%s', (text, value) => {
    expect(evaluate(text)).toBe(value);
  });

  test.each([
    ['', 0],
    ['$WIDTH +', 8],
    ['$NOTHING', 0],
    ['2 $WIDTH', 2],
    ['pow(2, 3)', 0],
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
