import type { ExportReport } from '../../../export/bundle/report.ts';
import { hasErrors } from '../../../nodes/kit/diagnostics.ts';
import { compileProject } from '../../services/compile-project.ts';
import { exportProject } from '../../services/export-project.ts';
import { NODE_FILES } from '../../services/file-layer.ts';
import { findProject } from '../../services/project-files.ts';
import { readSettled } from '../../services/settle.ts';
import { type Command, failed, UsageError } from '../command.ts';
import { drawPoster } from '../render/draw-poster.ts';
import { askDriver, NO_DRIVER_OPTION } from '../shader/ask-driver.ts';

export const exportCommand: Command = {
  name: 'export',
  usage: 'PROJECT --out DIR',
  summary: 'Make the web page of a project',
  doc: 'Compiles PROJECT and writes it into DIR as a static page: index.html and all it needs, with relative addresses, for any web host; visited once over https, it opens without a connection, too. Shaders of the project’s own are compiled by a graphics driver first, in a headless browser where there is one: what it refuses is an error, and a warning says where there was none to ask. A frame of the page, drawn in a headless browser where there is one, is its poster: shown while it loads, and by those who link to it. DIR is replaced in one step, and only where it is missing, empty, or holds an earlier export; with any error it stays as it was. Models are compressed without anything to see: geometry with meshopt, textures with KTX2 where that saves graphics memory; what that took is kept in the project’s .scrim folder for the next time. report.json in it lists the files, their bytes, each asset’s before and after, and what a visitor’s device is asked for.',
  project: 'required',
  options: {
    out: { type: 'string', value: 'DIR', doc: 'Where the page goes.' },
    'single-file': {
      type: 'boolean',
      doc: 'Everything in one index.html, which opens by a double click, by mail or from a disk. AR and the camera need a page on a host, over https.',
    },
    url: {
      type: 'string',
      value: 'ADDRESS',
      doc: 'Where the page will be published, such as https://example.org/robot/: those who show links to it find its poster by that.',
    },
    'no-driver': NO_DRIVER_OPTION,
    'no-poster': { type: 'boolean', doc: 'A neutral picture instead of a frame, made at once.' },
    'no-compress': { type: 'boolean', doc: 'Models as they are, textures too: larger, but made at once.' },
  },
  examples: [
    { line: 'scrim export my-project --out site', says: 'Writes the page to site/. Any static host can serve it, over https.' },
    { line: 'scrim export my-project --out draft --no-compress', says: 'Leaves models uncompressed, for a quick look.' },
    {
      line: 'scrim export my-project --out robot --single-file',
      says: 'One file, robot/index.html, to send or to open by a double click.',
    },
    {
      line: 'scrim export my-project --out site --json',
      says: 'For a build: { ok, out, driver, report, diagnostics }; driver is yes, not-needed, not-wanted or no-browser.',
    },
  ],
  run: async (call, context) => {
    const { installation, say, interrupted } = context;
    const out = call.text('out');
    if (out === null || out === '') throw new UsageError('--out DIR is missing: where the page goes.');
    const address = readAddress(call.text('url'));
    const root = await findProject(call.project);
    const projectFiles = await readSettled(root, NODE_FILES);
    const asked = await askDriver({ ...context, root, files: projectFiles, wanted: !call.flag('no-driver') });
    if (hasErrors(asked.diagnostics)) return failed(asked.diagnostics);
    const { report, diagnostics: found } = await exportProject({
      root,
      projectFiles,
      out,
      installation,
      interrupted,
      compress: !call.flag('no-compress'),
      say,
      singleFile: call.flag('single-file'),
      address,
      ...(call.flag('no-poster')
        ? {}
        : {
            drawPoster: async (program) => {
              say('Drawing the poster…');
              // With source maps, which the page does without: a shader that a driver refuses is told of by its file and line.
              const mapped = await compileProject(root, projectFiles, () => ({ sourceMaps: true }));
              return drawPoster({ program: mapped.program ?? program, projectRoot: root, installation });
            },
          }),
    });
    const diagnostics = [...found, ...asked.diagnostics];
    if (report === null) return failed(diagnostics);
    return { status: 0, json: { ok: true, out, driver: asked.driver, report, diagnostics }, text: summary(out, report), diagnostics };
  },
};

function readAddress(text: string | null): string | null {
  if (text === null) return null;
  const url = URL.canParse(text) ? new URL(text) : null;
  if (!url || !/^https?:$/.test(url.protocol)) throw new UsageError(`--url ${text} is no address: it begins with https://.`);
  return url.href.endsWith('/') ? url.href : `${url.href}/`;
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
