import { mkdtemp, rm } from 'node:fs/promises';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { exportProject } from '../../app/services/export-project.ts';
import { installationAt } from '../../app/services/installation.ts';
import { readProjectFiles } from '../../app/services/project-files.ts';
import type { ExportReport } from '../../export/bundle/report.ts';
import type { ToolContext } from '../lib/tool.ts';
import { type ScriptWeights, weighScripts } from './bare-page.ts';
import { type Bench, timeMs } from './bench.ts';

/** Duration of an export, and the size of its script beside that of a page that does the same in plain three.js, bundled the same way. */
export async function benches({ root }: ToolContext): Promise<readonly Bench[]> {
  const base = await mkdtemp(join(tmpdir(), 'scrim-bench-'));
  const folder = join(root, 'examples', 'first-light');
  const installation = installationAt(root, '0.0.0');
  let pages = 0;
  const exportPage = async (): Promise<ExportReport> => {
    const projectFiles = await readProjectFiles(folder);
    const { report } = await exportProject({ root: folder, projectFiles, out: join(base, `page-${pages++}`), installation });
    if (report === null) throw new Error('The first example cannot be exported.');
    return report;
  };
  let weights: Promise<ScriptWeights> | undefined;
  const weight = (name: string, unit: Bench['unit'], of: (weights: ScriptWeights) => number): Bench => ({
    name: `page script, first-light${name}`,
    unit,
    samples: 1,
    sample: async () => {
      weights ??= weighScripts(root, folder);
      return of(await weights);
    },
  });
  return [
    {
      name: 'export, first-light',
      unit: 'ms',
      samples: 5,
      sample: () => timeMs(exportPage),
      dispose: () => rm(base, { recursive: true, force: true }),
    },
    weight('', 'kB', ({ all }) => all.raw / 1000),
    weight(', gzip', 'kB', ({ all }) => all.gzip / 1000),
    weight(', before the first image, gzip', 'kB', ({ first }) => first.gzip / 1000),
    weight(', with all of three.js, gzip', 'kB', ({ wholeThree }) => wholeThree.gzip / 1000),
    weight(' as a bare page, gzip', 'kB', ({ bare }) => bare.gzip / 1000),
    weight(', gzip, against the bare page', 'ratio', ({ all, bare }) => all.gzip / bare.gzip),
    weight(', before the first image, gzip, against the bare page', 'ratio', ({ first, bare }) => first.gzip / bare.gzip),
    weight(', with all of three.js, gzip, against the bare page', 'ratio', ({ wholeThree, bare }) => wholeThree.gzip / bare.gzip),
  ];
}
