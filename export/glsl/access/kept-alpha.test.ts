import { expect, test } from '@jest/globals';
import { checkIsf } from '../isf/checked-isf.ts';
import { readIsf } from '../isf/read-isf.ts';
import { keptAlpha } from './kept-alpha.ts';

function alphaOf(body: string): string | null {
  const inputs = ['inputImage', 'other'].map((NAME) => ({ NAME, TYPE: 'image' }));
  const { output } = readIsf(`/*${JSON.stringify({ INPUTS: inputs })}*/\n${body}`, 'test.fs');
  if (output === null) throw new Error('The header is broken.');
  return keptAlpha(checkIsf(output).checked, 0);
}

const COLOR = 'vec4 color = IMG_THIS_PIXEL(inputImage);';

test.each([
  ['a copy', 'void main() { gl_FragColor = IMG_THIS_PIXEL(inputImage); }', 'inputImage'],
  ['changed colors', `void main() { ${COLOR} gl_FragColor = vec4(1.0 - color.rgb, color.a); }`, 'inputImage'],
  ['components one by one', `void main() { ${COLOR} gl_FragColor = vec4(color.g, 0.5, color.r, color.w); }`, 'inputImage'],
  [
    'the alpha of the other image',
    `void main() { ${COLOR} vec4 two = IMG_THIS_PIXEL(other); gl_FragColor = vec4(color.rgb, two.a); }`,
    'other',
  ],
])('alpha is kept: %s', (_, body, image) => {
  expect(alphaOf(body)).toBe(image);
});

test.each([
  ['computed', `void main() { ${COLOR} gl_FragColor = vec4(color.rgb, color.a * 0.5); }`],
  ['another component', `void main() { ${COLOR} gl_FragColor = vec4(color.rgb, color.r); }`],
  ['a changed color', `void main() { ${COLOR} color.a = 0.5; gl_FragColor = vec4(color.rgb, color.a); }`],
  [
    'changed by a function',
    `void change(inout vec4 c) { c = vec4(0.0); } void main() { ${COLOR} change(color); gl_FragColor = vec4(color.rgb, color.a); }`,
  ],
  [
    'changed by a function within the expression',
    `vec3 change(out vec4 c) { c = vec4(0.0); return c.rgb; } void main() { ${COLOR} gl_FragColor = vec4(change(color), color.a); }`,
  ],
  ['given before', `void main() { ${COLOR} if (color.r > 0.5) { gl_FragColor = vec4(1.0); return; } gl_FragColor = color; }`],
  ['changed after', `void main() { ${COLOR} gl_FragColor = color; gl_FragColor.a = 1.0; }`],
  ['given in a branch', `void main() { ${COLOR} if (color.r > 0.5) gl_FragColor = color; }`],
  ['added to', `void main() { ${COLOR} gl_FragColor += color; }`],
])('alpha is not kept, or it is unclear: %s', (_, body) => {
  expect(alphaOf(body)).toBeNull();
});
