import { defineNode } from '../../kit/definition.ts';

export const definition = defineNode({
  type: 'filter/cpu-equalize-histogram',
  version: 1,
  title: 'Equalize histogram',
  doc: 'Evens out how often each brightness occurs, which makes what is dim, foggy or flat easier to see, and noise too. It is computed beside the picture by the processor: one frame late and without depth.',
  keywords: ['contrast', 'histogram', 'equalize', 'equalize', 'levels', 'auto', 'cpu', 'worker', 'fog', 'night'],
  inputs: {
    inputImage: { type: 'layer', label: 'Layer', doc: 'The picture to spread. What is transparent does not count.', required: true },
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
      doc: '0 leaves the picture as it is, 1 spreads it wholly.',
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
      doc: 'Brightness alone keeps the hues; each channel by itself takes a tint of the light away as well.',
      default: 0,
      options: [
        { value: 0, label: 'Brightness' },
        { value: 1, label: 'Each channel' },
      ],
    },
  },
  lowering: { kind: 'cpu' },
});
