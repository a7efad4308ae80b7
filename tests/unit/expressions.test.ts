import { describe, expect, test } from '@jest/globals';
import fc from 'fast-check';
import { isSizeProblem, parseSizeExpression } from '../../export/glsl/isf/size-expression.ts';
import { parseExpression } from '../../export/graph/expression/expression-parser.ts';
import { EXPRESSION_FUNCTIONS, EXPRESSION_OPERATORS } from '../../nodes/kit/expression.ts';
import { playExpression } from '../../nodes/kit/play-expression.ts';
import { playSize, SIZE_STACK_BOTTOM } from '../../nodes/kit/play-size.ts';

/** Expressions as Scrim reads and plays them, beside what JavaScript makes of the same text. */

const NAMES = ['a', 'b', 'c', 'd'] as const;

/** Values of a, b, c, d and of the clock. */
interface Given {
  readonly numbers: readonly number[];
  readonly timeS: number;
  readonly frame: number;
}

function played(text: string, { numbers, timeS, frame }: Given): number {
  const parsed = parseExpression(text, 1, NAMES);
  if (!parsed.ok) throw new Error(`${text}: ${parsed.message} (${parsed.column})`);
  const views = Object.fromEntries(NAMES.map((name, i) => [name, { value: numbers[i] ?? 0 }]));
  const expression = playExpression(parsed.parts.join(' '), views);
  expression.update({ timeS, frame });
  expect(expression.results).toHaveLength(1);
  return expression.results[0] ?? Number.NaN;
}

/** What GLSL ES 3.00 §8 has and JavaScript has not, word for word. */
const GLSL = `
  const { sin, cos, tan, asin, acos, atan, atan2, sqrt, pow, exp, log, abs, sign, floor, ceil, round, min, max, PI: pi } = Math;
  const tau = 2 * pi;
  const fract = (x) => x - floor(x);
  const mod = (x, y) => x - y * floor(x / y);
  const clamp = (x, low, high) => min(max(x, low), high);
  const mix = (x, y, a) => x * (1 - a) + y * a;
  const step = (edge, x) => (x < edge ? 0 : 1);
  const smoothstep = (edge0, edge1, x) => { const t = clamp((x - edge0) / (edge1 - edge0), 0, 1); return t * t * (3 - 2 * t); };
`;

function byJavaScript(text: string, { numbers, timeS, frame }: Given): number {
  const compute = new Function(...NAMES, 'time', 'frame', `${GLSL} return Number(${text});`) as (...given: number[]) => number;
  return compute(...numbers, timeS, frame);
}

const given: fc.Arbitrary<Given> = fc.record({
  numbers: fc.array(fc.oneof(fc.integer({ min: -3, max: 3 }), fc.double({ min: -100, max: 100, noNaN: true })), {
    minLength: 4,
    maxLength: 4,
  }),
  timeS: fc.double({ min: 0, max: 1000, noNaN: true }),
  frame: fc.nat(10_000),
});

const literal = fc.oneof(
  fc.nat(9).map(String),
  fc.double({ min: 0, max: 10, noNaN: true }).map((number) => String(number + 0)),
  fc.constantFrom(...NAMES, 'time', 'frame', 'pi', 'tau', '.5', '2.', '1e2'),
);

describe('an expression gives what JavaScript gives', () => {
  /** Nothing but what is written alike and binds alike in both, so that the very same text is given to both. */
  const { flat } = fc.letrec<{ atom: string; flat: string; condition: string }>((tie) => ({
    atom: fc.oneof(
      { maxDepth: 4 },
      literal,
      tie('flat').map((inner) => `(${inner})`),
      tie('flat').map((inner) => `- (${inner})`),
      fc.tuple(tie('condition'), tie('flat'), tie('flat')).map(([when, yes, no]) => `(${when} ? ${yes} : ${no})`),
    ),
    flat: fc.tuple(tie('atom'), fc.array(fc.tuple(fc.constantFrom('+', '-', '*', '/'), fc.boolean(), tie('atom')), { maxLength: 4 })).map(
      ([first, more]) =>
        first +
        more
          .map(([sign, minus, atom]) => ` ${sign} ${minus ? '-' : ''}${atom}`)
          .join('')
          .replaceAll('--', '- -'),
    ),
    condition: fc
      .array(fc.tuple(tie('flat'), fc.constantFrom('<', '<=', '>', '>=', '==', '!='), tie('flat'), fc.constantFrom('&&', '||')), {
        minLength: 1,
        maxLength: 3,
      })
      .map((parts) => parts.map(([left, sign, right, and], i) => `${i === 0 ? '' : `${and} `}${left} ${sign} ${right}`).join(' ')),
  }));

  test('of sums, products, comparisons and choices, with the order that operators have', () => {
    fc.assert(
      fc.property(flat, given, (text, numbers) => {
        expect(played(text, numbers)).toBe(byJavaScript(text, numbers));
      }),
      { seed: 11, numRuns: 500 },
    );
  });

  /** In brackets throughout: for Scrim, and for JavaScript. */
  type Both = readonly [scrim: string, javaScript: string];
  const { tree } = fc.letrec<{ tree: Both }>((tie) => ({
    tree: fc.oneof(
      { maxDepth: 5, depthSize: 'medium' },
      literal.map((text): Both => [text, text]),
      tie('tree').map(([scrim, js]): Both => [`(-${scrim})`, `(- ${js})`]),
      tie('tree').map(([scrim, js]): Both => [`(!${scrim})`, `Number(!${js})`]),
      fc.tuple(tie('tree'), tie('tree'), tie('tree')).map((parts): Both => {
        const [when, yes, no] = parts;
        return [`(${when[0]} ? ${yes[0]} : ${no[0]})`, `(${when[1]} ? ${yes[1]} : ${no[1]})`];
      }),
      fc.tuple(fc.constantFrom(...EXPRESSION_OPERATORS), tie('tree'), tie('tree')).map(([sign, left, right]): Both => {
        const scrim = `(${left[0]} ${sign} ${right[0]})`;
        if (sign === '^') return [scrim, `pow(${left[1]}, ${right[1]})`];
        if (sign === '%') return [scrim, `mod(${left[1]}, ${right[1]})`];
        const logic = sign === '&&' || sign === '||';
        return [scrim, logic ? `Number(Boolean(${left[1]} ${sign} ${right[1]}))` : `Number(${left[1]} ${sign} ${right[1]})`];
      }),
      fc
        .tuple(fc.constantFrom(...Object.entries(EXPRESSION_FUNCTIONS)), tie('tree'), tie('tree'), tie('tree'))
        .map(([[name, takes], ...parts]): Both => {
          const used = parts.slice(0, takes.length);
          return [`${name}(${used.map(([scrim]) => scrim).join(', ')})`, `${name}(${used.map(([, js]) => js).join(', ')})`];
        }),
    ),
  }));

  test('of every function and operator, to the bit', () => {
    fc.assert(
      fc.property(tree, given, ([scrim, javaScript], numbers) => {
        expect(played(scrim, numbers)).toBe(byJavaScript(javaScript, numbers));
      }),
      { seed: 12, numRuns: 800 },
    );
  });

  test('of each function by itself', () => {
    const numbers: Given = { numbers: [0.3, 0.7, 0.45, 2], timeS: 1.25, frame: 30 };
    for (const [name, takes] of Object.entries(EXPRESSION_FUNCTIONS)) {
      const text = `${name}(${NAMES.slice(0, takes.length).join(', ')})`;
      const computed = played(text, numbers);
      expect(computed).toBe(byJavaScript(text, numbers));
      expect(computed).not.toBeNaN();
    }
  });
});

describe('a param and a size of a shader give the same number', () => {
  test.each([
    ['-7 % 3', 2],
    ['7 % -3', -2],
    ['-7 % -3', -1],
    ['-7.5 % 2', 0.5],
    ['mod(-1, 16)', 15],
    ['-2 ^ 2', -4],
    ['2 ^ -1', 0.5],
    ['floor(-2.5) + ceil(-2.5)', -5],
    ['round(-2.5)', -2],
    ['-1 < 0 ? -10 : 10', -10],
    ['!-1 || -1', 1],
  ])('%s', (text, expected) => {
    expect(played(text, { numbers: [], timeS: 0, frame: 0 })).toBe(expected);
    expect(playedAsSize(text)).toBe(expected);
  });
});

function playedAsSize(text: string): number {
  const size = parseSizeExpression(text, () => false);
  if (isSizeProblem(size)) throw new Error(`${text}: ${size.message}`);
  const stack = new Float64Array(SIZE_STACK_BOTTOM + size.length);
  expect(playSize(size, 640, 360, () => {}, null, stack)).toBe(true);
  return stack[SIZE_STACK_BOTTOM] ?? Number.NaN;
}

test('postfix that no compiler prints is a fault', () => {
  expect(() => playExpression('1 +')).toThrow('too few operands');
  expect(() => playExpression('1 constructor')).toThrow('not a word');
});

test('several results stand in the order of the list', () => {
  const parsed = parseExpression('[time, frame * 2, 1]', 3);
  if (!parsed.ok) throw new Error(parsed.message);
  const expression = playExpression(parsed.parts.join(' '));
  expression.update({ timeS: 0.5, frame: 3 });
  expect([...expression.results]).toEqual([0.5, 6, 1]);
});
