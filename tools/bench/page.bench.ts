import { mkdtemp, rm } from 'node:fs/promises';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { gzipSync } from 'node:zlib';
import { build } from 'esbuild';
import { exportProject } from '../../app/services/export-project.ts';
import { installationAt } from '../../app/services/installation.ts';
import { readProjectFiles } from '../../app/services/project-files.ts';
import type { ExportReport, Sizes } from '../../export/bundle/report.ts';
import type { ToolContext } from '../lib/tool.ts';
import { type Bench, timeMs } from './bench.ts';

/** Duration of an export, and the size of its script compared with a hand-written three.js page, bundled the same way. */
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
  let scripts: Promise<{ readonly ours: Sizes; readonly theirs: Sizes }> | undefined;
  const weigh = () => {
    scripts ??= (async () => {
      const { bytes } = await exportPage();
      return { ours: bytes.byKind.script ?? { raw: 0, gzip: 0 }, theirs: await bundleThree(root) };
    })();
    return scripts;
  };
  const weight = (name: string, unit: Bench['unit'], of: (w: Awaited<ReturnType<typeof weigh>>) => number): Bench => ({
    name,
    unit,
    samples: 1,
    sample: async () => of(await weigh()),
  });
  return [
    { name: 'export, first-light', unit: 'ms', samples: 5, sample: () => timeMs(exportPage) },
    weight('page script, first-light', 'kB', ({ ours }) => ours.raw / 1000),
    weight('page script, first-light, gzip', 'kB', ({ ours }) => ours.gzip / 1000),
    weight('page script, first-light, against three.js alone', 'ratio', ({ ours, theirs }) => ours.raw / theirs.raw),
    {
      ...weight('page script, first-light, gzip, against three.js alone', 'ratio', ({ ours, theirs }) => ours.gzip / theirs.gzip),
      dispose: () => rm(base, { recursive: true, force: true }),
    },
  ];
}

/** Bundles the hand-written three.js page as `export/bundle` bundles pages. Returns its size. */
async function bundleThree(root: string): Promise<Sizes> {
  const { outputFiles } = await build({
    entryPoints: [join(root, 'tools/bench/pages/three.page.ts')],
    absWorkingDir: root,
    bundle: true,
    write: false,
    minify: true,
    format: 'iife',
    globalName: 'bare',
    platform: 'browser',
    target: 'es2022',
    charset: 'utf8',
    legalComments: 'eof',
    logLevel: 'silent',
  });
  const bytes = outputFiles[0]?.contents ?? new Uint8Array();
  return { raw: bytes.length, gzip: gzipSync(bytes, { level: 9 }).length };
}
