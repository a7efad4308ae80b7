import { describe, expect, test } from '@jest/globals';
import { readIsf } from '../isf/read-isf.ts';
import { findAccess } from './find-access.ts';

function accessOf(body: string, header: Readonly<Record<string, unknown>> = {}): string {
  const inputs = [
    { NAME: 'inputImage', TYPE: 'image' },
    { NAME: 'other', TYPE: 'image' },
    { NAME: 'room', TYPE: 'depth' },
    { NAME: 'shift', TYPE: 'point2D' },
    { NAME: 'tone', TYPE: 'curve' },
  ];
  const { output } = readIsf(`/*${JSON.stringify({ INPUTS: inputs, ...header })}*/\n${body}`, 'test.fs');
  if (output === null) throw new Error('The header is broken.');
  return findAccess(output);
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
