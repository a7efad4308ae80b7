import { describe, expect, test } from '@jest/globals';
import { checkIsf } from '../isf/checked-isf.ts';
import { readIsf } from '../isf/read-isf.ts';
import { countRounds } from './count-rounds.ts';

const HEADER = '/*{ "ISFVSN": "2", "INPUTS": [{ "NAME": "amount", "TYPE": "float" }, { "NAME": "count", "TYPE": "long" }] }*/';

function rounds(body: string, before = ''): number {
  const { output } = readIsf(`${HEADER}\n${before}\nvoid main() { float sum = 0.0; ${body} gl_FragColor = vec4(sum); }`, 'test.fs');
  if (output === null) throw new Error('unreadable');
  return countRounds(checkIsf(output).checked);
}

describe('rounds that the text tells', () => {
  test.each([
    ['no loop', 'sum += 1.0;', 0],
    ['up', 'for (int i = 0; i < 8; i++) sum += 1.0;', 9],
    ['up to and with', 'for (int i = -2; i <= 2; ++i) { sum += float(i); }', 5],
    ['down', 'for (int i = 8; i > 0; i -= 2) sum += 1.0;', 5],
    ['by a fraction', 'for (float x = 0.0; x < 1.0; x += 0.25) sum += sin(x);', 5],
    ['one in another', 'for (int y = 0; y <= 3; y++) for (int x = 0; x <= 4; x++) sum += 1.0;', 24],
    ['the nearer of two ends', 'for (int i = 0; i < 100 && i <= 3; i++) sum += 1.0;', 4],
    ['with a way out', 'for (int i = 0; i <= 9; i++) { if (i > count) break; }', 10],
  ])('%s', (_, body, most) => {
    expect(rounds(body)).toBe(most);
  });

  test('through constants, macros and functions, as often as these are called', () => {
    const before = 'const int N = 3;\n#define M 0x4u\nfloat f() { float s = 0.0; for (int i = 0; i <= N; i++) s += 1.0; return s; }';
    expect(rounds('sum = f() + f(); for (uint j = 0u; j <= M; j++) sum += f();', before)).toBeGreaterThanOrEqual(8 + 5 + 20);
    expect(rounds('sum = f() + f(); for (int j = 0; j <= 3; j++) sum += f();', before)).toBe(8 + 4 * 5);
  });
});

test.each([
  ['while', 'while (sum < 1.0) sum += 0.5;'],
  ['do', 'do { sum += 0.5; } while (sum < 1.0);'],
  ['an end that an input sets', 'for (int i = 0; i < count; i++) sum += 1.0;'],
  ['the wrong way', 'for (int i = 0; i < 8; i--) sum += 1.0;'],
  ['no step', 'for (int i = 0; i < 8; i += 0) sum += 1.0;'],
  ['a step that is lost', 'for (float x = 1e8; x < 2e8; x += 1.0) sum += 1.0;'],
  ['no end', 'for (int i = 0; ; i++) { sum += 1.0; if (sum > 3.0) break; }'],
  ['a counter that the body turns back', 'for (int i = 0; i < 8; i++) { if (sum < 3.0) i = 0; sum += 0.1; }'],
  ['a counter that a function turns back', 'for (int i = 0; i < 8; i++) back(i);'],
  ['another loop’s counter', 'int i = 0; for (int j = 0; i < 8; j++) { i++; }'],
])('nobody can tell: %s', (_, body) => {
  expect(rounds(body, 'void back(inout int i) { i--; }')).toBe(Number.POSITIVE_INFINITY);
});
