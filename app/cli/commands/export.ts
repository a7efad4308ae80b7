import type { ExportReport } from '../../../export/bundle/report.ts';
import { exportProject } from '../../services/export-project.ts';
import { findProject, readProjectFiles } from '../../services/project-files.ts';
import { type Command, failed, UsageError } from '../command.ts';

export const exportCommand: Command = {
  name: 'export',
  usage: 'PROJECT --out DIR',
  summary: 'Make the web page of a project',
  doc: 'Compiles PROJECT and writes it into DIR as a static page: index.html and all it needs, with relative addresses, for any web host. DIR is replaced in one step, and only where it is missing, empty, or holds an earlier export; with any error it stays as it was. report.json in it lists the files, their bytes, and what a visitor’s device is asked for.',
  project: 'required',
  options: { out: { type: 'string', value: 'DIR', doc: 'Where the page goes.' } },
  examples: [
    { line: 'scrim export my-project --out site', says: 'Writes the page to site/. Any static host can serve it, over https.' },
    { line: 'scrim export my-project --out site --json', says: 'For a build: { ok, out, report, diagnostics }.' },
  ],
  run: async (call, { installation, say }) => {
    const out = call.text('out');
    if (out === null || out === '') throw new UsageError('--out DIR is missing: where the page goes.');
    const root = await findProject(call.project);
    const projectFiles = await readProjectFiles(root);
    say('Compiling and bundling…');
    const { report, diagnostics } = await exportProject({ root, projectFiles, out, installation });
    if (report === null) return failed(diagnostics);
    return { status: 0, json: { ok: true, out, report, diagnostics }, text: summary(out, report), diagnostics };
  },
};

function summary(out: string, { files, bytes, features }: ExportReport): string {
  const kinds = Object.entries(bytes.byKind).map(
    ([kind, { raw, gzip }]) => `  ${kind.padEnd(8)} ${kilobytes(raw)}, ${kilobytes(gzip)} gzip`,
  );
  const asked = [...features.required.map((feature) => `${feature} (required)`), ...features.optional];
  return [
    `${files.length} files in ${out}: ${kilobytes(bytes.raw)}, ${kilobytes(bytes.gzip)} gzip`,
    ...kinds,
    `Asks the browser for ${asked.join(', ')}.`,
  ].join('\n');
}

function kilobytes(bytes: number): string {
  return `${(bytes / 1000).toFixed(1)} kB`;
}
