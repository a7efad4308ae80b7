import { readFile } from 'node:fs/promises';
import { basename, dirname, resolve } from 'node:path';
import { build, type Metafile, type Plugin } from 'esbuild';
import { leaveOut } from './optional-parts.ts';
import { entersSessions, type PageUse, pageEntry, SESSIONS_MODULE, SHARED, sessionsEntry, sharedModule } from './page-entry.ts';
import { shrink } from './shrink/shrink-plugin.ts';

export interface Script {
  readonly bytes: Uint8Array;
  /** Source file relative to the root → its bytes in the script. */
  readonly parts: Readonly<Record<string, number>>;
}

/** The scripts of a page. */
export interface Scripts {
  readonly page: Script;
  /** The sessions that a visitor enters; null if `page` contains them, or there are none. */
  readonly sessions: Script | null;
}

/** JavaScript version of the script: that of browsers with WebXR, and of other browsers since 2022. There are no polyfills. */
const TARGET = 'es2022';

export interface BundleOptions {
  /** Bundles three.js as it is published, for comparison. Default: false. */
  readonly wholeThree?: boolean;
}

/**
 * Bundles the scripts of a page: player, page and the runtimes of the used nodes; and, as an own script, the sessions that a visitor enters.
 * The first is a classic script, because browsers load no modules from `file:` URLs. The second is a module, which gets the functions that
 * both use from the first. esbuild returns the same bytes for the same sources.
 */
export async function bundleScripts(root: string, use: PageUse, { wholeThree = false }: BundleOptions = {}): Promise<Scripts> {
  const plugins = [sessionsModule(root, use), leaveOut(root, use), ...(wholeThree ? [] : [shrink(root, use)])];
  const [page, sessions] = await Promise.all([
    bundle(root, plugins, { contents: pageEntry(use), sourcefile: 'page.ts' }, 'iife'),
    use.singleFile || !entersSessions(use)
      ? null
      : bundle(root, [sharedModules(root), ...plugins], { contents: sessionsEntry(use), sourcefile: 'sessions.ts' }, 'esm'),
  ]);
  return { page, sessions };
}

/** Settings of esbuild for the scripts of all pages. */
export const PAGE_SETTINGS = {
  bundle: true,
  write: false,
  minify: true,
  platform: 'browser',
  target: TARGET,
  charset: 'utf8',
  legalComments: 'eof',
  // three.js decoders refer to files by `import.meta.url`, which classic scripts do not have. The URLs are not used.
  define: { 'process.env.NODE_ENV': '"production"', 'import.meta.url': 'document.baseURI' },
  logLevel: 'silent',
} as const;

async function bundle(
  root: string,
  plugins: Plugin[],
  entry: { readonly contents: string; readonly sourcefile: string },
  format: 'iife' | 'esm',
): Promise<Script> {
  const { outputFiles, metafile } = await build({
    ...PAGE_SETTINGS,
    stdin: { ...entry, resolveDir: root, loader: 'ts' },
    absWorkingDir: root,
    metafile: true,
    format,
    loader: { '.fs': 'text', '.vs': 'text', '.glsl': 'text' },
    plugins,
  });
  const [file] = outputFiles;
  if (!file) throw new Error('esbuild made no script.');
  return { bytes: file.contents, parts: partsOf(metafile) };
}

/** Gives the sessions to the script of a single-file page. */
function sessionsModule(root: string, use: PageUse): Plugin {
  const namespace = 'sessions';
  return {
    name: namespace,
    setup: ({ onResolve, onLoad }) => {
      onResolve({ filter: new RegExp(`^${SESSIONS_MODULE}$`) }, ({ path }) => ({ path, namespace, sideEffects: false }));
      onLoad({ filter: /./, namespace }, () => ({ contents: sessionsEntry(use), resolveDir: root, loader: 'ts' }));
    },
  };
}

/** Gives the sessions the functions that the script of the page has. */
function sharedModules(root: string): Plugin {
  const files = new Map(Object.keys(SHARED).map((file) => [resolve(root, file), file]));
  const names = [...files.values()].map((file) => basename(file, '.ts'));
  const own = 'own';
  return {
    name: 'shared',
    setup: ({ onResolve, onLoad }) => {
      onResolve({ filter: new RegExp(`^${own}:`) }, ({ path }) => ({
        path: path.slice(own.length + 1),
        namespace: own,
        sideEffects: false,
      }));
      onLoad({ filter: /./, namespace: own }, async ({ path }) => ({
        contents: await readFile(path),
        resolveDir: dirname(path),
        loader: 'ts',
      }));
      onLoad({ filter: new RegExp(`(${names.join('|')})\\.ts$`), namespace: 'file' }, ({ path }) => {
        const file = files.get(path);
        return file === undefined ? null : { contents: sharedModule(file, `${own}:${path}`), loader: 'ts' };
      });
    },
  };
}

/** Bundles the style sheet. */
export async function bundleStyle(root: string): Promise<Uint8Array> {
  const { outputFiles } = await build({
    entryPoints: [resolve(root, 'export/page/page.css')],
    bundle: true,
    write: false,
    minify: true,
    target: ['chrome108', 'safari16.4', 'firefox115'],
    logLevel: 'silent',
  });
  const [file] = outputFiles;
  if (!file) throw new Error('esbuild made no style sheet.');
  return file.contents;
}

function partsOf(metafile: Metafile): Record<string, number> {
  const [output] = Object.values(metafile.outputs);
  const parts = Object.entries(output?.inputs ?? {}).map(([path, { bytesInOutput }]) => [path, bytesInOutput] as const);
  return Object.fromEntries(parts.filter(([, bytes]) => bytes > 0).sort(([a], [b]) => (a < b ? -1 : 1)));
}
