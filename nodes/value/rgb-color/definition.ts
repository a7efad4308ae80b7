import { defineNode } from '../../kit/definition.ts';

export const definition = defineNode({
  type: 'value/rgb-color',
  version: 1,
  title: 'Color from RGB',
  doc: 'Makes a color from red, green and blue.',
  keywords: ['color', 'rgb', 'rgba', 'make', 'combine', 'channel'],
  inputs: {},
  outputs: { color: { type: 'color', label: 'Color', doc: 'The color; channels are clamped to 0 to 1.' } },
  params: {
    red: { type: 'number', stage: 'uniform', label: 'Red', doc: 'From 0 to 1.', default: 1, min: 0, max: 1, step: 0.01 },
    green: { type: 'number', stage: 'uniform', label: 'Green', doc: 'From 0 to 1.', default: 1, min: 0, max: 1, step: 0.01 },
    blue: { type: 'number', stage: 'uniform', label: 'Blue', doc: 'From 0 to 1.', default: 1, min: 0, max: 1, step: 0.01 },
    alpha: {
      type: 'number',
      stage: 'uniform',
      label: 'Alpha',
      doc: '0 is transparent, 1 is opaque.',
      default: 1,
      min: 0,
      max: 1,
      step: 0.01,
    },
  },
  computes: { color: '[clamp(red, 0, 1), clamp(green, 0, 1), clamp(blue, 0, 1), clamp(alpha, 0, 1)]' },
  lowering: { kind: 'value' },
});
