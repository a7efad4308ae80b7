import { defineNode } from '../../kit/definition.ts';

export const definition = defineNode({
  type: 'value/split-color',
  version: 1,
  title: 'Split color',
  doc: 'Splits a color into red, green, blue and alpha, and into hue, saturation and brightness.',
  keywords: ['color', 'rgb', 'hsv', 'channel', 'separate', 'component', 'alpha', 'hue'],
  inputs: {},
  outputs: {
    red: { type: 'number', label: 'Red', doc: 'From 0 to 1.' },
    green: { type: 'number', label: 'Green', doc: 'From 0 to 1.' },
    blue: { type: 'number', label: 'Blue', doc: 'From 0 to 1.' },
    alpha: { type: 'number', label: 'Alpha', doc: '0 is transparent, 1 is opaque.' },
    hueRad: { type: 'number', label: 'Hue', doc: 'Hue in radians, from 0 to 2π; 0 for grays.' },
    saturation: { type: 'number', label: 'Saturation', doc: '0 is gray, 1 is fully saturated.' },
    brightness: { type: 'number', label: 'Brightness', doc: 'The value of the brightest channel, from 0 to 1.' },
  },
  params: { color: { type: 'color', stage: 'uniform', label: 'Color', doc: 'The color to split.', default: [1, 1, 1, 1] } },
  lowering: { kind: 'value' },
});
