import { join } from 'node:path';
import { listFiles } from '../lib/files.ts';
import type { ToolContext } from '../lib/tool.ts';
import type { Bench } from './bench.ts';
import { machineLoad } from './machine-load.ts';
import { createRivals, racedBenches } from './rivals.ts';

/**
 * Measures frames with a large ball and its shadow on a floor, with each technique of the library: milliseconds, and the ratio to the same
 * objects with their own materials.
 */
export async function benches({ root }: ToolContext): Promise<readonly Bench[]> {
  const files = await listFiles(join(root, 'shader-library', 'techniques'));
  const folder = join(root, 'examples', 'first-light');
  const rivals = createRivals({ root, folder, base: ballProject(null), rows: 2 * files.length });
  const raced = files.flatMap((file) => {
    const name = file.replace('.glsl', '');
    return racedBenches(rivals, {
      project: ballProject(`technique/${name}`),
      ratio: { name: `frame, technique ${name}, against own materials`, of: ({ ours, base }) => ours / base },
      frame: `frame, technique ${name}`,
    });
  });
  return [...raced, machineLoad('techniques')];
}

function ballProject(technique: string | null): object {
  const styled = technique === null ? 'every-0000' : 'apply-0000';
  return {
    format: 'scrim-project',
    version: 1,
    title: 'A ball',
    graphs: {
      main: {
        nodes: {
          'ball-0000': { type: 'objects/primitive', version: 1, params: { shape: 'sphere', sizeM: [1.6, 1.6, 1.6] } },
          'floor-0000': { type: 'objects/primitive', version: 1, params: { shape: 'plane', sizeM: [5, 0, 5] } },
          'every-0000': { type: 'objects/group', version: 1 },
          'sun-0000': { type: 'light/directional', version: 1 },
          'scene-0000': { type: 'layer/scene', version: 1 },
          'screen-0000': { type: 'output/screen', version: 1 },
          ...(technique !== null && {
            'style-0000': { type: technique, version: 1 },
            'apply-0000': { type: 'objects/apply-technique', version: 1 },
          }),
        },
        wires: [
          'ball-0000.objects -> every-0000.objects',
          'floor-0000.objects -> every-0000.objects',
          ...(technique === null ? [] : ['every-0000.objects -> apply-0000.objects', 'style-0000.technique -> apply-0000.technique']),
          `${styled}.objects -> scene-0000.objects`,
          'sun-0000.lights -> scene-0000.lights',
          'scene-0000.layer -> screen-0000.layer',
        ],
      },
    },
  };
}
