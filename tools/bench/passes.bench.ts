import { join } from 'node:path';
import { compileProject } from '../../app/services/compile-project.ts';
import { readProjectFiles } from '../../app/services/project-files.ts';
import type { Program } from '../../export/program/program.ts';
import { exampleNames } from '../lib/example-names.ts';
import type { ToolContext } from '../lib/tool.ts';
import type { Bench } from './bench.ts';
import { type FrameTraffic, frameTraffic } from './frame-traffic.ts';

const SIZE = { widthPx: 1280, heightPx: 720 } as const;

const FIGURES: readonly (readonly [name: string, unit: Bench['unit'], of: (traffic: FrameTraffic) => number])[] = [
  ['passes', 'count', ({ passes }) => passes],
  ['targets', 'count', ({ targets }) => targets],
  ['bytes of targets', 'kB', ({ targetBytes }) => targetBytes / 1000],
  ['bytes read per frame', 'kB', ({ readBytes }) => readBytes / 1000],
  ['bytes written per frame', 'kB', ({ writtenBytes }) => writtenBytes / 1000],
];

/**
 * Passes, targets and bytes of a frame of 1280 × 720 pixels of every example of which fusion changes any, with fusion and without. They are
 * computed from the programs, so they are the same on every machine.
 */
export async function benches({ root }: ToolContext): Promise<readonly Bench[]> {
  const examples = join(root, 'examples');
  const rows: Bench[] = [];
  for (const name of await exampleNames(root)) {
    const fused = frameTraffic(await compiled(join(examples, name), true), SIZE);
    const separate = frameTraffic(await compiled(join(examples, name), false), SIZE);
    if (separate.passes === fused.passes) continue;
    for (const [figure, unit, of] of FIGURES) {
      rows.push(constant(`${figure}, ${name}, fused`, unit, of(fused)), constant(`${figure}, ${name}, not fused`, unit, of(separate)));
    }
  }
  return rows;
}

function constant(name: string, unit: Bench['unit'], value: number): Bench {
  return { name, unit, samples: 1, sample: () => value };
}

async function compiled(folder: string, fuse: boolean): Promise<Program> {
  const { program, diagnostics } = await compileProject(folder, await readProjectFiles(folder), () => ({ sourceMaps: false, fuse }));
  if (program === null) throw new Error(`${folder} does not compile: ${JSON.stringify(diagnostics)}`);
  return program;
}
