import { expect, test } from '@jest/globals';
import { passes, twins } from '../../../tests/support/fusion-kit.ts';
import type { Program } from '../../program/program.ts';

const FILTER = (body: string, more = '') =>
  `/*{ "ISFVSN": "2", "INPUTS": [{ "NAME": "inputImage", "TYPE": "image" }]${more} }*/\nvoid main() { ${body} }`;

/** pattern → the filter `own` → screen. */
function own(body: string, more = ''): Program {
  const wires = ['pattern-a.layer -> own-a.inputImage', 'own-a.layer -> screen-a.layer'];
  return twins({ 'own-a': { type: 'filter/own', version: 1 } }, wires, { 'own.fs': FILTER(body, more) }).separate;
}

/** Layers that are read without filtering, as `pass: layer`. */
function unfiltered(program: Program): string[] {
  return passes(program).flatMap(({ id, samplers }) =>
    samplers.flatMap(({ source, unfiltered: isMarked }) => (isMarked && source.kind === 'color' ? [`${id}: ${source.resource}`] : [])),
  );
}

const HERE = 'gl_FragColor = IMG_THIS_PIXEL(inputImage);';

test('layers are read unfiltered where a pass of their size reads pixels only', () => {
  expect(unfiltered(own(HERE))).toEqual(['own-a.pass0: pattern-a.layer']);
  expect(unfiltered(own('gl_FragColor = IMG_PIXEL(inputImage, gl_FragCoord.xy + 1.0);'))).toEqual(['own-a.pass0: pattern-a.layer']);
});

test('but not where it reads between pixels, or perhaps does', () => {
  expect(unfiltered(own('gl_FragColor = IMG_NORM_PIXEL(inputImage, isf_FragNormCoord * 0.7);'))).toEqual([]);
  expect(unfiltered(own('gl_FragColor = fwidth(IMG_THIS_PIXEL(inputImage));'))).toEqual([]);
});

test('nor by a pass of another size', () => {
  const half = ', "PASSES": [{ "TARGET": "half", "WIDTH": "$WIDTH / 2" }, {}]';
  expect(unfiltered(own(`if (PASSINDEX == 0) { ${HERE} } else { gl_FragColor = IMG_THIS_PIXEL(half); }`, half))).toEqual([]);
});

test('nor an image that is fitted to the view', () => {
  const nodes = { 'file-a': { type: 'source/image-file', version: 1 }, 'grey-a': { type: 'filter/grey', version: 1 } };
  const wires = ['file-a.layer -> grey-a.inputImage', 'grey-a.layer -> blend-a.top', 'pattern-a.layer -> blend-a.bottom'];
  const fitted = twins({ ...nodes, 'blend-a': { type: 'operator/blend', version: 1 } }, [...wires, 'blend-a.layer -> screen-a.layer']);
  expect(unfiltered(fitted.separate)).toEqual(['blend-a.pass0: pattern-a.layer']);
});
