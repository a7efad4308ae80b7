import { mkdtemp, rm, writeFile } from 'node:fs/promises';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import sharp from 'sharp';
import { LIBRARY } from '../../app/services/compile-project.ts';
import type { ToolContext } from '../lib/tool.ts';
import type { Bench } from './bench.ts';
import { COPY } from './in-copies.ts';
import { machineLoad } from './machine-load.ts';
import { createRivals, racedBenches } from './rivals.ts';

const EFFECTS = ['filter/room-drawing', 'operator/sketched-occlusion'] as const;
const SIZE_PX = [160, 120] as const;

/**
 * Measures drawings that need room depth over a ball, half of which a wall hides: milliseconds per frame, and the ratio to the same frame
 * with a plain copy in place of the effect and its depth. The room is an image of depth of the size that phones measure: a floor that goes
 * away from the viewer, and the wall.
 */
export async function benches({ root }: ToolContext): Promise<readonly Bench[]> {
  const folder = await mkdtemp(join(tmpdir(), 'scrim-strokes-'));
  await writeFile(join(folder, 'depth.png'), await depthImage());
  const rivals = createRivals({ root, folder, base: projectOf('filter/copy'), shaders: { 'copy.fs': COPY }, rows: 2 * EFFECTS.length });
  const rows = EFFECTS.flatMap((type) =>
    racedBenches(rivals, {
      project: projectOf(type),
      ratio: { name: `frame, ${type} over a ball, against a plain copy`, of: ({ ours, base }) => ours / base },
      frame: `frame, ${type} over a ball`,
    }),
  );
  const load = machineLoad('drawings on the room');
  return [...rows, { ...load, dispose: () => rm(folder, { recursive: true, force: true }) }];
}

/** White is nearest: a floor that ends at the middle, the back wall above it, and a near wall at the left. */
function depthImage(): Promise<Uint8Array> {
  const [width, height] = SIZE_PX;
  const data = Uint8Array.from({ length: width * height }, (_, i) => {
    const [x, y] = [i % width, Math.floor(i / width)];
    return x < width / 2 ? 220 : Math.max(60, 60 + 3 * (y - height / 2));
  });
  return sharp(data, { raw: { width, height, channels: 1 } })
    .png()
    .toBuffer();
}

/** A ball on nothing whose layer goes through the effect to the screen. */
function projectOf(type: string): object {
  const { inputs = {} } = LIBRARY.definition(type) ?? {};
  const node = (of: string, params: object = {}) => ({ type: of, version: LIBRARY.definition(of)?.version ?? 1, params });
  return {
    format: 'scrim-project',
    version: 1,
    title: type,
    graphs: {
      main: {
        nodes: {
          'ball-0000': node('objects/primitive', { shape: 'sphere', sizeM: [1.6, 1.6, 1.6] }),
          'sun-0000': node('light/directional'),
          'scene-0000': node('layer/scene'),
          'depth-0000': node('world/depth', { source: 'picture', picture: 'depth', shades: 'inverse' }),
          'effect-0000': node(type),
          'screen-0000': node('output/screen'),
        },
        wires: [
          'ball-0000.objects -> scene-0000.objects',
          'sun-0000.lights -> scene-0000.lights',
          'scene-0000.layer -> effect-0000.inputImage',
          ...('room' in inputs ? ['depth-0000.depth -> effect-0000.room'] : []),
          ...('confidence' in inputs ? ['depth-0000.confidence -> effect-0000.confidence'] : []),
          'effect-0000.layer -> screen-0000.layer',
        ],
      },
    },
    assets: { depth: { path: 'depth.png', kind: 'image' } },
  };
}
