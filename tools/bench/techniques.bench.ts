import { join } from 'node:path';
import { listFiles } from '../lib/files.ts';
import type { ToolContext } from '../lib/tool.ts';
import type { Bench } from './bench.ts';
import { machineLoad } from './machine-load.ts';
import { createRivals, racedBenches } from './rivals.ts';

/**
 * Measures frames with a large ball and its shadow on a floor, with each technique of the library: milliseconds, and the ratio to the same
 * objects with their own materials. Glass is also measured on the ball alone: through a glass ball before a glass floor, the floor is
 * drawn twice (ADR 41).
 */
export async function benches({ root }: ToolContext): Promise<readonly Bench[]> {
  const files = await listFiles(join(root, 'shader-library', 'techniques'));
  const folder = join(root, 'examples', 'first-light');
  const rivals = createRivals({ root, folder, base: ballProject(null), rows: 2 * files.length + 2 });
  const row = (what: string, project: object) =>
    racedBenches(rivals, {
      project,
      ratio: { name: `frame, technique ${what}, against own materials`, of: ({ ours, base }) => ours / base },
      frame: `frame, technique ${what}`,
    });
  const raced = files.flatMap((file) => {
    const name = file.replace('.glsl', '');
    return row(name, ballProject(`technique/${name}`));
  });
  raced.push(...row('glass on the ball alone', ballProject('technique/glass', true)));
  return [...raced, machineLoad('techniques')];
}

/** @param isBallAlone Whether the floor keeps its own material. */
function ballProject(technique: string | null, isBallAlone = false): object {
  const styled = technique === null || isBallAlone ? 'every-0000' : 'apply-0000';
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
          `${technique !== null && isBallAlone ? 'apply' : 'ball'}-0000.objects -> every-0000.objects`,
          'floor-0000.objects -> every-0000.objects',
          ...(technique === null
            ? []
            : [`${isBallAlone ? 'ball' : 'every'}-0000.objects -> apply-0000.objects`, 'style-0000.technique -> apply-0000.technique']),
          `${styled}.objects -> scene-0000.objects`,
          'sun-0000.lights -> scene-0000.lights',
          'scene-0000.layer -> screen-0000.layer',
        ],
      },
    },
  };
}
