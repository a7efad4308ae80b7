import type { Diagnostic, Result } from '../../nodes/kit/diagnostics.ts';
import { asksOf } from '../page/needs-text.ts';
import type { Program, ProgramAsset } from '../program/program.ts';
import { webXrFeatures } from '../program/webxr-features.ts';
import type { AssetCache } from './assets/model-cache.ts';
import { type PreparedAssets, prepareAssets } from './assets/prepare-assets.ts';
import type { PreparedAsset } from './assets/prepared-asset.ts';
import { bundleScripts, bundleStyle, type Scripts } from './bundle-page-script.ts';
import { hashedName } from './hashed-name.ts';
import { storeLamps } from './lamps/store-lamps.ts';
import { LICENCES_FILE, licencesText, licenceWarnings, type PageCredit, pageCredits } from './page-credits.ts';
import type { PageUse } from './page-entry.ts';
import { layOutFiles, layOutSingleFile, type PageFile, toBytes } from './page-layout.ts';
import { neutralPoster, type PosterImage } from './poster.ts';
import { programUse } from './program-use.ts';
import { type ExportReport, makeReport, REPORT_FILE, type ReportedFile, sizesOf } from './report.ts';

/** Receives the files of a page. Paths are relative with `/` between folders; each is written once. */
export interface FileSink {
  write(path: string, bytes: Uint8Array): Promise<void>;
}

export interface BundleInput {
  readonly program: Program;
  readonly page: { readonly description: string; readonly language: string };
  /** Name and version of the exporting program, as in `Scrim 0.1.0`. */
  readonly generator: string;
  /** Absolute path of the folder with Scrim's sources and `node_modules`. */
  readonly root: string;
  /** Reads an asset by its project path. Rejects with an `Error` whose message is text for the user. */
  readonly readAsset: (path: string) => Promise<Uint8Array>;
  readonly sink: FileSink;
  /** Whether to compress models. Default: true. */
  readonly compress?: boolean;
  /** Stores compressed models between exports. */
  readonly cache?: AssetCache;
  /** Receives progress texts. */
  readonly say?: (text: string) => void;
  /** Draws an image of the project of size `POSTER_SIZE`, after the assets have been checked. Default, and for null: a neutral one. */
  readonly drawPoster?: () => Promise<PosterImage | null>;
  /** Whether `index.html` contains everything, so that it opens without a server. */
  readonly singleFile?: boolean;
  /** Whether the page stores its files, so that it opens offline after a visit. A single file never does. Default: true. */
  readonly offline?: boolean;
  /** Address of the published page, ending in `/`, because link previews require absolute URLs. */
  readonly address?: string | null;
}

/**
 * Exports a program as a static page: `index.html`, a script, a style sheet, the program, its assets, a poster, a service worker and
 * `report.json`. The same input gives the same bytes.
 *
 * @returns The report; or null and nothing written, with SCR030 for unreadable assets or SCR064 if the sources cannot be bundled.
 *
 * @example
 * const { output: report, diagnostics } = await bundlePage({ program, page, generator: 'Scrim 0.1.0', root, readAsset, sink });
 */
export async function bundlePage(input: BundleInput): Promise<Result<ExportReport>> {
  const { root, readAsset, compress = true, cache = null, say = () => {} } = input;
  const { assets: usedIds, techniqueEdges } = programUse(input.program);
  const used = input.program.assets.filter(({ id }) => usedIds.has(id));
  const prepared = await prepareAssets(used, {
    root,
    readAsset,
    compress,
    cache,
    streams: !input.singleFile,
    findsBorders: techniqueEdges === 'of open models',
    say,
  });
  if (prepared.output === null) return { output: null, diagnostics: prepared.diagnostics };
  const tooLarge = input.singleFile ? prepared.output.assets.flatMap(largePlace) : [];
  if (tooLarge.length > 0) return { output: null, diagnostics: tooLarge };
  const poster = (await input.drawPoster?.()) ?? neutralPoster();
  say('Bundling the page…');
  const { program, assets } = await storeLamps(input.program, prepared.output.assets, { root, say });
  const use = programUse(program);
  const works = pageCredits(input.program.credits ?? [], prepared.output.assets);
  const { decoders, models } = prepared.output;
  const pageUse: PageUse = { ...use, decoders, models, credits: works.length > 0, singleFile: input.singleFile ?? false };
  let code: Code;
  try {
    code = { scripts: await bundleScripts(input.root, pageUse), style: await bundleStyle(input.root) };
  } catch (error) {
    const message = `The page could not be bundled: ${error instanceof Error ? error.message : String(error)}`;
    return { output: null, diagnostics: [{ code: 'SCR064', severity: 'error', message }] };
  }
  const files: ReportedFile[] = [];
  const credits = works.map(({ nodes: _, ...credit }): PageCredit => credit);
  for (const { path, kind, bytes } of layOut({ ...input, program }, poster, code, { ...prepared.output, assets }, credits)) {
    await input.sink.write(path, bytes);
    files.push({ path, kind, ...sizesOf(bytes) });
  }
  const report = makeReport({
    program: input.program,
    generator: input.generator,
    files: files.sort((a, b) => (a.path < b.path ? -1 : 1)),
    scripts: code.scripts,
    features: webXrFeatures(input.program.needs),
    assets: prepared.output.assets.map(({ report }) => report),
    credits,
  });
  await input.sink.write(REPORT_FILE, toBytes(`${JSON.stringify(report, null, 2)}\n`));
  return { output: report, diagnostics: [...prepared.diagnostics, ...licenceWarnings(works)] };
}

/** The largest capture, or splats, of a page of one file, bytes: browsers keep such a page in memory several times. */
const MAX_EMBEDDED_BYTES = 20 * 2 ** 20;
const SMALLER: Readonly<Partial<Record<ProgramAsset['kind'], string>>> = {
  capture: 'import the capture with a smaller --size',
  splats: 'save the splats as SOG',
};

function largePlace({ asset, report }: PreparedAsset): Diagnostic[] {
  const bytes = report.fileBytes.after;
  const smaller = SMALLER[asset.kind];
  if (smaller === undefined || bytes <= MAX_EMBEDDED_BYTES) return [];
  const most = `a page of one file may contain ${asset.kind === 'capture' ? 'captures' : 'splats'} of ${MAX_EMBEDDED_BYTES / 2 ** 20} MB`;
  const message = `${asset.path} has ${Math.round(bytes / 2 ** 20)} MB; ${most}.`;
  const fix = `Export a page of several files, or ${smaller}.`;
  return [{ code: 'SCR034', severity: 'error', message, file: asset.path, fix }];
}

interface Code {
  readonly scripts: Scripts;
  readonly style: Uint8Array;
}

function layOut(
  input: BundleInput,
  poster: PosterImage,
  { scripts, style }: Code,
  { assets, decoders, decoderFiles }: PreparedAssets,
  credits: readonly PageCredit[],
): PageFile[] {
  const { program, page, singleFile = false, offline = true, address = null } = input;
  const bytes = toBytes(JSON.stringify(exportedProgram(program, assets)));
  const programFile: PageFile = { path: hashedName('program.json', bytes), kind: 'program', bytes };
  const assetFiles = assets.flatMap(({ asset, path, bytes, others }): PageFile[] =>
    [{ path, bytes }, ...others].map((file) => ({ ...file, kind: asset.kind })),
  );
  const decoderContent = decoderFiles.map(({ path, bytes }): PageFile => ({ path, kind: 'decoder', bytes }));
  // Two assets may refer to the same file.
  const content = [...new Map([programFile, ...assetFiles, ...decoderContent].map((file) => [file.path, file])).values()];
  const layOutPage = singleFile ? layOutSingleFile : layOutFiles;
  const licences: PageFile = { path: LICENCES_FILE, kind: 'licences', bytes: toBytes(licencesText(program.title, credits)) };
  const { workers, panoramas, scenes, readsView } = programUse(program);
  const files = layOutPage({
    title: program.title,
    ...page,
    address,
    offline,
    script: scripts.page.bytes,
    sessions: scripts.sessions?.bytes ?? null,
    style,
    poster,
    content,
    config: {
      asks: asksOf(program.needs),
      program: programFile.path,
      tiers: program.tiers,
      isFilter: !scenes && program.needs.some(({ capability, required }) => capability === 'camera-image' && required),
      looksAround: readsView,
      controls: program.controls ?? [],
      credits,
      decoders: Object.fromEntries(decoderFiles.map(({ file, path }) => [file, path])),
    },
    powers: {
      wasm: decoders.length > 0,
      workers: workers || panoramas || decoderFiles.length > 0,
      media: assets.some(({ asset }) => asset.kind === 'video'),
    },
  });
  return credits.length > 0 && !singleFile ? [...files, licences] : files;
}

/** Removes what only the editor needs: source maps, viewed layers and unused assets. The page contains the credits. */
function exportedProgram({ credits: _, ...program }: Program, assets: readonly PreparedAsset[]): Program {
  return {
    ...program,
    shaders: program.shaders.map(({ id, vertex, fragment }) => ({ id, vertex, fragment })),
    assets: assets.map(({ asset, path }) => ({ ...asset, path })),
    taps: {},
  };
}
