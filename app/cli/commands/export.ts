import type { ExportReport } from '../../../export/bundle/report.ts';
import { exportProject } from '../../services/export-project.ts';
import { type FileLayer, NODE_FILES } from '../../services/file-layer.ts';
import { findProject, readProjectFiles } from '../../services/project-files.ts';
import { type Command, failed, UsageError } from '../command.ts';

export const exportCommand: Command = {
  name: 'export',
  usage: 'PROJECT --out DIR',
  summary: 'Make the web page of a project',
  doc: 'Compiles PROJECT and writes it into DIR as a static page: index.html and all it needs, with relative addresses, for any web host. DIR is replaced in one step, and only where it is missing, empty, or holds an earlier export; with any error it stays as it was. Models are compressed without anything to see: geometry with meshopt, textures with KTX2 where that saves graphics memory; what that took is kept in the project’s .scrim folder for the next time. report.json in it lists the files, their bytes, each asset’s before and after, and what a visitor’s device is asked for.',
  project: 'required',
  options: {
    out: { type: 'string', value: 'DIR', doc: 'Where the page goes.' },
    'no-compress': { type: 'boolean', doc: 'Models as they are, textures too: larger, but made at once.' },
  },
  examples: [
    { line: 'scrim export my-project --out site', says: 'Writes the page to site/. Any static host can serve it, over https.' },
    { line: 'scrim export my-project --out draft --no-compress', says: 'Leaves models uncompressed, for a quick look.' },
    { line: 'scrim export my-project --out site --json', says: 'For a build: { ok, out, report, diagnostics }.' },
  ],
  run: async (call, { installation, say, interrupted }) => {
    const out = call.text('out');
    if (out === null || out === '') throw new UsageError('--out DIR is missing: where the page goes.');
    const root = await findProject(call.project);
    const projectFiles = await readProjectFiles(root);
    say('Compiling and bundling…');
    const files = watchedFiles(interrupted, (count) => say(`Writing file ${count}…`));
    const { report, diagnostics } = await exportProject({
      root,
      projectFiles,
      out,
      installation,
      files,
      compress: !call.flag('no-compress'),
      say,
    });
    if (report === null) return failed(diagnostics);
    return { status: 0, json: { ok: true, out, report, diagnostics }, text: summary(out, report), diagnostics };
  },
};

/**
 * Files that tell how many were written, and refuse to write more once the person has had enough: the page's folder is then taken
 * back as on a full disk. Renames go on, because half of two is worse than both.
 */
function watchedFiles(interrupted: AbortSignal, onWrite: (count: number) => void): FileLayer {
  let count = 0;
  return {
    ...NODE_FILES,
    writeNew: async (path, bytes) => {
      interrupted.throwIfAborted();
      onWrite(++count);
      await NODE_FILES.writeNew(path, bytes);
    },
    makeFolder: async (path) => {
      interrupted.throwIfAborted();
      await NODE_FILES.makeFolder(path);
    },
  };
}

function summary(out: string, { files, bytes, features, assets }: ExportReport): string {
  const kinds = Object.entries(bytes.byKind).map(
    ([kind, { raw, gzip }]) => `  ${kind.padEnd(8)} ${kilobytes(raw)}, ${kilobytes(gzip)} gzip`,
  );
  const asked = [...features.required.map((feature) => `${feature} (required)`), ...features.optional];
  return [
    `${files.length} files in ${out}: ${kilobytes(bytes.raw)}, ${kilobytes(bytes.gzip)} gzip`,
    ...kinds,
    ...compressionLines(assets),
    `Asks the browser for ${asked.join(', ')}.`,
  ].join('\n');
}

function compressionLines(assets: ExportReport['assets']): string[] {
  const compressed = assets.filter(({ form }) => form !== 'original');
  if (compressed.length === 0) return [];
  const sum = (of: (asset: ExportReport['assets'][number]) => number) =>
    kilobytes(compressed.reduce((total, asset) => total + of(asset), 0));
  const [file, gpu] = (['fileBytes', 'gpuBytes'] as const).map((what) => `${sum((a) => a[what].before)} → ${sum((a) => a[what].after)}`);
  return [`Compressed ${compressed.length === 1 ? 'one model' : `${compressed.length} models`}: ${file}; in graphics memory about ${gpu}.`];
}

function kilobytes(bytes: number): string {
  return `${(bytes / 1000).toFixed(1)} kB`;
}
