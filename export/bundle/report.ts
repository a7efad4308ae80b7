import { gzipSync } from 'node:zlib';
import { type DeviceRow, deviceTable } from '../program/devices/device-table.ts';
import { fixedImageNote } from '../program/fixed-image.ts';
import type { ProgramNeed, Tier } from '../program/needs.ts';
import type { Program, ProgramAsset } from '../program/program.ts';
import type { WebXrFeatures } from '../program/webxr-features.ts';
import { type PageGpuBytes, pageGpuBytes } from './assets/page-memory.ts';
import type { ReportedAsset } from './assets/prepared-asset.ts';
import type { Scripts } from './bundle-page-script.ts';
import type { PageCredit } from './page-credits.ts';
import { nodeBytes, type ReportedNode } from './report-nodes.ts';

export type FileKind = 'page' | 'script' | 'style' | 'offline' | 'poster' | 'program' | 'decoder' | 'licences' | ProgramAsset['kind'];

/** `report.json` of an exported page: its content, and the files that a later export may replace. */
export interface ExportReport {
  readonly format: 'scrim-export';
  readonly version: 1;
  readonly title: string;
  readonly generator: string;
  readonly files: readonly ReportedFile[];
  /** Total size of the files, without this report, which visitors do not load. */
  readonly bytes: Sizes & { readonly byKind: Readonly<Partial<Record<FileKind, Sizes>>> };
  /** Content of the scripts: npm packages and Scrim's folders → minified bytes. */
  readonly script: Readonly<Record<string, number>>;
  /** Content of each script by source file, in minified bytes, largest first. `sessions` is null if `page` contains them, or there are none. */
  readonly modules: {
    readonly page: Readonly<Record<string, number>>;
    readonly sessions: Readonly<Record<string, number>> | null;
  };
  /** What the nodes of the program cost, largest first. */
  readonly nodes: readonly ReportedNode[];
  /** WebXR features that the page requests for AR. */
  readonly features: WebXrFeatures;
  /** Result of the export for each asset, with sizes before and after compression. */
  readonly assets: readonly ReportedAsset[];
  /** What the assets take on the GPU together. */
  readonly gpuBytes: PageGpuBytes;
  /** Authors and licenses of the page's works. */
  readonly credits: readonly PageCredit[];
  readonly needs: readonly ProgramNeed[];
  readonly tiers: readonly Tier[];
  /** Why the page offers no session to enter, or would offer none with other files; null if neither. */
  readonly note: string | null;
  /** What each kind of device shows. */
  readonly devices: readonly DeviceRow[];
}

export interface ReportedFile extends Sizes {
  readonly path: string;
  readonly kind: FileKind;
}

export interface Sizes {
  readonly raw: number;
  /** Size after gzip, as most hosts send it. It is also computed for images and models, which are compressed already. */
  readonly gzip: number;
}

export const REPORT_FILE = 'report.json';

export function sizesOf(bytes: Uint8Array): Sizes {
  return { raw: bytes.length, gzip: gzipSync(bytes, { level: 9 }).length };
}

export interface ReportInput {
  readonly program: Program;
  readonly generator: string;
  readonly files: readonly ReportedFile[];
  readonly scripts: Scripts;
  readonly features: WebXrFeatures;
  readonly assets: readonly ReportedAsset[];
  readonly credits: readonly PageCredit[];
}

export function makeReport({ program, generator, files, scripts, features, assets, credits }: ReportInput): ExportReport {
  const byKind: Partial<Record<FileKind, Sizes>> = {};
  for (const { kind, raw, gzip } of files) byKind[kind] = add(byKind[kind], { raw, gzip });
  const total = files.reduce<Sizes>(add, { raw: 0, gzip: 0 });
  return {
    format: 'scrim-export',
    version: 1,
    title: program.title,
    generator,
    files,
    bytes: { raw: total.raw, gzip: total.gzip, byKind },
    script: groupParts([...Object.entries(scripts.page.parts), ...Object.entries(scripts.sessions?.parts ?? {})]),
    modules: { page: largestFirst(scripts.page.parts), sessions: scripts.sessions && largestFirst(scripts.sessions.parts) },
    nodes: nodeBytes(program, scripts.page.parts, assets),
    features,
    assets,
    gpuBytes: pageGpuBytes(assets),
    credits,
    needs: program.needs,
    tiers: program.tiers,
    note: fixedImageNote(program),
    devices: deviceTable(program),
  };
}

function largestFirst(parts: Readonly<Record<string, number>>): Record<string, number> {
  return Object.fromEntries(Object.entries(parts).sort(([a, m], [b, n]) => n - m || (a < b ? -1 : 1)));
}

function add(a: Sizes | undefined, b: Sizes): Sizes {
  return { raw: (a?.raw ?? 0) + b.raw, gzip: (a?.gzip ?? 0) + b.gzip };
}

/**
 * Groups source files by package or folder: `node_modules/three/build/x.js` → `three`; `export/runtime/passes/pass.ts` → `export/runtime`;
 * `nodes/a/b/runtime.ts` → `nodes/a/b`.
 */
function groupParts(parts: readonly (readonly [path: string, bytes: number])[]): Record<string, number> {
  const groups = new Map<string, number>();
  for (const [path, bytes] of parts) {
    const name = groupOf(path);
    groups.set(name, (groups.get(name) ?? 0) + bytes);
  }
  return Object.fromEntries([...groups].sort(([a], [b]) => (a < b ? -1 : 1)));
}

function groupOf(path: string): string {
  const afterModules = path.split('node_modules/').pop() ?? path;
  const parts = afterModules.split('/');
  if (afterModules !== path) return parts.slice(0, afterModules.startsWith('@') ? 2 : 1).join('/');
  return parts.slice(0, parts[0] === 'nodes' && parts[1] !== 'kit' ? 3 : 2).join('/');
}
