import { defineNode } from '../../kit/definition.ts';

export const definition = defineNode({
  type: 'value/split-color',
  version: 1,
  title: 'Split color',
  doc: 'Takes a color apart: red, green, blue and alpha, and hue, saturation and brightness.',
  keywords: ['color', 'rgb', 'hsv', 'channel', 'separate', 'component', 'alpha', 'hue'],
  inputs: {},
  outputs: {
    red: { type: 'number', label: 'Red', doc: 'From 0 to 1.' },
    green: { type: 'number', label: 'Green', doc: 'From 0 to 1.' },
    blue: { type: 'number', label: 'Blue', doc: 'From 0 to 1.' },
    alpha: { type: 'number', label: 'Alpha', doc: '0 is transparent, 1 is opaque.' },
    hueRad: { type: 'number', label: 'Hue', doc: 'Radians around the color circle; 0 of grays.' },
    saturation: { type: 'number', label: 'Saturation', doc: '0 is gray, 1 is the full color.' },
    brightness: { type: 'number', label: 'Brightness', doc: 'That of the brightest channel.' },
  },
  params: { color: { type: 'color', stage: 'uniform', label: 'Color', doc: 'What to take apart.', default: [1, 1, 1, 1] } },
  lowering: { kind: 'value' },
});
