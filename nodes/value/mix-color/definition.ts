import { defineNode } from '../../kit/definition.ts';

export const definition = defineNode({
  type: 'value/mix-color',
  version: 1,
  title: 'Mix colors',
  doc: 'Mixes two colors. Connect a Slider or a Smooth node to “Amount” to fade from one to the other.',
  keywords: ['color', 'blend', 'fade', 'lerp', 'interpolate', 'gradient', 'between'],
  inputs: {},
  outputs: { color: { type: 'color', label: 'Color', doc: 'The mixed color.' } },
  params: {
    a: { type: 'color', stage: 'uniform', label: 'A', doc: 'The color at amount 0.', default: [0, 0, 0, 1] },
    b: { type: 'color', stage: 'uniform', label: 'B', doc: 'The color at amount 1.', default: [1, 1, 1, 1] },
    amount: {
      type: 'number',
      stage: 'uniform',
      label: 'Amount',
      doc: 'How much of B: 0 gives A, 1 gives B.',
      default: 0.5,
      min: 0,
      max: 1,
      step: 0.01,
      unit: 'ratio',
    },
    space: {
      type: 'choice',
      stage: 'structure',
      label: 'Color space',
      doc: 'The color space in which the colors are mixed. Oklab gives steps that look even; linear mixes as light does; sRGB mixes channel by channel, as most programs do.',
      default: 'perceived',
      options: [
        { value: 'perceived', label: 'Oklab (perceptual)' },
        { value: 'light', label: 'Linear light' },
        { value: 'screen', label: 'sRGB' },
      ],
    },
  },
  computes: { color: { call: 'writeMixedColor', params: ['a', 'b', 'amount', 'space'] } },
  lowering: { kind: 'value' },
});
