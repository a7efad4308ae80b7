import { describe, expect, test } from '@jest/globals';
import type { NodeDefinition } from '../../../nodes/kit/definition.ts';
import { FIT_PARAM, isfDefinition, shaderName } from './isf-definition.ts';
import { readIsf } from './read-isf.ts';

function define(header: Readonly<Record<string, unknown>>, main = 'gl_FragColor = vec4(1.0);', name = 'my-effect'): NodeDefinition {
  const { output, diagnostics } = readIsf(`/*${JSON.stringify(header)}*/ void main() { ${main} }`, `filters/${name}.fs`);
  if (output === null) throw new Error(JSON.stringify(diagnostics));
  return isfDefinition(output, name);
}

const IMAGE = { NAME: 'inputImage', TYPE: 'image', LABEL: 'Layer' };

describe('the node type of a file', () => {
  test('a filter, whole', () => {
    const definition = define(
      {
        ISFVSN: '2',
        DESCRIPTION: 'Does it.',
        CREDIT: 'Me',
        CATEGORIES: ['Blur', 'Soft'],
        INPUTS: [
          IMAGE,
          { NAME: 'radius', TYPE: 'float', LABEL: 'Radius', DOC: 'How far.', MIN: 0, MAX: 9, DEFAULT: 2, UNIT: 'px' },
          { NAME: 'mode', TYPE: 'long', VALUES: [1, 2], LABELS: ['one', 'two'], DEFAULT: 2 },
          { NAME: 'on', TYPE: 'bool', DEFAULT: true },
          { NAME: 'at', TYPE: 'point2D', DEFAULT: [0.5, 0.25] },
          { NAME: 'tint', TYPE: 'color', DEFAULT: [1, 0, 0, 1] },
          { NAME: 'bow', TYPE: 'curve', DEFAULT: [0, 0, 0.5, 0.75, 1, 1] },
          { NAME: 'flash', TYPE: 'event' },
          { NAME: 'room', TYPE: 'depth', OPTIONAL: true },
        ],
      },
      'gl_FragColor = IMG_THIS_PIXEL(inputImage);',
    );
    expect(definition).toEqual({
      type: 'filter/my-effect',
      version: 1,
      title: 'My effect',
      doc: 'Does it.',
      keywords: ['blur', 'soft'],
      credit: 'Me',
      inputs: {
        inputImage: { type: 'layer', label: 'Layer', doc: 'A layer.', required: true },
        flash: { type: 'pulse', label: 'flash', doc: 'True in the frame of a pulse.', required: false, multiple: true },
        room: { type: 'depth', label: 'room', doc: 'Room depth. Not connected: unknown everywhere.', required: false },
      },
      outputs: { layer: { type: 'layer', label: 'Layer', doc: 'The result.', domain: 'same', depth: 'same' } },
      params: {
        radius: { type: 'number', stage: 'uniform', label: 'Radius', doc: 'How far.', default: 2, min: 0, max: 9, unit: 'px' },
        mode: {
          type: 'choice',
          stage: 'uniform',
          label: 'mode',
          doc: '',
          default: 2,
          options: [
            { value: 1, label: 'one' },
            { value: 2, label: 'two' },
          ],
        },
        on: { type: 'toggle', stage: 'uniform', label: 'on', doc: '', default: true },
        at: { type: 'vector2', stage: 'uniform', label: 'at', doc: '', default: [0.5, 0.25] },
        tint: { type: 'color', stage: 'uniform', label: 'tint', doc: '', default: [1, 0, 0, 1] },
        bow: { type: 'curve', stage: 'uniform', label: 'bow', doc: '', default: [0, 0, 0.5, 0.75, 1, 1] },
      },
      lowering: { kind: 'image', shader: 'filters/my-effect.fs', access: 'pointwise' },
    });
  });

  test('an operator lays pictures of other sizes by a choice of its own', () => {
    const definition = define({ INPUTS: [IMAGE, { NAME: 'mask', TYPE: 'image' }] });
    expect(definition.type).toBe('operator/my-effect');
    expect(definition.params[FIT_PARAM]).toMatchObject({ type: 'choice', stage: 'structure', default: 'cover' });
    const taken = define({ INPUTS: [IMAGE, { NAME: 'mask', TYPE: 'image' }, { NAME: 'fit', TYPE: 'float' }] });
    expect(taken.params[FIT_PARAM]).toMatchObject({ type: 'number' });
  });

  test('a generator belongs to the view and has no depth', () => {
    expect(define({}).outputs.layer).toMatchObject({ domain: 'view', depth: false });
  });

  test.each([
    ['moved pixels lose their depth', {}, 'gl_FragColor = IMG_NORM_PIXEL(inputImage, isf_FragNormCoord.yx);', false],
    ['a blur keeps it', {}, 'gl_FragColor = IMG_THIS_PIXEL(inputImage) + IMG_NORM_PIXEL(inputImage, isf_FragNormCoord * 0.9);', 'same'],
    ['unless the file says otherwise', { SCRIM_DEPTH: 'none' }, 'gl_FragColor = IMG_THIS_PIXEL(inputImage);', false],
    ['or makes its own', { SCRIM_DEPTH: 'over' }, 'gl_FragColor = IMG_THIS_PIXEL(inputImage);', true],
  ])('%s', (_, header, main, depth) => {
    expect(define({ INPUTS: [IMAGE], ...header }, main).outputs.layer?.depth).toBe(depth);
  });

  test('a file whose GLSL is broken keeps its ports', () => {
    const definition = define({ INPUTS: [IMAGE] }, 'gl_FragColor = ;');
    expect(Object.keys(definition.inputs)).toEqual(['inputImage']);
    expect(definition.lowering).toMatchObject({ access: 'neighborhood' });
  });

  test('names come from files', () => {
    expect(shaderName('filters/gaussian-blur.fs')).toBe('gaussian-blur');
    expect(shaderName('edge.frag')).toBe('edge');
  });
});
