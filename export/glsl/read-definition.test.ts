import { expect, test } from '@jest/globals';
import { readDefinition } from './read-definition.ts';

const HEADER = '/*{ "INPUTS": [{ "NAME": "inputImage", "TYPE": "picture" }] }*/';

test('a header that cannot be used does not hide what is wrong below it', () => {
  const told = (source: string) => readDefinition(source, 'filters/x.fs').diagnostics.map(({ code, line }) => [code, line]);
  expect(told(`${HEADER}\nvoid main() {\n  float x = 1.0\n  gl_FragColor = vec4(x);\n}`)).toEqual([
    ['SCR040', 1],
    ['SCR041', 3],
  ]);
  expect(told(`${HEADER}\nvoid main() { gl_FragColor = IMG_THIS_PIXEL(inputImage); }`)).toEqual([['SCR040', 1]]);
  expect(told('/*{ "INPUTS": []\nvoid main() {}')).toEqual([['SCR040', 1]]);
});
