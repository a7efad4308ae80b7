import { defineNode } from '../../kit/definition.ts';

const BRIGHTNESS = 'max(color.r, color.g, color.b)';
const CHROMA = `(${BRIGHTNESS} - min(color.r, color.g, color.b))`;
/** The hue in turns, as `hsvFromRgb` computes it. */
const HUE = [
  `${CHROMA} == 0 ? 0`,
  `${BRIGHTNESS} == color.r ? ((color.g - color.b) / ${CHROMA} / 6 + 1) % 1`,
  `${BRIGHTNESS} == color.g ? (color.b - color.r) / ${CHROMA} / 6 + 1 / 3`,
  `(color.r - color.g) / ${CHROMA} / 6 + 2 / 3`,
].join(' : ');

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
  computes: {
    red: 'color.r',
    green: 'color.g',
    blue: 'color.b',
    alpha: 'color.a',
    hueRad: `(${HUE}) * 2 * pi`,
    saturation: `${BRIGHTNESS} == 0 ? 0 : ${CHROMA} / ${BRIGHTNESS}`,
    brightness: BRIGHTNESS,
  },
  lowering: { kind: 'value' },
});
