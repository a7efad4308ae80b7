import { defineNode } from '../../kit/definition.ts';

export const definition = defineNode({
  type: 'layer/scene',
  version: 1,
  title: 'Scene',
  doc: 'Draws objects as a layer with depth, lit by the lights and by soft neutral surroundings, or by an Environment light instead of these. Phantoms among them hide what is behind them and show no color.',
  keywords: ['render', '3d', 'draw', 'camera', 'virtual'],
  inputs: {
    objects: { type: 'objects', label: 'Objects', doc: 'What to draw.', required: true, multiple: true },
    lights: {
      type: 'lights',
      label: 'Lights',
      doc: 'Lights of the scene. Without any, only the surroundings light it.',
      required: false,
      multiple: true,
    },
  },
  outputs: {
    layer: { type: 'layer', label: 'Layer', doc: 'The objects, transparent where there are none.', domain: 'view', depth: true },
  },
  params: {
    ambient: {
      type: 'number',
      stage: 'uniform',
      label: 'Environment',
      doc: 'Brightness of the neutral surroundings: at 1 a white matte surface is about white by them alone. Metals mirror them. An Environment light takes their place.',
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
  },
  lowering: { kind: 'geometry', shadowMap: { casters: ['objects'], lights: 'lights', enabledBy: 'shadows' } },
});
