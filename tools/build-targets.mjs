import { spawnSync } from 'node:child_process';
import { copyFileSync, existsSync, mkdirSync, renameSync, rmSync, writeFileSync } from 'node:fs';
import { dirname, join, resolve } from 'node:path';
import process from 'node:process';
import { checkStamp, writeStamp } from './build-stamp.mjs';

const root = resolve(import.meta.dirname, '..');

/** Sources of all targets: the build tools and the versions of npm packages. */
const ALWAYS = ['package.json', 'package-lock.json', 'tools/build-targets.mjs'];

const SHARED = ['nodes', 'export', 'app/contract'];

/** Options of targets for Node. Native binaries and the browser driver cannot be bundled. */
const NODE_BUILD = {
  bundle: true,
  platform: 'node',
  write: false,
  sourcemap: 'linked',
  // The CommonJS entries of some packages use imports that bundlers cannot resolve.
  mainFields: ['module', 'main'],
  external: ['electron', 'esbuild', 'playwright-core'],
  loader: { '.fs': 'text', '.vs': 'text', '.glsl': 'text' },
  legalComments: 'none',
  logLevel: 'warning',
  absWorkingDir: root,
};

/** Targets by name, in build order: their sources, output and build function. */
export const TARGETS = {
  registry: {
    sources: ['nodes', 'shader-library', 'export/glsl', 'tools/gen', 'tools/run.mjs', 'tools/lib'],
    // What was made counts as well: `npm run gen` on another branch makes another registry, and this stamp does not hear of it.
    made: 'nodes/generated',
    output: 'nodes/generated/definitions.gen.ts',
    build: async () => {
      const { status } = spawnSync(process.execPath, [join(root, 'tools/run.mjs'), 'gen/main.ts'], { stdio: ['ignore', 2, 2] });
      if (status !== 0) throw new Error('The registry of nodes could not be made.');
    },
  },
  cli: {
    sources: [...SHARED, 'app'],
    output: 'dist/cli/main.mjs',
    build: () =>
      bundle({
        entryPoints: ['app/cli/main.ts'],
        outfile: 'dist/cli/main.mjs',
        format: 'esm',
        target: 'node20',
        // CommonJS packages in the bundle use `require` for Node’s modules.
        banner: { js: "import { createRequire as scrimRequire } from 'node:module'; const require = scrimRequire(import.meta.url);" },
      }),
  },
  electron: {
    sources: [...SHARED, 'app'],
    output: 'dist/electron/main.cjs',
    build: async () => {
      // Electron 22, the oldest tested version, contains Node 16.
      const options = { format: 'cjs', target: 'node16' };
      await bundle({ ...options, entryPoints: ['app/electron/main.ts'], outfile: 'dist/electron/main.cjs' });
      await bundle({ ...options, entryPoints: ['app/electron/preload.ts'], outfile: 'dist/electron/preload.cjs' });
      copyFileSync(join(root, 'app/electron/icons/scrim.png'), join(root, 'dist/electron/scrim.png'));
    },
  },
  editor: {
    sources: [...SHARED, 'renderer', 'vite.config.ts'],
    output: 'dist/editor/index.html',
    build: () => buildPage('editor'),
  },
  preview: {
    sources: [...SHARED, 'renderer', 'vite.config.ts'],
    output: 'dist/preview/index.html',
    build: () => buildPage('preview'),
  },
};

/**
 * Builds what is out of date. `say` hears what is being built, before it takes its time.
 *
 * @param {readonly (keyof typeof TARGETS)[]} names
 * @param {(text: string) => void} say
 * @returns {Promise<number>} How many were built.
 */
export async function buildTargets(names, say) {
  let built = 0;
  for (const [name, target] of Object.entries(TARGETS)) {
    if (!names.includes(name)) continue;
    const stampFile = join(root, 'dist', `${name}.stamp.json`);
    const { fresh, stamp } = checkStamp(root, stampFile, [...target.sources, ...ALWAYS]);
    if (fresh && existsSync(join(root, target.output))) continue;
    say(`Building ${name}…`);
    await target.build();
    writeStamp(stampFile, target.made === undefined ? stamp : withMade(stampFile, stamp, target.made));
    built++;
  }
  return built;
}

/** A stamp that includes the files of the output folder after the build. */
function withMade(stampFile, stamp, folder) {
  const others = Object.entries(stamp).filter(([path]) => !path.startsWith(`${folder}/`));
  return { ...Object.fromEntries(others), ...checkStamp(root, stampFile, [folder]).stamp };
}

/** Renames each file into place, because another Scrim may be loading it. */
async function bundle(options) {
  const { build } = await import('esbuild');
  const { outputFiles } = await build({ ...NODE_BUILD, ...options });
  for (const { path, contents } of outputFiles) {
    mkdirSync(dirname(path), { recursive: true });
    const temporary = `${path}.${process.pid}`;
    writeFileSync(temporary, contents);
    renameSync(temporary, path);
  }
}

/** Builds beside the old page, which stays valid until the new one is complete. */
async function buildPage(mode) {
  const { build } = await import('vite');
  const outDir = join(root, 'dist', `${mode}.${process.pid}`);
  const old = join(root, 'dist', `${mode}.old.${process.pid}`);
  const final = join(root, 'dist', mode);
  try {
    await build({ configFile: join(root, 'vite.config.ts'), mode, build: { outDir }, logLevel: 'warn' });
    if (existsSync(final)) renameSync(final, old);
    renameSync(outDir, final);
  } finally {
    rmSync(outDir, { recursive: true, force: true });
    rmSync(old, { recursive: true, force: true });
  }
}
