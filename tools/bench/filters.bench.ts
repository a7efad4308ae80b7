import { join } from 'node:path';
import { LIBRARY } from '../../app/services/compile-project.ts';
import type { NodeDefinition } from '../../nodes/kit/definition.ts';
import type { ToolContext } from '../lib/tool.ts';
import type { Bench } from './bench.ts';
import { createRivals, racedBenches } from './rivals.ts';

const COPY = `/*{
  "ISFVSN": "2",
  "DESCRIPTION": "Shows a layer as it is.",
  "CREDIT": "Scrim",
  "INPUTS": [{ "NAME": "inputImage", "TYPE": "image", "LABEL": "Layer", "DOC": "The layer." }]
}*/
void main() { gl_FragColor = IMG_THIS_PIXEL(inputImage); }
`;

/** The worker of a CPU filter does not block the page, so only drawn filters are measured. */
const DRAWN: ReadonlySet<NodeDefinition['lowering']['kind']> = new Set(['image', 'cpu']);
const EFFECTS = ['filter/', 'operator/'];

/**
 * Every filter and operator over a photograph of 480 by 360 pixels with its own values: milliseconds of a frame, and its cost as a
 * multiple of a plain copy's. A frame is the effect and the copy that brings its picture onto the screen, so that against a copy in
 * the effect's place it takes half of the effect's cost and a half: twice the ratio, less one.
 */
export async function benches({ root }: ToolContext): Promise<readonly Bench[]> {
  const types = [...LIBRARY.types()].filter((type) => {
    const kind = LIBRARY.definition(type)?.lowering.kind;
    return EFFECTS.some((start) => type.startsWith(start)) && kind !== undefined && DRAWN.has(kind);
  });
  const rivals = createRivals({
    root,
    folder: join(root, 'examples', 'sessions', 'studio'),
    base: projectOf('filter/copy', ['inputImage']),
    shaders: { 'copy.fs': COPY },
    rows: 2 * types.length,
  });
  return types.sort().flatMap((type) => {
    const { inputs = {} } = LIBRARY.definition(type) ?? {};
    const ports = Object.keys(inputs).filter((port) => inputs[port]?.type === 'layer');
    return racedBenches(rivals, {
      project: projectOf(type, ports),
      ratio: { name: `cost of ${type}, in plain copies`, of: ({ ours, base }) => (2 * ours) / base - 1 },
      frame: `frame, ${type}`,
    });
  });
}

/** Connects the photograph to each layer input. */
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
