import { defineNode } from '../../kit/definition.ts';

export const definition = defineNode({
  type: 'layer/scene',
  version: 1,
  title: 'Scene',
  doc: 'Draws objects as a layer with depth. The objects are lit by the lights and by a soft neutral environment, or by an Environment light instead of it. Phantoms hide what is behind them and are not visible themselves. Glass of models (transmission) shows the objects behind it, refracted.',
  keywords: ['render', '3d', 'draw', 'camera', 'virtual', 'glass', 'transmission', 'refraction'],
  inputs: {
    objects: { type: 'objects', label: 'Objects', doc: 'The objects to draw.', required: true, multiple: true },
    lights: {
      type: 'lights',
      label: 'Lights',
      doc: 'Lights of the scene. Not connected: only the neutral environment lights it.',
      required: false,
      multiple: true,
    },
    behind: {
      type: 'layer',
      label: 'Behind glass',
      doc: 'The layer that glass shows where no object is behind it: usually the one that this layer is put over. Not connected: the layer at the glass material; else the camera image if the scene is drawn right over the room; else the glass is transparent and does not refract what is under the layer.',
      required: false,
      encoding: 'either',
    },
  },
  outputs: {
    layer: {
      type: 'layer',
      label: 'Layer',
      doc: 'The objects, transparent where there are none.',
      domain: 'view',
      depth: true,
      encoding: { param: 'encoding' },
    },
  },
  params: {
    ambient: {
      type: 'number',
      stage: 'uniform',
      label: 'Environment',
      doc: 'Brightness of the neutral environment: at 1 it alone renders a white matte surface as about white. Metals reflect it. An Environment light replaces it.',
      default: 0.5,
      min: 0,
      max: 3,
      step: 0.01,
      unit: 'ratio',
    },
    shadows: {
      type: 'toggle',
      stage: 'structure',
      label: 'Shadows',
      doc: 'Whether objects cast shadows on each other.',
      default: true,
    },
    encoding: {
      type: 'choice',
      stage: 'structure',
      label: 'Encoding',
      doc: 'Display: colors as a screen shows them; what is brighter than white is lost. Scene: linear light of any brightness, for Exposure, Bloom and Depth of field; a Tone map then makes it a display layer. Scene layers take twice the memory.',
      default: 'display',
      options: [
        { value: 'display', label: 'Display' },
        { value: 'scene', label: 'Scene' },
      ],
    },
  },
  lowering: { kind: 'geometry', shadowMap: { casters: ['objects'], lights: 'lights', enabledBy: 'shadows' } },
});
