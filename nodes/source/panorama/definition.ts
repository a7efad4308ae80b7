import { defineNode } from '../../kit/definition.ts';

export const definition = defineNode({
  type: 'source/panorama',
  version: 1,
  title: 'Panorama',
  doc: 'Loads an equirectangular 360° image, twice as wide as high, to light a scene. HDR (.hdr) and OpenEXR (.exr) files contain the full range of brightness, from shadow to sun; JPEG, PNG and WebP files contain nothing brighter than white.',
  keywords: ['hdri', 'hdr', 'exr', '360', 'equirectangular', 'sky', 'environment', 'spherical', 'skybox'],
  inputs: {},
  outputs: {
    environment: { type: 'environment', label: 'Environment', doc: 'The panorama, for an Environment light; nothing while it loads.' },
  },
  params: {
    file: { type: 'asset', stage: 'asset', label: 'File', doc: 'The panorama file.', default: '', accept: 'environment' },
    rotationRad: {
      type: 'number',
      stage: 'uniform',
      label: 'Rotation',
      doc: 'Rotates the panorama about the vertical axis, counterclockwise seen from above. At 0 its center is straight ahead (−z).',
      default: 0,
      min: -Math.PI,
      max: Math.PI,
      step: 0.01,
      unit: 'rad',
    },
    exposure: {
      type: 'number',
      stage: 'uniform',
      label: 'Exposure',
      doc: 'Brightness in stops: each stop doubles it.',
      default: 0,
      min: -10,
      max: 10,
      step: 0.1,
      unit: 'none',
    },
  },
  lowering: { kind: 'source' },
});
