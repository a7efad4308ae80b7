import { defineNode } from '../../kit/definition.ts';

export const definition = defineNode({
  type: 'filter/cpu-equalize-histogram',
  version: 1,
  title: 'Equalize histogram',
  doc: 'Equalizes the histogram of a layer: dim, foggy and flat areas gain contrast, and noise becomes more visible. It is computed on the CPU, so its output is one frame late and has no depth.',
  keywords: ['contrast', 'histogram', 'equalize', 'equalize', 'levels', 'auto', 'cpu', 'worker', 'fog', 'night'],
  inputs: {
    inputImage: { type: 'layer', label: 'Layer', doc: 'The layer to equalize. Transparent pixels do not count.', required: true },
  },
  outputs: {
    layer: {
      type: 'layer',
      label: 'Layer',
      doc: 'The equalized image of the previous frame; the first frame is unchanged.',
      domain: 'same',
      depth: false,
    },
  },
  params: {
    amount: {
      type: 'number',
      stage: 'uniform',
      label: 'Amount',
      doc: '0 leaves the image unchanged; 1 equalizes it fully.',
      default: 1,
      min: 0,
      max: 1,
      step: 0.01,
      unit: 'ratio',
    },
    spread: {
      type: 'choice',
      stage: 'uniform',
      label: 'Spread',
      doc: '“Brightness” keeps the hues. “Each channel” equalizes red, green and blue separately, which also removes a color cast.',
      default: 0,
      options: [
        { value: 0, label: 'Brightness' },
        { value: 1, label: 'Each channel' },
      ],
    },
  },
  lowering: { kind: 'cpu' },
});
