import { join } from 'node:path';
import { LIBRARY } from '../../app/services/compile-project.ts';
import type { Bench } from './bench.ts';
import { createRivals, racedBenches } from './rivals.ts';

/** A filter that copies. */
export const COPY = `/*{
  "ISFVSN": "2",
  "DESCRIPTION": "Shows a layer as it is.",
  "CREDIT": "Scrim",
  "INPUTS": [{ "NAME": "inputImage", "TYPE": "image", "LABEL": "Layer", "DOC": "The layer." }]
}*/
void main() { gl_FragColor = IMG_THIS_PIXEL(inputImage); }
`;

/**
 * Measures effects with default params on a photograph of 480 × 360 pixels: milliseconds per frame, and the cost of the effect as a multiple
 * of the cost of copying a layer. A frame draws the effect and then copies its layer to the screen; a frame of the reference makes two
 * copies. The cost in copies is therefore twice the ratio of the two frame times, less one.
 */
export function benchesInCopies(root: string, types: readonly string[]): readonly Bench[] {
  const rivals = createRivals({
    root,
    folder: join(root, 'examples', 'sessions', 'studio'),
    base: projectOf('filter/copy', ['inputImage']),
    shaders: { 'copy.fs': COPY },
    rows: 2 * types.length,
  });
  return types.flatMap((type) => {
    const { inputs = {} } = LIBRARY.definition(type) ?? {};
    const ports = Object.keys(inputs).filter((port) => inputs[port]?.type === 'layer');
    return racedBenches(rivals, {
      project: projectOf(type, ports),
      ratio: { name: `cost of ${type}, in plain copies`, of: ({ ours, base }) => (2 * ours) / base - 1 },
      frame: `frame, ${type}`,
    });
  });
}

/** A project in which the photograph is connected to each layer input of the effect. */
function projectOf(type: string, ports: readonly string[]): object {
  return {
    format: 'scrim-project',
    version: 1,
    title: type,
    graphs: {
      main: {
        nodes: {
          'picture-0000': { type: 'source/image-file', version: 1, params: { file: 'photograph' } },
          'effect-0000': { type, version: LIBRARY.definition(type)?.version ?? 1 },
          'screen-0000': { type: 'output/screen', version: 1 },
        },
        wires: [...ports.map((port) => `picture-0000.layer -> effect-0000.${port}`), 'effect-0000.layer -> screen-0000.layer'],
      },
    },
    assets: { photograph: { path: 'color/000.jpg', kind: 'image' } },
  };
}
