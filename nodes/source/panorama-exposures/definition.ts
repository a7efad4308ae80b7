import { defineNode } from '../../kit/definition.ts';
import { PANORAMA_PARAMS } from '../../kit/panorama/params.ts';

const OTHER_SHOT = {
  type: 'asset',
  stage: 'asset',
  doc: 'The same panorama with another exposure: same place, same size.',
  default: '',
  accept: 'environment',
} as const;

export const definition = defineNode({
  type: 'source/panorama-exposures',
  version: 1,
  title: 'Panorama from exposures',
  doc: 'Merges shots of one panorama with different exposures, as cameras take them by exposure bracketing, to one with the full range of brightness. Lamps and windows, which are white in a single JPEG file, then have their true brightness and color, as long as the darkest shot does not clip them.',
  keywords: ['hdr', 'bracketing', 'aeb', 'exposure', 'merge', 'debevec', 'panorama', '360', 'environment', 'light probe'],
  inputs: {},
  outputs: {
    environment: { type: 'environment', label: 'Environment', doc: 'The merged panorama; nothing while it loads.' },
  },
  params: {
    file: {
      type: 'asset',
      stage: 'asset',
      label: 'Shot 1',
      doc: 'The shot whose brightness the result keeps: JPEG, PNG, WebP or AVIF, twice as wide as high.',
      default: '',
      accept: 'environment',
    },
    file2: { ...OTHER_SHOT, label: 'Shot 2' },
    shots: {
      type: 'choice',
      stage: 'structure',
      label: 'Shots',
      doc: 'The number of shots. Two are enough if they are at most about 5 stops apart.',
      default: '2',
      options: [
        { value: '2', label: '2' },
        { value: '3', label: '3' },
      ],
    },
    file3: { ...OTHER_SHOT, label: 'Shot 3', where: { param: 'shots', is: '3' } },
    stopsApart: {
      type: 'number',
      stage: 'structure',
      label: 'Stops apart',
      doc: 'Exposure difference between a shot and the next darker one, in stops. At 0 it is measured from pixels that both show.',
      default: 0,
      min: 0,
      max: 10,
      step: 0.1,
      unit: 'none',
    },
    ...PANORAMA_PARAMS,
  },
  lowering: { kind: 'source' },
  worker: true,
});
