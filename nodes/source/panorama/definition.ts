import { defineNode } from '../../kit/definition.ts';
import { PANORAMA_PARAMS } from '../../kit/panorama/params.ts';

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
    ...PANORAMA_PARAMS,
  },
  lowering: { kind: 'source' },
});
