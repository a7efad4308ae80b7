import { readdirSync, readFileSync } from 'node:fs';
import { join } from 'node:path';
import { describe, expect, test } from '@jest/globals';
import fc from 'fast-check';
import { checkIsf } from '../isf/checked-isf.ts';
import { readIsf } from '../isf/read-isf.ts';
import type { Expression, Statement } from '../syntax/ast.ts';
import { lex } from '../syntax/lexer.ts';
import type { Place } from '../syntax/token.ts';
import { walkExpression, walkStatement } from '../syntax/walk-tree.ts';
import { completionsAt } from './complete.ts';
import { formatShader } from './format-shader.ts';
import { colorsOf, numberAt, printColor, printLiteral, stepOf } from './literals.ts';
import { definitionsAt, hoverAt, referencesAt, signatureAt } from './look-up.ts';
import { renameAt, renameStart } from './rename.ts';
import { readShaderDocument } from './shader-document.ts';
import { applyEdits, offsetOf, placeOf } from './source-text.ts';

const LIBRARY = join(import.meta.dirname, '../../../shader-library');

function libraryFiles(): (readonly [name: string, text: string])[] {
  return readdirSync(LIBRARY, { recursive: true, encoding: 'utf8' })
    .filter((name) => /\.(fs|vs|glsl)$/.test(name))
    .sort()
    .map((name) => [name, readFileSync(join(LIBRARY, name), 'utf8')]);
}

const chunkOf = (name: string) =>
  name === 'light/strength' ? readFileSync(join(LIBRARY, 'chunks/light/strength.glsl'), 'utf8') : undefined;

const HEADER = `/*{
  "ISFVSN": "2",
  "INPUTS": [
    { "NAME": "inputImage", "TYPE": "image" },
    { "NAME": "amount", "TYPE": "float", "LABEL": "Amount", "DOC": "How much of it.", "MIN": 0, "MAX": 2, "DEFAULT": 0.5 },
    { "NAME": "tone", "TYPE": "color", "DEFAULT": [1, 0.5, 0.25, 1] }
  ],
  "PASSES": [ { "TARGET": "small", "WIDTH": "floor($WIDTH * $amount)" }, { } ]
}*/
`;

/** The text with its first `|` taken out, and where it stood. */
function at(text: string, header = HEADER, file = 'shaders/a.fs') {
  const marked = header + text;
  const offset = marked.indexOf('|');
  const source = offset < 0 ? marked : marked.slice(0, offset) + marked.slice(offset + 1);
  const place: Place = placeOf(source, Math.max(offset, 0));
  return { source, place, document: readShaderDocument(source, file, { chunkOf }) };
}

function labels(text: string, ...more: [header?: string, file?: string]): string[] {
  const { document, place } = at(text, ...more);
  return completionsAt(document, place).map(({ label }) => label);
}

function renamed(text: string, to: string, ...more: [header?: string, file?: string]): string {
  const { document, place, source } = at(text, ...more);
  const result = renameAt(document, place, to, { chunkOf });
  return result.ok ? applyEdits(source, result.edits) : result.reason;
}

describe('what names mean', () => {
  test.each(libraryFiles().filter(([name]) => name.endsWith('.fs')))('is in %s what the parser says', (name, source) => {
    const shader = readIsf(source, name).output;
    if (shader === null) throw new Error(`${name} cannot be read.`);
    const { outline } = readShaderDocument(source, name, { chunkOf });
    const at = new Map(outline.tokens.map((token) => [`${token.line}:${token.column}`, token]));
    const macros = new Set(
      outline.names.filter(({ kind }) => kind === 'macro').flatMap(({ uses }) => uses.map((use) => `${use.line}:${use.column}`)),
    );
    const compare = (used: { line: number; column: number }, declared: Place | null) => {
      const key = `${used.line}:${used.column}`;
      const token = at.get(key);
      // What a macro brought stands where the macro was used.
      if (token === undefined || macros.has(key)) return 0;
      const first = outline.nameAt(token)?.declarations[0];
      expect([key, declared && `${declared.line}:${declared.column}`]).toEqual([
        key,
        first && outline.names.some((n) => n.declarations.includes(first)) ? `${first.line}:${first.column}` : null,
      ]);
      return 1;
    };
    let compared = 0;
    const expression = (found: Expression) => {
      if (found.kind === 'name' && found.symbol) compared += compare(found.token, found.symbol.token);
      if (found.kind === 'call' && found.symbol?.kind === 'function') {
        const meant = outline.nameAt(at.get(`${found.token.line}:${found.token.column}`) ?? found.token);
        expect(meant?.declarations.map(({ line }) => line)).toContain(found.symbol.declaration.name.line);
      }
      return undefined;
    };
    const walk = { expression };
    for (const declaration of checkIsf(shader).checked.declarations) {
      if (declaration.kind === 'function') {
        if (declaration.body !== null) walkStatement(declaration.body as Statement, walk);
      } else for (const { initializer } of declaration.declarators) if (initializer !== null) walkExpression(initializer, walk);
    }
    expect(compared).toBeGreaterThan(0);
  });

  test('an inner name hides an outer one until its block ends, and not in its own initializer', () => {
    const text = 'void main() { float a = 1.0; { float a = |a + 1.0; a; } a; }';
    const { document, place, source } = at(text);
    expect(referencesAt(document, place).map(({ start }) => start.column)).toHaveLength(3);
    const [declared] = definitionsAt(document, place);
    expect(declared && offsetOf(source, declared.range.start)).toBe(source.indexOf('a = 1.0'));
  });

  test('a loop variable ends with its loop, with braces or without', () => {
    expect(renamed('int i; void main() { for (int |i = 0; i < 3; i++) if (i > 1) i; else i; i; for (int i = 0;;) { i; } }', 'k')).toContain(
      'for (int k = 0; k < 3; k++) if (k > 1) k; else k; i; for (int i = 0;;) { i; } }',
    );
  });

  test('both sides of an #if, and macros, belong to it', () => {
    const text =
      '#ifdef A\nfloat f(float x) {\n#else\nfloat f(vec2 x) {\n#endif\n return 1.0; }\n#define G |f(2.0)\nvoid main() { f(1.0); G; }';
    const result = renamed(text, 'shade');
    expect(result.match(/shade/g)).toHaveLength(4);
  });
});

describe('completion', () => {
  test('offers what is in scope, inputs, functions and words; not what is declared below', () => {
    const found = labels(
      'struct Ray { vec3 from; };\n#define SIZE 3\nfloat soft(float x) { float y = x; | float later; }\nvoid below() {}',
    );
    expect(found).toEqual(
      expect.arrayContaining(['x', 'y', 'soft', 'Ray', 'SIZE', 'amount', 'inputImage', 'small', 'TIME', 'mix', 'IMG_PIXEL', 'vec3', 'for']),
    );
    expect(found).not.toContain('later');
    expect(found).not.toContain('below');
    expect(new Set(found).size).toBe(found.length);
  });

  test('after a dot, the members of a struct or the parts of a vector', () => {
    const struct = 'struct Ray { vec3 from; float far; };\n';
    expect(labels(`${struct}void main() { Ray r; r.| }`)).toEqual(['from', 'far']);
    expect(labels(`${struct}void main() { Ray r; r.from.x| }`)).toEqual(expect.arrayContaining(['x', 'xyz', 'rgb']));
    expect(labels('void main() { vec2 p; p.| }')).not.toContain('z');
    expect(labels('void main() { IMG_THIS_PIXEL(inputImage).|')).toContain('rgba');
    expect(labels('void main() { normalize(tone).|')).toContain('a');
    expect(labels('void main() { 1.|')).toEqual([]);
  });

  test('a broken header keeps its inputs; a comment has no completions', () => {
    const whole = at('void main() { | }');
    const broken = whole.source.replace('"INPUTS": [', '"INPUTS": [[');
    const document = readShaderDocument(broken, 'shaders/a.fs', { chunkOf, before: whole.document });
    expect(completionsAt(document, placeOf(broken, broken.length - 3)).map(({ label }) => label)).toContain('amount');
    expect(labels('// am|\nvoid main() {}')).toEqual([]);
  });

  test('techniques know their interface and what chunks bring', () => {
    const header = '/*{ "INPUTS": [ { "NAME": "warm", "TYPE": "color" } ] }*/\n';
    const text = '#include <light/strength>\nvec4 surface(const in Surface s) { Light l = LIGHT(0); l.| }';
    expect(labels(text, header, 'a.glsl')).toEqual(['towards', 'radiance', 'lit']);
    const { document, place } = at('#include <light/strength>\nvoid x() { light|Strength(LIGHT(0)); }', header, 'a.glsl');
    expect(definitionsAt(document, place)).toEqual([
      { file: 'chunks/light/strength.glsl', range: { start: { line: 4, column: 7 }, end: { line: 4, column: 20 } } },
    ]);
    expect(hoverAt(document, place)).toMatchObject({
      code: 'float lightStrength(const in Light light)',
      doc: expect.stringContaining('luminance'),
    });
    expect(renameStart(document, place)).toMatchObject({ ok: false, reason: expect.stringContaining('other techniques') });
    expect(labels('void x() { | }', header, 'a.glsl')).toEqual(expect.arrayContaining(['Surface', 'EYE', 'warm']));
  });

  test('in the header, keys and values by where they stand', () => {
    const header = (inside: string) => `/*{ ${inside} }*/ void main() {}`;
    expect(labels('', header('|'))).toEqual(expect.arrayContaining(['INPUTS', 'CREDIT']));
    expect(labels('', header('"INPUTS": [ { "|" } ]'))).toEqual(expect.arrayContaining(['NAME', 'MAX']));
    expect(labels('', header('"INPUTS": [ { "TYPE": "|" } ]'))).toEqual(expect.arrayContaining(['point2D', 'color']));
  });
});

describe('hover and signatures', () => {
  test.each([
    [
      'gl_FragColor = |mix(a, b, 0.5);',
      { code: expect.stringContaining('T mix(T a, T b, float share)'), doc: expect.stringContaining('Blends') },
    ],
    ['amo|unt;', { code: 'uniform float amount', doc: '**Amount** · float · 0 to 2 · starts at 0.5\n\nHow much of it.' }],
    ['// Warms it.\nfloat war|m(float x) { }', { code: 'float warm(float x)', doc: 'Warms it.' }],
    ['#define TAU 6.28\nT|AU', { code: '#define TAU 6.28' }],
    ['T|IME', { code: 'float TIME', doc: 'Seconds since the first frame.' }],
    ['struct Ray { vec3 from; }; void main() { Ray r; r.fr|om; }', { code: 'vec3 Ray.from' }],
  ])('%s', (text, expected) => {
    const { document, place } = at(text);
    expect(hoverAt(document, place)).toMatchObject(expected);
  });

  test('the argument that is being written, in the overload that has it', () => {
    const help = (text: string) => {
      const { document, place } = at(text);
      const found = signatureAt(document, place);
      return found && [found.signatures[found.active]?.label, found.signatures[found.active]?.parameters[found.parameter]];
    };
    expect(help('void main() { mix(vec3(0.0, 1.0, 2.0), b, |')).toEqual(['T mix(T a, T b, T share)', 'T share']);
    expect(help('void main() { mix(vec3(0.0, |')).toBeNull();
    expect(help('float f(float a) {}\nfloat f(float a, vec2 b) {}\nvoid main() { f(g[1], |')).toEqual([
      'float f(float a, vec2 b)',
      'vec2 b',
    ]);
    expect(help('#define F(a, b) (a + b)\nvoid main() { F(1, |')).toEqual(['F(a, b)', 'b']);
    expect(help('void main() { a; |')).toBeNull();
  });
});

describe('renaming', () => {
  test('an input is renamed in the header, in sizes and in the code', () => {
    const result = renamed('void main() { gl_FragColor = |amount * tone; { float amount = 1.0; amount; } }', 'strength');
    expect(result).toContain('"NAME": "strength"');
    expect(result).toContain('$strength');
    expect(result).toContain('gl_FragColor = strength * tone; { float amount = 1.0; amount; }');
    const fromHeader = HEADER.replace('"amount"', '"amo|unt"');
    expect(renamed('void main() { amount; }', 'strength', fromHeader)).toContain('{ strength; }');
  });

  test.each([
    ['void main() { float |a; float b; a; b; }', 'b', /conflicts|already/],
    ['float b; void main() { float |a; b; a; }', 'b', /conflicts/],
    ['float |a; void main() { float b; a; b; }', 'b', /conflicts/],
    ['float |a; float b; void main() { }', 'b', /already/],
    ['float |a; void main() { }', 'while', /GLSL keyword/],
    ['float |a; void main() { }', 'mix', /function of GLSL/],
    ['void main() { T|IME; }', 'now', /is predefined/],
    ['void |main() { }', 'start', /fixed/],
  ])('%s to %s is refused', (text, to, reason) => {
    expect(renamed(text, to)).toMatch(reason);
  });

  test('hiding an outer name that nobody needs there is fine', () => {
    expect(renamed('float b; float f() { return b; } void main() { float |a = 1.0; a; }', 'b')).toContain('{ float b = 1.0; b; }');
  });
});

describe('formatting', () => {
  const words = (text: string) => lex(text).map((token) => token.text);
  const comments = (text: string) => [...text.matchAll(/\/\/[^\n]*|\/\*[\s\S]*?\*\//g)].map(([comment]) => comment.trimEnd());

  test('indents, spaces and leaves the rest', () => {
    const before =
      '/*{ "a" :1 }*/\n\n\n\n#define F( x )  x\nvoid main( ){\nfloat a=-1.0*- -b ;  // why\nif(a>0.0)\nb ++;\nfor(int i=0;i<3;i++){ c[ i ]=i?1:2; }\nx = f(a,\nb);\nswitch(a){\ncase 1 :\nbreak;\n}\n}\n';
    expect(formatShader(before)).toBe(
      '/*{ "a" :1 }*/\n\n#define F( x )  x\nvoid main() {\n  float a = -1.0 * - -b; // why\n  if (a > 0.0)\n    b++;\n  for (int i = 0; i < 3; i++) { c[i] = i ? 1 : 2; }\n  x = f(a,\n    b);\n  switch (a) {\n    case 1:\n    break;\n  }\n}\n',
    );
  });

  test.each(libraryFiles())('leaves %s as it is, but for what belongs elsewhere', (_, source) => {
    const formatted = formatShader(source) ?? '';
    expect(words(formatted)).toEqual(words(source));
    expect(comments(formatted)).toEqual(comments(source));
    expect(formatShader(formatted)).toBe(formatted);
  });

  test('never changes a token or a comment, and does nothing the second time', () => {
    const piece = fc.constantFrom(
      ...[
        'a',
        'b2',
        '1',
        '1.',
        '.5',
        '2.0e-3',
        '0x1F',
        '3u',
        '+',
        '-',
        '--',
        '++',
        '!',
        '~',
        '*',
        '/',
        '(',
        ')',
        '[',
        ']',
        '{',
        '}',
        ';',
        ',',
        '?',
        ':',
        '=',
      ],
      ...[
        '==',
        '<=',
        '<<',
        '&&',
        '.',
        'if',
        'for',
        'return',
        'else',
        'case',
        'vec3',
        '// note\n',
        '/* a\n  b */',
        '\n',
        '\n\n\n',
        ' ',
        '\t',
        '\\\n',
        '\n#define F(x) x\n',
        '\n  # if A \\\n  B // c\n',
      ],
    );
    fc.assert(
      fc.property(fc.array(fc.tuple(piece, fc.constantFrom('', ' ')), { maxLength: 60 }), (pieces) => {
        const source = pieces.map(([text, gap]) => text + gap).join('');
        const formatted = formatShader(source);
        // A comment that never ends, as "/" and "*" may make one.
        if (formatted === null) return;
        expect(words(formatted)).toEqual(words(source));
        expect(formatShader(formatted)).toBe(formatted);
      }),
      { numRuns: 1500 },
    );
  });
});

describe('literals', () => {
  test('colors are found in the code and the header, and printed in their own form', () => {
    const source = `${HEADER}vec3 a = vec3(0.2, 1, .5); vec4 b = vec4(0.0, 0.0, 0.0, 0.5); vec3 c = vec3(0.5); vec3 d = vec3(2.0, 0, 0), e = vec3(x, 0, 0);`;
    const found = colorsOf(source);
    expect(found.map(({ color }) => color)).toEqual([
      [1, 0.5, 0.25, 1],
      [0.2, 1, 0.5, 1],
      [0, 0, 0, 0.5],
      [0.5, 0.5, 0.5, 1],
    ]);
    const [list, call] = found;
    if (!list || !call) throw new Error('No colors.');
    expect(printColor(list, [0, 0.25, 1, 1])).toBe('[0.0, 0.25, 1.0, 1.0]');
    expect(printColor(call, [0, 0.1234, 1, 1])).toBe('vec3(0.0, 0.123, 1.0)');
  });

  test.each([
    ['x = 0|.50;', { value: 0.5, isInt: false }, 0.01, '0.73', 0.73],
    ['x = -2.0|;', { value: -2, isInt: false }, 0.01, '-1.90', -1.9],
    ['x = a -2.0|;', { value: 2, isInt: false }, 0.01, '1.90', 1.9],
    ['return -|3;', { value: -3, isInt: true }, 1, '-4', -4.2],
    ['x = 250.|0;', { value: 250, isInt: false }, 1, '251.0', 251],
  ])('%s', (text, expected, step, printed, value) => {
    const { source, place } = at(text, '');
    const found = numberAt(source, place);
    expect(found).toMatchObject(expected);
    if (!found) return;
    expect(stepOf(found)).toBeCloseTo(step);
    expect(printLiteral(found, value, step)).toBe(printed);
  });
});
