import { defineNode } from '../../kit/definition.ts';
import { LOCAL_LIGHT_CASTS_SHADOW, LOCAL_LIGHT_RANGE_M, POINT_SHADOW_FILTER, SHADOW_BIAS_PX } from '../../kit/light-params.ts';

export const definition = defineNode({
  type: 'light/point',
  version: 1,
  title: 'Point light',
  doc: 'A light that shines from one point in all directions, as a bulb does. At twice the distance a surface receives a quarter of the light.',
  keywords: ['bulb', 'lamp', 'omni', 'candle', 'lantern', 'shadow'],
  inputs: {},
  outputs: { lights: { type: 'lights', label: 'Light', doc: 'The light, for Scene and Shadow nodes.' } },
  params: {
    color: { type: 'color', stage: 'uniform', label: 'Color', doc: 'Color of the light.', default: [1, 1, 1, 1] },
    intensityCd: {
      type: 'number',
      stage: 'uniform',
      label: 'Intensity',
      doc: 'Brightness in candela, the same in all directions: at about 3 this light alone renders a white matte surface that faces it at one meter as white. A bulb of 800 lumen has 64.',
      default: 3,
      min: 0,
      max: 1000,
      step: 0.1,
      unit: 'cd',
    },
    positionM: {
      type: 'vector3',
      stage: 'uniform',
      handle: 'position',
      label: 'Position',
      doc: 'Position of the light in world space, in meters: x to the right, y up, z towards the viewer.',
      default: [0, 1.5, 0],
      unit: 'm',
    },
    rangeM: LOCAL_LIGHT_RANGE_M,
    castShadow: LOCAL_LIGHT_CASTS_SHADOW,
    mapSize: {
      type: 'choice',
      stage: 'structure',
      label: 'Shadow resolution',
      doc: 'Side of each of the six shadow maps in pixels. A larger map takes more memory and time: 1024 needs 30 MB. Objects are drawn six times.',
      default: '1024',
      options: [
        { value: '256', label: '256' },
        { value: '512', label: '512' },
        { value: '1024', label: '1024' },
        { value: '2048', label: '2048' },
      ],
    },
    biasPx: SHADOW_BIAS_PX,
    filter: POINT_SHADOW_FILTER,
  },
  lowering: { kind: 'geometry' },
});
