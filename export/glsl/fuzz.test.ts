import { readFileSync } from 'node:fs';
import { describe, expect, test } from '@jest/globals';
import fc from 'fast-check';
import { isfDefinition } from './isf/isf-definition.ts';
import { readIsf } from './isf/read-isf.ts';
import { linkIsf } from './link/link-isf.ts';

/** Fixed, so that a run repeats; a failure prints the smallest text that shows it. */
const SEED = 20260304;

const library = ['filters/gaussian-blur.fs', 'filters/color-temperature.fs', 'operators/mask.fs'].map((file) =>
  readFileSync(new URL(`../../shader-library/${file}`, import.meta.url), 'utf8'),
);

/** Anything at all gives a result or diagnostics with places in the text, in a time that grows with its length. */
function survives(source: string): void {
  const lines = source.split(/\r\n|\r|\n/).length;
  const read = readIsf(source, 'fuzz.fs');
  const found = [...read.diagnostics];
  if (read.output !== null) {
    isfDefinition(read.output, 'fuzz');
    const linked = linkIsf(read.output, { node: 'n', loopBudget: true });
    found.push(...linked.diagnostics);
    for (const pass of linked.output ?? []) {
      const printed = pass.shader.fragment.split('\n').length - 1;
      expect(pass.shader.sourceMap?.lines).toHaveLength(printed);
    }
    if (linked.output === null) expect(linked.diagnostics).not.toEqual([]);
  } else {
    expect(read.diagnostics).not.toEqual([]);
  }
  for (const { line, column, message } of found) {
    expect(line).toBeGreaterThanOrEqual(1);
    expect(line).toBeLessThanOrEqual(lines);
    expect(column).toBeGreaterThanOrEqual(1);
    expect(message).not.toBe('');
  }
}

const PIECES = (
  '{ } ( ) [ ] ; , . = + - * / % < > == != && || ! ? : ++ -- += # ## \n \n \n " // /* */ 0 1 2.5 .5 1e9 0x1F 1u true float vec2 vec4 mat3 int bool void struct const ' +
  'uniform varying in out inout if else for while do switch case default return break continue discard precision highp main f x y uv S r xyz ' +
  'gl_FragColor gl_FragCoord isf_FragNormCoord RENDERSIZE TIME PASSINDEX IMG_PIXEL IMG_NORM_PIXEL IMG_SIZE inputImage amount buf LAYER_DEPTH texture2D texture sampler2D ' +
  '#define #if #ifdef #else #elif #endif #undef defined A F(x) __LINE__ layout sin mix max length'
).split(' ');

const HEADER =
  '/*{"ISFVSN":"2","INPUTS":[{"NAME":"inputImage","TYPE":"image"},{"NAME":"amount","TYPE":"float"}],"PASSES":[{"TARGET":"buf"},{}]}*/\n';

describe('whatever is written', () => {
  test('any text', () => {
    fc.assert(fc.property(fc.string({ unit: 'binary', maxLength: 200 }), survives), { seed: SEED, numRuns: 150 });
  });

  test('any value as a header', () => {
    fc.assert(
      fc.property(fc.json({ maxDepth: 4 }), (json) => survives(`/*${json.replaceAll('*/', '')}*/ void main() {}`)),
      { seed: SEED, numRuns: 300 },
    );
  });

  test('any value under any key', () => {
    const keys = fc.constantFrom(
      'INPUTS',
      'PASSES',
      'IMPORTED',
      'PERSISTENT_BUFFERS',
      'CATEGORIES',
      'SCRIM_UNITS',
      'SCRIM_DEPTH',
      'ISFVSN',
      'DESCRIPTION',
    );
    const inner = fc.dictionary(
      fc.constantFrom('NAME', 'TYPE', 'DEFAULT', 'MIN', 'MAX', 'VALUES', 'LABELS', 'TARGET', 'WIDTH', 'PERSISTENT', 'PATH', 'UNIT'),
      fc.jsonValue({ maxDepth: 2 }),
    );
    const value = fc.oneof(fc.array(inner, { maxLength: 4 }), inner, fc.jsonValue({ maxDepth: 2 }));
    fc.assert(
      fc.property(fc.dictionary(keys, value), (header) => survives(`/*${JSON.stringify(header).replaceAll('*/', '')}*/ void main() {}`)),
      { seed: SEED, numRuns: 500 },
    );
  });

  test('any row of words of the language', () => {
    const body = fc.array(fc.constantFrom(...PIECES), { maxLength: 60 }).map((pieces) => pieces.join(' '));
    fc.assert(
      fc.property(body, fc.boolean(), (text, inMain) =>
        survives(HEADER + (inMain ? `void main() { ${text} }` : `${text}\nvoid main() {}`)),
      ),
      { seed: SEED, numRuns: 800 },
    );
  });

  test('a real shader with a piece cut out or put in', () => {
    const change = fc.record({
      source: fc.constantFrom(...library),
      at: fc.double({ min: 0, max: 1, noNaN: true }),
      cut: fc.nat({ max: 40 }),
      put: fc.oneof(fc.constantFrom(...PIECES, ''), fc.string({ maxLength: 4 })),
    });
    fc.assert(
      fc.property(change, ({ source, at, cut, put }) => {
        const offset = Math.floor(at * source.length);
        survives(source.slice(0, offset) + put + source.slice(offset + cut));
      }),
      { seed: SEED, numRuns: 300 },
    );
  });

  test.each([
    ['brackets', `void main() { float x = ${'('.repeat(20_000)}1.0${')'.repeat(20_000)}; }`],
    ['blocks', `void main() { ${'{'.repeat(20_000)} ${'}'.repeat(20_000)} }`],
    ['signs', `void main() { float x = ${'-'.repeat(20_000)}1.0; }`],
    ['a sum', `void main() { float x = 1.0${' + 1.0'.repeat(20_000)}; }`],
    ['sums in sums', `void main() { float x = ${'('.repeat(200)}1.0${`${' + 1.0'.repeat(900)})`.repeat(200)}; }`],
    ['members', `void main() { vec2 x${'.xy'.repeat(20_000)}; vec2 y = x${'.xy'.repeat(20_000)}; }`],
    ['choices', `void main() { float x = ${'true ? 1.0 : '.repeat(20_000)}1.0; }`],
    ['else if', `void main() { ${'if (true) {} else '.repeat(20_000)} {} }`],
    ['conditions', `#if ${'('.repeat(20_000)}1${')'.repeat(20_000)}\n#endif\nvoid main() {}`],
    ['indices', `void main() { float x = a${'[a'.repeat(20_000)}${']'.repeat(20_000)}; }`],
    ['macros that double', `${Array.from({ length: 60 }, (_, i) => `#define M${i + 1} M${i} M${i}`).join('\n')}\nvoid main() { M60 }`],
    ['macros inside of macros', `#define F(x) x\nvoid main() { ${'F('.repeat(5000)}1${')'.repeat(5000)}; }`],
    ['macros with growing arguments', `#define F(x) x x\nvoid main() { ${'F('.repeat(60)}1${')'.repeat(60)}; }`],
    ['macros that mean each other', '#define A B\n#define B A\nvoid main() { float A = 1.0; gl_FragColor = vec4(B); }'],
    ['functions that call each other', 'float f(float x) { return f(x) + f(x); }\nvoid main() { gl_FragColor = vec4(f(1.0)); }'],
    ['functions that hand images on for ever', 'vec4 f(sampler2D i) { return f(i); }\nvoid main() { gl_FragColor = f(inputImage); }'],
    [
      'functions that swap images for ever',
      'vec4 f(sampler2D a, sampler2D b, sampler2D c, sampler2D d) { return f(b, a, c, d) + f(b, c, d, a); }\nvoid main() { gl_FragColor = f(inputImage, buf, inputImage, buf); }',
    ],
    [
      'positions handed on',
      `${Array.from({ length: 60 }, (_, i) => `vec4 f${i}(vec2 p) { return ${i === 0 ? 'IMG_NORM_PIXEL(inputImage, p)' : `f${i - 1}(p) + f${i - 1}(p)`}; }`).join('\n')}\nvoid main() { gl_FragColor = f59(isf_FragNormCoord); }`,
    ],
    [
      'calls of calls',
      `float f0(float x) { return x; }\n${Array.from({ length: 5000 }, (_, i) => `float f${i + 1}(float x) { return f${i}(x); }`).join('\n')}\nvoid main() { gl_FragColor = vec4(f5000(1.0)); }`,
    ],
    [
      'constants of constants',
      `const int c0 = 1;\n${Array.from({ length: 5000 }, (_, i) => `const int c${i + 1} = c${i};`).join('\n')}\nvoid main() { for (int i = 0; i < c5000; i++) gl_FragColor += 0.1; }`,
    ],
    [
      'positions of positions',
      `void main() { vec2 p0 = isf_FragNormCoord;\n${Array.from({ length: 5000 }, (_, i) => `vec2 p${i + 1} = p${i};`).join('\n')}\ngl_FragColor = IMG_NORM_PIXEL(inputImage, p5000); }`,
    ],
    [
      'structs of structs',
      `struct S0 { float x; };\n${Array.from({ length: 40 }, (_, i) => `struct S${i + 1} { S${i} a, b; };`).join('\n')}\nS40 f() { discard; S40 s; return s; }\nvoid main() { f(); }`,
    ],
    ['variables made of each other', 'float a = b;\nfloat b = a;\nvoid main() { gl_FragColor = IMG_NORM_PIXEL(inputImage, vec2(a, b)); }'],
  ])('%s without measure', (_, body) => {
    survives(HEADER + body);
  });

  test.each([
    ['brackets', '['.repeat(100_000)],
    ['brackets behind quotes', '["]"'.repeat(50_000)],
    ['objects', '{"INPUTS":'.repeat(50_000)],
    ['a size', `{"PASSES":[{"TARGET":"a","WIDTH":"${'('.repeat(100_000)}1"}]}`],
    ['a number', `{"PASSES":[{"TARGET":"a","WIDTH":1e999}],"INPUTS":[{"NAME":"a","TYPE":"float","MIN":-1e999,"DEFAULT":1e999}]}`],
    ['passes', `{"PASSES":[${'{},'.repeat(10_000)}{}]}`],
  ])('a header with %s without measure', (_, json) => {
    survives(`/*${json}*/ void main() {}`);
  });
});
