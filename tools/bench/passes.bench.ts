import { join } from 'node:path';
import { readProjectFiles } from '../../app/services/project-files.ts';
import type { Program } from '../../export/program/program.ts';
import { exampleNames } from '../lib/example-names.ts';
import type { ToolContext } from '../lib/tool.ts';
import type { Bench } from './bench.ts';
import { compiledProgram } from './compiled-program.ts';
import { filteredObjects, filteredProject } from './filtered-project.ts';
import { type FrameTraffic, frameTraffic } from './frame-traffic.ts';

const SIZE = { widthPx: 1280, heightPx: 720 } as const;

const FIGURES: readonly (readonly [name: string, unit: Bench['unit'], of: (traffic: FrameTraffic) => number])[] = [
  ['passes', 'count', ({ passes }) => passes],
  ['targets', 'count', ({ targets }) => targets],
  ['bytes of targets', 'kB', ({ targetBytes }) => targetBytes / 1000],
  ['bytes read per frame', 'kB', ({ readBytes }) => readBytes / 1000],
  ['bytes written per frame', 'kB', ({ writtenBytes }) => writtenBytes / 1000],
  ['draws of objects', 'count', ({ draws }) => draws],
  ['bytes written per frame by draws of objects', 'kB', ({ drawnBytes }) => drawnBytes / 1000],
  ['bytes read per frame to resolve samples', 'kB', ({ resolvedBytes }) => resolvedBytes / 1000],
  ['bytes of the depth of the screen', 'kB', ({ screenDepthBytes }) => screenDepthBytes / 1000],
];

/**
 * Passes, draws of objects, targets and bytes of a frame of 1280 × 720 pixels of every example, with fusion and without; also of figure 11 of the paper with a
 * filter over all of it, and of objects with filters, without antialiasing. They are computed from the programs, so they are the same on every machine.
 */
export async function benches({ root }: ToolContext): Promise<readonly Bench[]> {
  const examples = join(root, 'examples');
  const rows: Bench[] = [];
  const subjects = (await exampleNames(root)).map((name) => ({ name, folder: join(examples, name), change: (text: string) => text }));
  const figure = { name: 'sketchy-shadow with a filter over all', folder: join(examples, 'sketchy-shadow'), change: filteredProject };
  const objects = {
    name: 'shadows-of-real-and-virtual-things with two filters over its objects, without antialiasing',
    folder: join(examples, 'shadows-of-real-and-virtual-things'),
    change: (text: string) => filteredObjects(text, 'scene-f6.layer'),
  };
  for (const { name, folder, change } of [...subjects, figure, objects]) {
    const fused = frameTraffic(await compiled(folder, change, true), SIZE);
    const separate = frameTraffic(await compiled(folder, change, false), SIZE);
    for (const [figure, unit, of] of FIGURES) {
      rows.push(constant(`${figure}, ${name}, fused`, unit, of(fused)), constant(`${figure}, ${name}, not fused`, unit, of(separate)));
    }
  }
  return rows;
}

function constant(name: string, unit: Bench['unit'], value: number): Bench {
  return { name, unit, samples: 1, sample: () => value };
}

async function compiled(folder: string, change: (text: string) => string, fuse: boolean): Promise<Program> {
  const files = await readProjectFiles(folder);
  return compiledProgram(folder, { ...files, project: change(files.project) }, { fuse });
}
