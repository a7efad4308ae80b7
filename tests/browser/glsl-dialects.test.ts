import { describe, expect, test } from '@jest/globals';
import { useModule } from '../support/browser.ts';
import { pixelAt, type RgbaImage } from '../support/image.ts';
import { drawPicture, linkText, PAGE } from './glsl-kit.ts';

const page = useModule(PAGE);

const HEADER = '/*{ "ISFVSN": "2" }*/\n';

function render(body: string): Promise<RgbaImage> {
  return drawPicture(page, { width: 8, height: 8, passes: linkText(HEADER + body) });
}

/** What an expression of type float between 0 and 1 comes to, read from the image. */
async function evaluate(declarations: string, expression: string): Promise<number> {
  const picture = await render(`${declarations}\nvoid main() { gl_FragColor = vec4(vec3(float(${expression})), 1.0); }`);
  return pixelAt(picture, 3, 3)[0] / 255;
}

describe('older and looser GLSL runs as its author meant it', () => {
  test.each([
    ['whole numbers where floats are meant', 'float half_(float x) { return x / 2; }', 'half_(1) * 1 + 0 * 3', 0.5],
    [
      'an int variable as a float',
      'float f() { float sum = 0; for (int i = 0; i < 4; i++) { float x = i; sum += x * i; } return sum / 28; }',
      'f()',
      0.5,
    ],
    ['int division stays int division', 'float f() { float x = 3 / 2; return x / 2; }', 'f()', 0.5],
    ['built-in functions with whole numbers', '', 'max(0, min(1, pow(2, -1)))', 0.5],
    ['a comparison of int and float', 'int two = 2;', 'two > 1.5 ? 1 : 0', 1],
    ['vectors times ints', '', '(vec2(1, 3) * 2).y / 12', 0.5],
    ['a returned int', 'float f() { return 1; }', 'f() / 2', 0.5],
    ['compound assignment', 'float f() { float x = 1.0; x += 2; x /= 6; return x; }', 'f()', 0.5],
    ['a float literal with a suffix', '', '0.25f + 1f / 4.0', 0.5],
    ['a function that replaces a built-in one', 'float round(float x) { return x < 0.9 ? 0.5 : 0.0; }', 'round(0.8)', 0.5],
    ['an overload beside a built-in one', 'float mix(float a) { return a / 2.0; }', 'mix(mix(0.5, 1.5, 0.5))', 0.5],
    [
      'overloads of one name',
      'float f(float x) { return x; }\nfloat f(vec2 x) { return x.y; }\nfloat f(int x) { return 0.25; }',
      'f(0.125) + f(vec2(9.0, 0.125)) + f(2)',
      0.5,
    ],
    ['an overload chosen after a conversion', 'float f(float x) { return x; }\nfloat f(vec3 x) { return 0.1; }', 'f(1) / 2.0', 0.5],
    [
      'a variable named as a built-in function',
      'float f() { float distance = distance(vec2(0.0), vec2(0.3, 0.4)); return distance; }',
      'f()',
      0.5,
    ],
    [
      'words that became reserved',
      'struct S { float sample; };\nfloat f(float input, float filter) { S common = S(input); return common.sample + filter; }',
      'f(0.2, 0.3)',
      0.5,
    ],
    [
      'names that look like the linker’s',
      'float a_x = 0.25; float x = 0.25; float scrim_uv = 0.0; float f() { float a_x = a_x; return a_x + x; }',
      'f()',
      0.5,
    ],
    ['two underscores', 'float my__x = 0.5; float f() { float y__ = my__x; return y__; }', 'f()', 0.5],
    ['globals set from what is not constant', 'vec2 middle = RENDERSIZE * 0.5; float later = middle.x / 8.0;', 'later', 0.5],
    ['a const that is not constant', 'float f(float x) { const float twice = x * 2.0; return twice; }', 'f(0.25)', 0.5],
    ['a global const from an input’s size', 'const float third = 3.0; const float part = third / RENDERSIZE.x;', 'part * 8.0 / 6.0', 0.5],
    ['a redeclared parameter', 'float f(float x) { float x = 0.5; return x; }', 'f(1.0)', 0.5],
    [
      'a redeclared loop variable',
      'float f() { float s = 0.0; for (int i = 0; i < 2; i++) { float i = 0.25; s += i; } return s; }',
      'f()',
      0.5,
    ],
    ['a local that hides a global', 'float x = 0.1; float f() { float x = x + 0.4; { float x = 9.0; } return x; }', 'f()', 0.5],
    [
      'a struct with a constructor and a member function-like name',
      'struct Ray { vec3 o; float length; };\nfloat f() { Ray r = Ray(vec3(1), 0.5); return r.length; }',
      'f()',
      0.5,
    ],
    [
      'arrays',
      'const float k[3] = float[3](0.0, 0.5, 1);\nfloat f() { float w[2]; w[0] = k[1]; w[1] = 0; return w[0] + w[1]; }',
      'f()',
      0.5,
    ],
    [
      'an array of its own length, set from what is not constant',
      'float w[] = float[](0.1, RENDERSIZE.x / 16.0);\nfloat[] v = float[](w[0], w[1]);',
      'v[v.length() - 1]',
      0.5,
    ],
    [
      'out parameters',
      'void f(in float a, out float b, inout float c) { b = a; c += a; }\nfloat g() { float b; float c = 0.1; f(0.2, b, c); return b + c; }',
      'g()',
      0.5,
    ],
    ['a prototype', 'float f(float);\nfloat g() { return f(0.25); }\nfloat f(float x) { return x * 2.0; }', 'g()', 0.5],
    ['matrices', '', '(mat2(0.5, 0, 0, 1) * vec2(1, 0)).x', 0.5],
    [
      'switch, do and comma',
      'float f(int n) { float x = 0.0; int i = 0; do { i++, x += 0.25; } while (i < 2); switch (n) { case 1: return x; default: return 0.0; } }',
      'f(1)',
      0.5,
    ],
    ['a uniform with a value', 'uniform float level = 0.5;', 'level', 0.5],
    [
      'precision and version lines',
      '#version 120\n#ifdef GL_ES\nprecision mediump float;\n#endif\nlowp float f(mediump float x) { highp float y = x; return y; }',
      'f(0.5)',
      0.5,
    ],
    [
      'function-like macros over several lines',
      '#define LERP(a, b, t) \\\n  ((a) * (1.0 - (t)) + \\\n  (b) * (t))\n#define TWICE(x) LERP(0.0, x, 2.0)',
      'TWICE(\n0.25\n)',
      0.5,
    ],
    [
      'conditions',
      '#define QUALITY 2\n#if QUALITY > 1 && defined(GL_ES) && !defined(NOTHING)\n#define V 0.5\n#elif 1\n#error never\n#else\n#define V 0.1\n#endif',
      'V',
      0.5,
    ],
    ['a list in braces, for an array', 'float k[3] = {0, 0.5, 1.0,};\nvec2 v = {1, 2};', 'k[1] * v.x', 0.5],
    ['a list of lists', 'vec2 p[] = {vec2(1), {0.5, 2}};', 'p[1].x', 0.5],
    [
      'a float loop over whole numbers',
      'float f() { float s = 0; for (float i = 0; i < 3; i++) { s += i; i += 1; } return s / 4; }',
      'f()',
      0.5,
    ],
    [
      'functions of their own for what ES 3.00 brought',
      'mat2 inverse(mat2 m) { return m; } float tanh(float x) { return x; } vec3 tanh(vec3 v) { return vec3(tanh(v.x), tanh(v.y), tanh(v.z)); } int round(float x) { return int(floor(x + 0.5)); } float mod(int a, int b) { return float(a - a / b * b); }',
      'tanh(tanh(vec3(0.25))).x + (inverse(mat2(1)) * vec2(0.25)).x + mod(4, 2) + round(0.2)',
      0.5,
    ],
    [
      'switch, fall-through and no value at first',
      'float f(int n) { float r; switch (n) { case 0: case 1: r = 0.5; break; default: r = 2; } return r; }',
      'f(1)',
      0.5,
    ],
    ['whole-number operators', 'int f(int n) { return ((n << 2) | 1) & 0x7 ^ ~n >> 1; }', 'float(f(1) + 7) / 4 * (5 % 3)', 0.5],
    ['a position of whole numbers', 'vec2 f(ivec2 at) { vec2 p = at; p += ivec2(1); p.x = 1; return p / 2; }', 'f(ivec2(3, 4)).x', 0.5],
    [
      'an extension and a version of desktop GLSL',
      '#version 120\n#extension GL_EXT_gpu_shader4 : require\n#extension GL_ARB_gpu_shader5 : enable\n#pragma optimize(on)',
      '0.5',
      0.5,
    ],
    [
      'macros for Shadertoy names',
      '#define iResolution vec3(RENDERSIZE, 1)\n#define sat(x) clamp(x, 0, 1)',
      'sat(iResolution.x / 16)',
      0.5,
    ],
    ['an array that a function gives', 'float[2] f() { float r[2]; r[1] = 0.5; return r; }', 'f()[1]', 0.5],
    ['a macro that is taken back', '#define V 0.5\nfloat a = V;\n#undef V\nfloat V = 0.0;', 'a + V', 0.5],
  ])('%s', async (_, declarations, expression, wanted) => {
    expect(await evaluate(declarations, expression)).toBeCloseTo(wanted, 2);
  });

  test('an output of its own name, as in ES 3.00', async () => {
    const picture = await render(
      `#version 300 es\nlayout(location = 0) out vec4 color;\nvoid main() { color = vec4(0.0, 1.0, 0.0, 1.0); }`,
    );
    expect(pixelAt(picture, 0, 0)).toEqual([0, 255, 0, 255]);
  });

  test('gl_FragData, and reading back what was written', async () => {
    const picture = await render(`void main() { gl_FragData[0] = vec4(1.0); gl_FragColor.rg *= 0.0; }`);
    expect(pixelAt(picture, 0, 0)).toEqual([0, 0, 255, 255]);
  });
});
