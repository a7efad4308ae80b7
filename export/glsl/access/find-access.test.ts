import { describe, expect, test } from '@jest/globals';
import { checkIsf } from '../isf/checked-isf.ts';
import type { IsfShader } from '../isf/isf-shader.ts';
import { readIsf } from '../isf/read-isf.ts';
import { findAccess, type ImageReads, imageReads } from './find-access.ts';

function shaderOf(body: string, header: Readonly<Record<string, unknown>> = {}): IsfShader {
  const inputs = [
    { NAME: 'inputImage', TYPE: 'image' },
    { NAME: 'other', TYPE: 'image' },
    { NAME: 'room', TYPE: 'depth' },
    { NAME: 'shift', TYPE: 'point2D' },
    { NAME: 'tone', TYPE: 'curve' },
    { NAME: 'count', TYPE: 'long', VALUES: [0, 1], DEFAULT: 0 },
    { NAME: 'size', TYPE: 'float', DEFAULT: 1 },
  ];
  const { output } = readIsf(`/*${JSON.stringify({ INPUTS: inputs, ...header })}*/\n${body}`, 'test.fs');
  if (output === null) throw new Error('The header is broken.');
  return output;
}

function accessOf(body: string, header: Readonly<Record<string, unknown>> = {}): string {
  return findAccess(shaderOf(body, header));
}

/** Reads of `inputImage`. */
function readsOf(body: string): ImageReads | undefined {
  return imageReads(checkIsf(shaderOf(body)).checked, 0)?.get('inputImage');
}

const HERE = 'IMG_THIS_PIXEL(inputImage)';

describe('pointwise', () => {
  test.each([
    ['this pixel', `void main() { gl_FragColor = ${HERE}; }`],
    ['this pixel, read often', `void main() { for (int i = 0; i < 9; i++) gl_FragColor += ${HERE} * IMG_THIS_NORM_PIXEL(other); }`],
    ['the position of ISF', 'void main() { gl_FragColor = IMG_NORM_PIXEL(inputImage, isf_FragNormCoord.xy); }'],
    ['the position of GLSL', 'void main() { gl_FragColor = texture2D(inputImage, gl_FragCoord.xy / RENDERSIZE.xy); }'],
    ['the position in pixels', 'void main() { gl_FragColor = IMG_PIXEL(inputImage, gl_FragCoord.xy); }'],
    [
      'the position by way of variables',
      'vec2 p = gl_FragCoord.xy / RENDERSIZE; void main() { vec2 uv = (p); gl_FragColor = IMG_NORM_PIXEL(inputImage, uv); }',
    ],
    [
      'the position by way of functions',
      'vec4 at(vec2 p) { return IMG_NORM_PIXEL(inputImage, p); } void main() { gl_FragColor = at(isf_FragNormCoord) + at(isf_FragNormCoord); }',
    ],
    ['scaled to pixels', 'void main() { gl_FragColor = IMG_PIXEL(inputImage, IMG_SIZE(inputImage) * isf_FragNormCoord); }'],
    [
      'depth here',
      'void main() { gl_FragColor = vec4(LAYER_DEPTH(inputImage, isf_FragNormCoord) - ROOM_DEPTH(room, isf_FragNormCoord)); }',
    ],
    ['nothing at all', 'void main() { gl_FragColor = vec4(1.0); }'],
    ['curves, wherever', `void main() { gl_FragColor = ${HERE} * CURVE(tone, shift.x) * CURVE(tone, 0.5); }`],
    ['a size', 'void main() { gl_FragColor = vec4(IMG_SIZE(inputImage), 0.0, 1.0); }'],
  ])('%s', (_, body) => {
    expect(accessOf(body)).toBe('pointwise');
  });
});

describe('displaced', () => {
  test.each([
    ['one other pixel', 'void main() { gl_FragColor = IMG_NORM_PIXEL(inputImage, isf_FragNormCoord + shift); }'],
    ['the size of a texture', 'void main() { gl_FragColor = vec4(IMG_SAMPLES(inputImage), 0.0, 1.0); }'],
    [
      'one of each image',
      'void main() { gl_FragColor = IMG_NORM_PIXEL(inputImage, isf_FragNormCoord.yx) + IMG_NORM_PIXEL(other, shift); }',
    ],
    [
      'a variable that is changed',
      'void main() { vec2 uv = isf_FragNormCoord; uv.x += 0.1; gl_FragColor = IMG_NORM_PIXEL(inputImage, uv); }',
    ],
    [
      'a variable that a function may change',
      'void warp(inout vec2 p) { p *= 2.0; } void main() { vec2 uv = isf_FragNormCoord; warp(uv); gl_FragColor = IMG_NORM_PIXEL(inputImage, uv); }',
    ],
    ['pixels taken for the other kind', 'void main() { gl_FragColor = IMG_NORM_PIXEL(inputImage, gl_FragCoord.xy); }'],
    [
      'a local of the same name',
      'void main() { vec2 isf_FragNormCoord = shift; gl_FragColor = IMG_NORM_PIXEL(inputImage, isf_FragNormCoord); }',
    ],
    ['pixels by the size of another image', 'void main() { gl_FragColor = IMG_PIXEL(inputImage, IMG_SIZE(other) * isf_FragNormCoord); }'],
    ['depth elsewhere', 'void main() { gl_FragColor = vec4(LAYER_DEPTH(inputImage, shift)); }'],
  ])('%s', (_, body) => {
    expect(accessOf(body)).toBe('displaced');
  });
});

describe('neighborhood', () => {
  test.each([
    ['two pixels', `void main() { gl_FragColor = ${HERE} - IMG_NORM_PIXEL(inputImage, shift); }`],
    ['one pixel, in a loop', 'void main() { for (int i = 0; i < 3; i++) gl_FragColor += IMG_NORM_PIXEL(inputImage, shift * float(i)); }'],
    [
      'one pixel, in a function called twice',
      'vec4 at(vec2 p) { return IMG_NORM_PIXEL(inputImage, p); } void main() { gl_FragColor = at(isf_FragNormCoord) + at(shift); }',
    ],
    [
      'a function called in a loop',
      'vec4 f() { return IMG_NORM_PIXEL(inputImage, shift); } void main() { int i = 0; while (i < 3) { i++; gl_FragColor += f(); } }',
    ],
    ['a derivative', `void main() { gl_FragColor = fwidth(${HERE}); }`],
    ['an image handed on', 'vec4 f(sampler2D i) { return IMG_THIS_PIXEL(i); } void main() { gl_FragColor = f(inputImage); }'],
    ['what cannot be parsed', 'void main() { gl_FragColor = ; }'],
  ])('%s', (_, body) => {
    expect(accessOf(body)).toBe('neighborhood');
  });

  test('several passes', () => {
    expect(accessOf(`void main() { gl_FragColor = ${HERE}; }`, { PASSES: [{ TARGET: 'a' }, {}] })).toBe('neighborhood');
  });
});

test('buffers that stay, and buffers of other sizes, decide before the text does', () => {
  const body = `void main() { gl_FragColor = ${HERE}; }`;
  expect(accessOf(body, { PASSES: [{ TARGET: 'a', PERSISTENT: true, WIDTH: 1 }, {}] })).toBe('persistent');
  expect(accessOf(body, { PASSES: [{ TARGET: 'a', WIDTH: '$WIDTH / 2' }, {}] })).toBe('resize');
  expect(accessOf(body, { PASSES: [{ WIDTH: '$WIDTH' }] })).toBe('pointwise');
});

describe('a read at the center of another pixel', () => {
  const pixel = (at: string) => `IMG_PIXEL(inputImage, ${at})`;
  const norm = (at: string) => `IMG_NORM_PIXEL(inputImage, ${at})`;
  const color = (read: string) => `void main() { gl_FragColor = ${read}; }`;

  test.each([
    ['a whole number of pixels away', color(pixel('gl_FragCoord.xy + vec2(3.0, -1.0)'))],
    ['as far as a whole param', color(pixel('gl_FragCoord.xy - float(count) * vec2(2, 1)'))],
    ['of a rounded number of pixels', color(pixel('gl_FragCoord.xy + floor(shift * 20.0)'))],
    ['of the corner of a block', color(pixel('floor(gl_FragCoord.xy / size) * 4.0 + 0.5'))],
    ['at a center by the number of the pixel', color(pixel('vec2(ivec2(shift)) + vec2(0.5)'))],
    ['within bounds', color(pixel('clamp(gl_FragCoord.xy + 3.0, vec2(0.5), IMG_SIZE(inputImage) - 0.5)'))],
    ['repeated', color(pixel('mod(gl_FragCoord.xy + 9.0, RENDERSIZE)'))],
    ['one of two', color(pixel('shift.x > 0.5 ? gl_FragCoord.xy + 1.0 : vec2(0.5, gl_FragCoord.y)'))],
    ['mirrored', color(norm('vec2(1.0 - isf_FragNormCoord.x, isf_FragNormCoord.y)'))],
    ['mirrored both ways', color(norm('1.0 - isf_FragNormCoord'))],
    ['pixels by the size', color(norm('isf_FragNormCoord + vec2(2.0, -count) / RENDERSIZE'))],
    ['pixels by each side', color(norm('isf_FragNormCoord - vec2(1.0 / IMG_SIZE(inputImage).x, 0.0)'))],
    ['a center by the size', color(norm('(floor(isf_FragNormCoord * RENDERSIZE * 0.3) + 0.5) / RENDERSIZE'))],
    ['of texelFetch', color('texelFetch(inputImage, ivec2(shift * 100.0), 0)')],
    ['of textureOffset', color('textureOffset(inputImage, isf_FragNormCoord, ivec2(1, 0))')],
    [
      'by way of variables and functions',
      'const float STEP = 2.0; vec4 at(vec2 by) { vec2 p = gl_FragCoord.xy + by * STEP; return IMG_PIXEL(inputImage, p); } void main() { gl_FragColor = at(vec2(1.0, 0.0)); }',
    ],
  ])('%s', (_, body) => {
    expect(readsOf(body)).toEqual({ here: 0, texels: 1, elsewhere: 0 });
  });

  test.each([
    ['half a pixel away', color(pixel('gl_FragCoord.xy + 0.5'))],
    ['a third of a pixel away', color(pixel('gl_FragCoord.xy + 0.3'))],
    ['as far as any param', color(pixel('gl_FragCoord.xy + shift'))],
    ['a scaled position', color(pixel('gl_FragCoord.xy * 2.0'))],
    ['the corner of a pixel', color(pixel('floor(gl_FragCoord.xy)'))],
    ['normalized positions as pixels', color(norm('gl_FragCoord.xy + 1.0'))],
    ['pixels by the wrong side', color(norm('isf_FragNormCoord + vec2(1.0, 0.0) / RENDERSIZE.y'))],
    ['pixels by the size of another image', color(norm('isf_FragNormCoord + vec2(1.0) / IMG_SIZE(other)'))],
    ['turned by a quarter', color(norm('isf_FragNormCoord.yx'))],
    ['mirrored at any line', color(norm('vec2(size - isf_FragNormCoord.x, isf_FragNormCoord.y)'))],
    ['a mean of centers', color(pixel('(gl_FragCoord.xy + gl_FragCoord.xy + 1.0) / 2.0'))],
    ['a variable that is changed', 'void main() { vec2 p = gl_FragCoord.xy; p += shift; gl_FragColor = IMG_PIXEL(inputImage, p); }'],
    ['a number of a matrix', color(pixel('vec2(gl_FragCoord.x, mat2(size))'))],
    ['projected', color('texture2DProj(inputImage, vec3(isf_FragNormCoord, 1.0))')],
    [
      'by way of a function with another argument elsewhere',
      'vec4 at(vec2 by) { return IMG_PIXEL(inputImage, gl_FragCoord.xy + by); } float half(vec2 by) { return at(by).r; } void main() { gl_FragColor = at(vec2(1.0)) + half(vec2(0.25)); }',
    ],
  ])('but not %s', (_, body) => {
    expect(readsOf(body)).toMatchObject({ texels: 0 });
    expect(readsOf(body)?.elsewhere).toBeGreaterThan(0);
  });

  test('reads are counted, without end in a loop', () => {
    const at = pixel('gl_FragCoord.xy + 1.0');
    expect(readsOf(`void main() { gl_FragColor = ${HERE} + ${at} * ${at}; }`)).toEqual({ here: 1, texels: 2, elsewhere: 0 });
    expect(readsOf(`void main() { for (int i = 0; i < 2; i++) gl_FragColor += ${at}; }`)?.texels).toBe(Number.POSITIVE_INFINITY);
  });
});
