import { defineNode } from '../../kit/definition.ts';

export const definition = defineNode({
  type: 'value/mix-color',
  version: 1,
  title: 'Mix colors',
  doc: 'Mixes two colors by an amount: wire a Smooth or a Slider to it to fade from one to the other.',
  keywords: ['color', 'blend', 'fade', 'lerp', 'interpolate', 'gradient', 'between'],
  inputs: {},
  outputs: { color: { type: 'color', label: 'Color', doc: 'The mixture.' } },
  params: {
    a: { type: 'color', stage: 'uniform', label: 'A', doc: 'The color at 0.', default: [0, 0, 0, 1] },
    b: { type: 'color', stage: 'uniform', label: 'B', doc: 'The color at 1.', default: [1, 1, 1, 1] },
    amount: {
      type: 'number',
      stage: 'uniform',
      label: 'Amount',
      doc: 'How much of B: 0 is none, 1 is all.',
      default: 0.5,
      min: 0,
      max: 1,
      step: 0.01,
      unit: 'ratio',
    },
    space: {
      type: 'choice',
      stage: 'structure',
      label: 'Way',
      doc: 'Which way it goes from one to the other. Perceived: in steps that look even. Light: as lamps mix. Screen: channel by channel, as most programs do.',
      default: 'perceived',
      options: [
        { value: 'perceived', label: 'Perceived (Oklab)' },
        { value: 'light', label: 'Light (linear)' },
        { value: 'screen', label: 'Screen (sRGB)' },
      ],
    },
  },
  lowering: { kind: 'value' },
});
