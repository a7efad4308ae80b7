import { defineNode } from '../../kit/definition.ts';
import { CASTS_SHADOW } from '../../kit/material-params.ts';

export const definition = defineNode({
  type: 'objects/line',
  version: 1,
  title: 'Line',
  doc: 'Draws a straight line between two poses: a round rod with a width in meters, or a flat line that is equally wide in the image at any distance. Real and virtual things in front hide it like other objects. It has the same color in any light.',
  keywords: ['rod', 'segment', 'ruler', 'connect', 'beam', 'laser', 'stroke', 'measure', 'dimension'],
  inputs: {
    from: { type: 'pose', label: 'From', doc: 'The pose at which the line starts.', required: true },
    to: { type: 'pose', label: 'To', doc: 'The pose at which it ends.', required: true },
  },
  outputs: {
    objects: { type: 'objects', label: 'Line', doc: 'The line; none while a pose is invalid or both are at the same position.' },
  },
  params: {
    widthIn: {
      type: 'choice',
      stage: 'structure',
      label: 'Width in',
      doc: 'Whether the line is a thing in the room, which looks thinner from afar, or as wide in the image everywhere. One with a width in pixels casts no shadow.',
      default: 'meters',
      options: [
        { value: 'meters', label: 'Meters in the room' },
        { value: 'pixels', label: 'Pixels of the image' },
      ],
    },
    widthM: {
      type: 'number',
      stage: 'uniform',
      label: 'Width',
      doc: 'Diameter of the line, if its width is in meters.',
      default: 0.005,
      min: 0,
      max: 1,
      step: 0.001,
      unit: 'm',
    },
    widthPx: {
      type: 'number',
      stage: 'uniform',
      label: 'Width in pixels',
      doc: 'Width of the line, if it is in pixels: of the image that is drawn, of which phones have two to three per pixel of the page.',
      default: 4,
      min: 0,
      max: 100,
      step: 0.5,
      unit: 'px',
    },
    color: {
      type: 'color',
      stage: 'uniform',
      label: 'Color',
      doc: 'Color of the line. With alpha below 1 it is transparent.',
      default: [1, 1, 1, 1],
    },
    castShadow: { ...CASTS_SHADOW, default: false },
  },
  lowering: { kind: 'geometry' },
});
