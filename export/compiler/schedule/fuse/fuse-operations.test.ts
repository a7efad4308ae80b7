import { expect, test } from '@jest/globals';
import { passes, twins } from '../../../../tests/support/fusion-kit.ts';

test('a fused pass sets the size that it reads, even if none of its passes reads it', () => {
  const nodes = { 'sepia-a': { type: 'filter/sepia', version: 1 }, 'flip-a': { type: 'filter/flip', version: 1 } };
  const flip = `/*{ "ISFVSN": "2", "INPUTS": [{ "NAME": "inputImage", "TYPE": "image" }] }*/
void main() { gl_FragColor = IMG_NORM_PIXEL(inputImage, vec2(1.0 - isf_FragNormCoord.x, isf_FragNormCoord.y)); }`;
  const wires = ['pattern-a.layer -> sepia-a.inputImage', 'sepia-a.layer -> flip-a.inputImage', 'flip-a.layer -> screen-a.layer'];
  const [, fused] = passes(twins(nodes, wires, { 'flip.fs': flip }).fused);
  expect(fused?.nodes).toEqual(['sepia-a', 'flip-a']);
  expect(fused?.uniforms).toContainEqual({ name: 'RENDERSIZE', type: 'vec2', source: { builtin: 'RENDERSIZE' } });
});
