import type { Diagnostic, Result } from '../../nodes/kit/diagnostics.ts';
import { asksOf } from '../page/needs-text.ts';
import { pageHtml } from '../page/page-html.ts';
import type { Program, ProgramAsset } from '../program/program.ts';
import { bundleScript, bundleStyle, type Script } from './bundle-script.ts';
import type { FileSink } from './file-sink.ts';
import { hashedName } from './hashed-name.ts';
import { type ProgramUse, programUse } from './program-use.ts';
import { type ExportReport, type FileKind, makeReport, REPORT_FILE, type ReportedFile, sizesOf } from './report.ts';
import { webXrFeatures } from './webxr-features.ts';

export interface BundleInput {
  readonly program: Program;
  readonly page: { readonly description: string; readonly language: string };
  /** Names and versions whoever made the page: `Scrim 0.1.0`. */
  readonly generator: string;
  /** Absolute folder with Scrim's sources and `node_modules`. */
  readonly root: string;
  /** Bytes of an asset by its project path. Rejects with an `Error` that says in plain words why there are none. */
  readonly readAsset: (path: string) => Promise<Uint8Array>;
  readonly sink: FileSink;
}

/**
 * A program as a static page: `index.html`, one script, one style sheet, the program, its assets, and `report.json`. The same
 * input gives the same bytes. Assets that cannot be read are SCR030, sources that cannot be bundled SCR064; the sink then has
 * been given nothing.
 */
export async function bundlePage(input: BundleInput): Promise<Result<ExportReport>> {
  const use = programUse(input.program);
  const assets = await readAssets(input, use);
  if (assets.output === null) return { output: null, diagnostics: assets.diagnostics };
  let code: Code;
  try {
    code = { script: await bundleScript(input.root, use), style: await bundleStyle(input.root) };
  } catch (error) {
    const message = `The page could not be bundled: ${error instanceof Error ? error.message : String(error)}`;
    return { output: null, diagnostics: [{ code: 'SCR064', severity: 'error', message }] };
  }
  const files = await writeFiles(input, code, assets.output);
  const report = makeReport({
    program: input.program,
    generator: input.generator,
    files,
    scriptParts: code.script.parts,
    features: webXrFeatures(input.program.needs),
  });
  await input.sink.write(REPORT_FILE, toBytes(`${JSON.stringify(report, null, 2)}\n`));
  return { output: report, diagnostics: [] };
}

interface Code {
  readonly script: Script;
  readonly style: Uint8Array;
}

interface ReadAsset {
  readonly asset: ProgramAsset;
  readonly path: string;
  readonly bytes: Uint8Array;
}

async function readAssets({ program, readAsset }: BundleInput, use: ProgramUse): Promise<Result<readonly ReadAsset[]>> {
  const read: ReadAsset[] = [];
  const diagnostics: Diagnostic[] = [];
  for (const asset of program.assets.filter(({ id }) => use.assets.has(id))) {
    try {
      const bytes = await readAsset(asset.path);
      read.push({ asset, bytes, path: hashedName(`assets/${fileName(asset.path)}`, bytes) });
    } catch (error) {
      const message = `${asset.path} cannot be read: ${error instanceof Error ? error.message : String(error)}`;
      diagnostics.push({ code: 'SCR030', severity: 'error', message, file: asset.path });
    }
  }
  return { output: diagnostics.length === 0 ? read : null, diagnostics };
}

async function writeFiles(input: BundleInput, { script, style }: Code, assets: readonly ReadAsset[]): Promise<ReportedFile[]> {
  const files: ReportedFile[] = [];
  const write = async (path: string, kind: FileKind, bytes: Uint8Array): Promise<string> => {
    // Two assets may be one file.
    if (files.some((file) => file.path === path)) return path;
    await input.sink.write(path, bytes);
    files.push({ path, kind, ...sizesOf(bytes) });
    return path;
  };
  const writeHashed = (path: string, kind: FileKind, bytes: Uint8Array) => write(hashedName(path, bytes), kind, bytes);

  for (const { asset, path, bytes } of assets) await write(path, asset.kind, bytes);
  const program = toBytes(JSON.stringify(exportedProgram(input.program, assets)));
  const programPath = await writeHashed('program.json', 'program', program);
  const scriptPath = await writeHashed('page.js', 'script', script.bytes);
  const stylePath = await writeHashed('page.css', 'style', style);
  const bytes = Object.fromEntries([[programPath, program.length], ...assets.map((a) => [a.path, a.bytes.length] as const)]);
  const html = pageHtml({
    title: input.program.title,
    ...input.page,
    script: scriptPath,
    style: stylePath,
    config: {
      title: input.program.title,
      description: input.page.description,
      asks: asksOf(input.program.needs),
      program: programPath,
      bytes,
    },
  });
  await write('index.html', 'page', toBytes(html));
  return files.sort((a, b) => (a.path < b.path ? -1 : 1));
}

/** Without what only the editor looks at: source maps, taps, and assets that nothing uses. */
function exportedProgram(program: Program, assets: readonly ReadAsset[]): Program {
  return {
    ...program,
    shaders: program.shaders.map(({ id, vertex, fragment }) => ({ id, vertex, fragment })),
    assets: assets.map(({ asset, path }) => ({ ...asset, path })),
    taps: {},
  };
}

/** Letters that every host and every file system carries unchanged. */
function fileName(path: string): string {
  return path.slice(path.lastIndexOf('/') + 1).replace(/[^A-Za-z0-9._-]+/g, '-');
}

function toBytes(text: string): Uint8Array {
  return new TextEncoder().encode(text);
}
