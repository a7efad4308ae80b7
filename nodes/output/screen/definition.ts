import { defineNode } from '../../kit/definition.ts';

export const definition = defineNode({
  type: 'output/screen',
  version: 1,
  title: 'Screen',
  doc: 'What the visitor sees. Every project has one. Where the layer is transparent, the background shows.',
  keywords: ['output', 'display', 'present', 'result', 'final', 'view'],
  inputs: { layer: { type: 'layer', label: 'Layer', doc: 'The finished picture.', required: true } },
  outputs: {},
  params: {
    antialias: {
      type: 'toggle',
      stage: 'structure',
      label: 'Smooth edges',
      doc: 'Draws objects with four samples per pixel. Costs some speed and memory.',
      default: true,
    },
    background: {
      type: 'choice',
      stage: 'structure',
      label: 'Background',
      doc: 'What lies behind the layer.',
      default: 'world',
      options: [
        { value: 'world', label: 'The world' },
        { value: 'color', label: 'A colour' },
      ],
    },
    color: {
      type: 'color',
      stage: 'structure',
      label: 'Colour',
      doc: 'The colour behind the layer, if a colour is chosen.',
      default: [0, 0, 0, 1],
    },
  },
  lowering: { kind: 'present' },
});
