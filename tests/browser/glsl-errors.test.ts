import { afterAll, beforeAll, describe, expect, test } from '@jest/globals';
import { driverDiagnostics, uniqueDiagnostics } from '../../export/glsl/driver/driver-diagnostics.ts';
import { readIsf } from '../../export/glsl/isf/read-isf.ts';
import { linkIsf } from '../../export/glsl/link/link-isf.ts';
import type { Diagnostic } from '../../nodes/kit/diagnostics.ts';
import { openModule, type PageModule, useBrowser } from '../support/browser.ts';
import { PAGE } from './glsl-kit.ts';

const chromium = useBrowser();
let page: PageModule;
beforeAll(async () => {
  page = await openModule(chromium.browser, PAGE);
});
afterAll(() => page.close());

const HEADER =
  '/*{ "ISFVSN": "2", "INPUTS": [{ "NAME": "inputImage", "TYPE": "image" }, { "NAME": "amount", "TYPE": "float" }], "PASSES": [{ "TARGET": "half" }, {}] }*/';

/** Header, parser, linker and the real driver: everything that an author may hear about a file. */
async function diagnose(source: string): Promise<Diagnostic[]> {
  const read = readIsf(source, 'broken.fs');
  if (read.output === null) return [...read.diagnostics];
  const linked = linkIsf(read.output, { node: 'node-a1b2', loopBudget: true });
  if (linked.output === null) return [...linked.diagnostics];
  const shaders = linked.output.map((pass) => pass.shader);
  const logs = await page.call<string[]>('compile', shaders);
  return uniqueDiagnostics(shaders.flatMap((shader, i) => driverDiagnostics(shader, logs[i] ?? '', () => source)));
}

/**
 * Author's text with the expected place marked: `«` stands before the token that has to be marked. Everything is below the
 * one-line header, so the first line of the text is line 2.
 */
function marked(text: string): { source: string; line: number; column: number } {
  const before = text.slice(0, text.indexOf('«'));
  const line = before.split('\n').length + 1;
  const column = before.length - before.lastIndexOf('\n');
  return { source: `${HEADER}\n${text.replace('«', '')}`, line, column };
}

describe('what the driver refuses is shown at the quoted token', () => {
  test.each([
    ['a name that is not declared', 'void main() {\n  vec2 uv = isf_FragNormCoord;\n  gl_FragColor = vec4(uv, «color, 1.0);\n}', 'color'],
    ['a function that does not exist', 'void main() {\n  gl_FragColor = «blurr(isf_FragNormCoord);\n}', 'blurr'],
    [
      'arguments that fit no overload',
      'vec4 tint(vec4 c, float f) { return c * f; }\nvoid main() {\n  gl_FragColor = «tint(1.0, vec2(0.0));\n}',
      'tint',
    ],
    ['a type that does not fit', 'void main() {\n  float x «= vec2(1.0);\n  gl_FragColor = vec4(x);\n}', '='],
    ['operands that do not go together', 'void main() {\n  vec3 a = vec3(1.0) «+ vec2(1.0).xyy.xy;\n  gl_FragColor = a.xyzz;\n}', '+'],
    ['a component that is not there', 'void main() {\n  vec2 uv = isf_FragNormCoord;\n  gl_FragColor = uv.«xyz.xyzz;\n}', 'xyz'],
    ['a constant that is written to', 'const float PI = 3.14;\nvoid main() {\n  PI «= 3.0;\n  gl_FragColor = vec4(PI);\n}', '='],
    ['an input that is written to', 'void main() {\n  amount «= 1.0;\n  gl_FragColor = vec4(amount);\n}', '='],
    ['a variable declared twice', 'void main() {\n  float x = 1.0;\n  float «x = 2.0;\n  gl_FragColor = vec4(x);\n}', 'x'],
    ['a result of the wrong type', 'vec3 f() {\n  «return vec2(1.0);\n}\nvoid main() { gl_FragColor = f().xyzz; }', 'return'],
    [
      'a mistake in a function that is never called',
      'float unused() {\n  return 1.0 * «nowhere;\n}\nvoid main() { gl_FragColor = vec4(1.0); }',
      'nowhere',
    ],
    [
      'a mistake in the first pass alone',
      'void main() {\n  if (PASSINDEX == 0) gl_FragColor = vec4(«first);\n  else gl_FragColor = IMG_THIS_PIXEL(half);\n}',
      'first',
    ],
    [
      'the third line of a long expression',
      'void main() {\n  gl_FragColor =\n    vec4(1.0) *\n    «missing +\n    vec4(0.0);\n}',
      'missing',
    ],
    ['the second statement of a line', 'void main() { float a = 1.0; float b = a * «c; gl_FragColor = vec4(b); }', 'c'],
    ['a name that the printed text has to change', 'void main() {\n  vec2 sample = vec2(1.0);\n  gl_FragColor = vec4(sample.«z);\n}', 'z'],
    [
      'a line after comments and joined lines',
      '/* a\n b */ // c\n#define LONG 1.0 + \\\n  2.0\nvoid main() {\n  gl_FragColor = vec4(LONG) * «nothing;\n}',
      'nothing',
    ],
    ['an argument of a macro', '#define TWICE(x) ((x) * 2.0)\nvoid main() {\n  gl_FragColor = vec4(TWICE(«wrong));\n}', 'wrong'],
    ['the second of two sums', 'void main() {\n  vec3 v = vec3(1.0) + vec3(2.0) * 3.0 «+ vec2(1.0);\n  gl_FragColor = v.xyzz;\n}', '+'],
    [
      'the second call of a function',
      'float f(float x) { return x; }\nvoid main() {\n  gl_FragColor = vec4(f(1.0) + «f(vec2(1.0)) + f(2.0));\n}',
      'f',
    ],
    ['the third part of a product', 'void main() {\n  vec2 v = isf_FragNormCoord;\n  gl_FragColor = vec4(v.x * v.y * v.«z);\n}', 'z'],
    ['a variable beside a part of its name', 'void main() {\n  vec4 c = vec4(1.0);\n  gl_FragColor = c.rrrr + vec4(«rrrr);\n}', 'rrrr'],
    ['the second assignment', 'void main() {\n  float a, b;\n  a = (b «= vec2(1.0));\n  gl_FragColor = vec4(a);\n}', '='],
    ['the second of two variables', 'void main() {\n  float a = 1.0, b «= vec2(1.0);\n  gl_FragColor = vec4(a + b);\n}', '='],
    ['the inner constructor', 'void main() {\n  gl_FragColor = vec4(vec2(1.0), «vec2(1.0, 2.0, 3.0));\n}', 'vec2'],
    ['a picture that is read at one number', 'void main() {\n  gl_FragColor = vec4(1.0) * «texture2D(inputImage, 1.0);\n}', 'texture2D'],
    ['an index beyond the end', 'void main() {\n  float a[2];\n  a[0] = a[1] + a«[5];\n  gl_FragColor = vec4(a[0]);\n}', '['],
    [
      'the body of a loop',
      'void main() {\n  float s;\n  for (int i = 0; i < 3; i = i + 1) s «= vec2(1.0);\n  gl_FragColor = vec4(s);\n}',
      '=',
    ],
  ])('%s', async (_, text, quoted) => {
    const { source, line, column } = marked(text);
    const [first, ...more] = await diagnose(source);
    expect(more).toEqual([]);
    expect(first).toMatchObject({ code: 'SCR042', severity: 'error', line, column, file: 'broken.fs', nodeId: 'node-a1b2' });
    expect(first?.message).toContain(`"${quoted}"`);
    // The author never sees the linker's own names.
    expect(first?.message).not.toMatch(/\ba\d*_|scrim_|highp|symbol id|component vector/);
  });

  test('a mistake inside of a macro is shown where the macro is used', async () => {
    const { source, line, column } = marked('#define GLOW(c) (c * missing)\nvoid main() {\n  «gl_FragColor = GLOW(vec4(1.0));\n}');
    const [first] = await diagnose(source);
    expect(first).toMatchObject({ code: 'SCR042', line, column });
    expect(first?.message).toContain('"missing"');
  });

  test('line ends of Windows and old Macs count as lines', async () => {
    for (const lineEnd of ['\r\n', '\r']) {
      const { source, line, column } = marked('void main() {\n  gl_FragColor = vec4(«none);\n}');
      expect((await diagnose(source.replaceAll('\n', lineEnd)))[0]).toMatchObject({ line, column });
    }
  });

  test('a return without a value is told once, where it stands', async () => {
    const { source, line, column } = marked('float f() {\n  «return;\n}\nvoid main() { gl_FragColor = vec4(f()); }');
    expect(await diagnose(source)).toMatchObject([{ code: 'SCR042', line, column }]);
  });

  test('all mistakes of a file are told, each once', async () => {
    const diagnostics = await diagnose(
      `${HEADER}\nvoid main() {\n  float a = one;\n  float b = two;\n  gl_FragColor = vec4(a, b, 0.0, 1.0);\n}`,
    );
    expect(diagnostics.map((d) => [d.line, d.column])).toEqual([
      [3, 13],
      [4, 13],
    ]);
  });
});

describe('a syntax error is shown where it has to be fixed', () => {
  test.each([
    ['a missing semicolon', 'void main() {\n  float x = 1.0«\n  gl_FragColor = vec4(x);\n}', ';'],
    ['a missing bracket', 'void main() {\n  gl_FragColor = vec4(1.0«;\n}', ')'],
    ['a missing brace', 'void main() {\n  if (true) {\n    gl_FragColor = vec4(1.0);\n}«', '}'],
    ['a stray word', 'void main() {\n  float x = 1.0 «else;\n}', 'else'],
    ['a word of GLSL as a name', 'void main() {\n  float «for = 1.0;\n}', 'for'],
    ['an #if without an end', '#define A 1\n#«if A\nvoid main() { gl_FragColor = vec4(1.0); }', '#endif'],
    ['an unknown directive', '#«inlude "x"\nvoid main() {}', 'inlude'],
    ['a comment without an end', 'void main() {}\n  «/* never', '*/'],
    ['a quotation mark', 'void main() {\n  gl_FragColor = «“1.0”;\n}', '“'],
    ['a macro with too few arguments', '#define MIX(a, b) (a + b)\nvoid main() {\n  gl_FragColor = vec4(«MIX(1.0));\n}', 'MIX'],
    [
      'a function that calls itself',
      'float f(float n) {\n  return n < 1.0 ? 1.0 : n * «f(n - 1.0);\n}\nvoid main() { gl_FragColor = vec4(f(3.0)); }',
      'f',
    ],
    [
      'functions that call each other',
      'float g(float);\nfloat f(float n) { return g(n); }\nfloat g(float n) { return «f(n); }\nvoid main() { gl_FragColor = vec4(g(3.0)); }',
      'f',
    ],
    ['a head without a body', 'float «later(float n);\nvoid main() { gl_FragColor = vec4(later(3.0)); }', 'later'],
    ['an image that is none', 'void main() {\n  gl_FragColor = IMG_THIS_PIXEL(«amount);\n}', 'amount'],
    ['an image as a value', 'void main() {\n  gl_FragColor = «inputImage;\n}', 'inputImage'],
  ])('%s', async (_, text, quoted) => {
    const { source, line, column } = marked(text);
    const [first, ...more] = await diagnose(source);
    expect(first).toMatchObject({ code: 'SCR041', severity: 'error', line, column, file: 'broken.fs', nodeId: 'node-a1b2' });
    expect(first?.message).toContain(quoted);
    expect(more).toEqual([]);
  });

  test('what Scrim cannot give yet is said so, and nothing is drawn', async () => {
    for (const [text, word] of [
      ['attribute vec2 «left;\nvoid main() { gl_FragColor = vec4(left, 0.0, 1.0); }', 'left'],
      ['uniform sampler3D «other;\nvoid main() { gl_FragColor = vec4(1.0); }', 'other'],
      ['void main() { gl_FragColor = «textureCube(inputImage, vec3(1.0)); }', 'textureCube'],
      ['#extension «GL_EXT_nothing : require\nvoid main() { gl_FragColor = vec4(1.0); }', 'GL_EXT_nothing'],
    ] as const) {
      const { source, line, column } = marked(text);
      const diagnostics = await diagnose(source);
      expect(diagnostics).toMatchObject([{ code: 'SCR043', line, column }]);
      expect(diagnostics[0]?.message).toContain(word);
    }
  });
});
