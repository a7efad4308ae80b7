import type { ExportReport } from '../../../export/bundle/report.ts';
import { hasErrors } from '../../../nodes/kit/diagnostics.ts';
import { compileProject } from '../../services/compile-project.ts';
import { exportProject } from '../../services/export-project.ts';
import { NODE_FILES } from '../../services/file-layer.ts';
import { findProject } from '../../services/project-files.ts';
import { readConsistentFiles } from '../../services/recover-folder.ts';
import { type Command, failed, UsageError } from '../command.ts';
import { drawPoster } from '../render/draw-poster.ts';
import { askDriver, NO_DRIVER_OPTION } from '../shader/ask-driver.ts';

export const exportCommand: Command = {
  name: 'export',
  usage: 'PROJECT --out DIR',
  summary: 'Export a project as a web page',
  doc: 'Compiles PROJECT and writes a static page to DIR: index.html and all its files, with relative addresses, for any web host. After one visit over https the page also opens offline. Compiles the project’s own shaders with a graphics driver first, in a headless browser: a shader that the driver rejects is an error; without a browser there is a warning. The browser also renders the poster, a frame that is shown while the page loads and in link previews: of what the project frames, else of its objects. DIR is replaced in one step, and only if it is missing, empty, or holds an earlier export; after an error it is unchanged. Models are compressed without visible loss: geometry with meshopt, textures with KTX2 where that saves graphics memory; the project’s .scrim folder caches the results. report.json in DIR lists the files, their sizes, each asset before and after, and the features that the page requests.',
  project: 'required',
  options: {
    out: { type: 'string', value: 'DIR', doc: 'Folder to write the page to.' },
    'single-file': {
      type: 'boolean',
      doc: 'Write one index.html that opens from a disk or a mail attachment. AR and the camera need a page on a web host, over https.',
    },
    'no-offline': { type: 'boolean', doc: 'Do not store the page for offline use. Each visit then loads it from the web host.' },
    url: {
      type: 'string',
      value: 'ADDRESS',
      doc: 'Address where the page will be published, such as https://example.org/robot/. Link previews need it to find the poster.',
    },
    'no-driver': NO_DRIVER_OPTION,
    'no-poster': { type: 'boolean', doc: 'Use a neutral poster instead of a rendered frame. Faster.' },
    'no-compress': { type: 'boolean', doc: 'Do not compress models and their textures. Faster, but the page is larger.' },
  },
  examples: [
    { line: 'scrim export my-project --out site', says: 'Writes the page to site/. Any static host can serve it, over https.' },
    { line: 'scrim export my-project --out draft --no-compress', says: 'Leaves models uncompressed, for a quick look.' },
    {
      line: 'scrim export my-project --out robot --single-file',
      says: 'Writes one file, robot/index.html, to send or to open with a double click.',
    },
    {
      line: 'scrim export my-project --out site --json',
      says: 'For a build: { ok, out, driver, report, diagnostics }; driver is yes, not-needed, not-wanted or no-browser.',
    },
  ],
  run: async (call, context) => {
    const { installation, say, interrupted } = context;
    const out = call.text('out');
    if (out === null || out === '') throw new UsageError('--out DIR is missing. Name the folder to write the page to.');
    const address = readAddress(call.text('url'));
    const root = await findProject(call.project);
    const files = await readConsistentFiles(root, NODE_FILES);
    const asked = await askDriver({ ...context, root, files, wanted: !call.flag('no-driver') });
    if (hasErrors(asked.diagnostics)) return failed(asked.diagnostics, files);
    const { report, diagnostics: found } = await exportProject({
      root,
      projectFiles: files,
      out,
      installation,
      interrupted,
      compress: !call.flag('no-compress'),
      say,
      singleFile: call.flag('single-file'),
      offline: !call.flag('no-offline'),
      address,
      ...(call.flag('no-poster')
        ? {}
        : {
            drawPoster: async (program, framing) => {
              say('Drawing the poster…');
              // The poster is compiled with source maps, so that driver errors name file and line.
              const mapped = await compileProject(root, files, () => ({ sourceMaps: true, fuse: true, fold: true }));
              return drawPoster({ program: mapped.program ?? program, framing, projectRoot: root, installation });
            },
          }),
    });
    const diagnostics = [...found, ...asked.diagnostics];
    if (report === null) return failed(diagnostics, files);
    const json = { ok: true, out, driver: asked.driver, report, diagnostics };
    return { status: 0, json, text: summary(out, report), diagnostics, files };
  },
};

function readAddress(text: string | null): string | null {
  if (text === null) return null;
  const url = URL.canParse(text) ? new URL(text) : null;
  if (!url || !/^https?:$/.test(url.protocol))
    throw new UsageError(`--url ${text} is not an address. Write one that begins with https://.`);
  return url.href.endsWith('/') ? url.href : `${url.href}/`;
}

function summary(out: string, { files, bytes, features, assets, gpuBytes }: ExportReport): string {
  const kinds = Object.entries(bytes.byKind).map(
    ([kind, { raw, gzip }]) => `  ${kind.padEnd(8)} ${kilobytes(raw)}, ${kilobytes(gzip)} gzip`,
  );
  const asked = [...features.required.map((feature) => `${feature} (required)`), ...features.optional];
  return [
    `${files.length} files in ${out}: ${kilobytes(bytes.raw)}, ${kilobytes(bytes.gzip)} gzip`,
    ...kinds,
    ...compressionLines(assets),
    ...placeLines(gpuBytes),
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

function placeLines({ places }: ExportReport['gpuBytes']): string[] {
  if (places === null) return [];
  const { onPhones, phoneLimit, onComputers } = places;
  const there = `${megabytes(onPhones)} of ${megabytes(phoneLimit)} MB on phones and headsets`;
  return [`Captures and splats in graphics memory: about ${there}, ${megabytes(onComputers)} MB on computers.`];
}

function megabytes(bytes: number): string {
  return (bytes / 1e6).toFixed(1);
}

function kilobytes(bytes: number): string {
  return `${(bytes / 1000).toFixed(1)} kB`;
}
