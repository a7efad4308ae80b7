import { defineNode } from '../../kit/definition.ts';

export const definition = defineNode({
  type: 'source/panorama',
  version: 1,
  title: 'Panorama',
  doc: 'Brings in a picture of everything around one point, twice as wide as high (equirectangular), to light a scene with. HDR (.hdr) and OpenEXR (.exr) files hold real brightness, from shadow to sun; JPEG, PNG and WebP hold none beyond white.',
  keywords: ['hdri', 'hdr', 'exr', '360', 'equirectangular', 'sky', 'environment', 'spherical', 'skybox'],
  inputs: {},
  outputs: {
    environment: { type: 'environment', label: 'Environment', doc: 'The panorama, for an Environment light; nothing while it loads.' },
  },
  params: {
    file: { type: 'asset', stage: 'asset', label: 'File', doc: 'The panorama.', default: '', accept: 'environment' },
    rotationRad: {
      type: 'number',
      stage: 'uniform',
      label: 'Rotation',
      doc: 'Turns it about the vertical, to the left seen from above. At 0 its middle lies straight ahead (−z).',
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
      doc: 'Brightness in stops: each one more doubles it.',
      default: 0,
      min: -10,
      max: 10,
      step: 0.1,
      unit: 'none',
    },
  },
  lowering: { kind: 'source' },
});
