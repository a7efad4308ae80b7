/**
 * A row of the table that says which files may import which files and npm packages (docs/ARCHITECTURE.md). The table is closed: a file that
 * belongs to no layer fails the check, and so does an import that no row allows. There is no list of exceptions; a change of the table is a
 * change of the architecture.
 *
 * Paths are relative to the repository. `*` matches any part of a name, `**` any folders, `{a,b}` either word. A file belongs to the first
 * layer that matches it.
 */
export interface Layer {
  readonly name: string;
  readonly files: readonly string[];
  /** Other layers whose files this layer may import. */
  readonly imports?: readonly string[];
  /** Layers and packages of which this layer may import only types. */
  readonly types?: readonly string[];
  /** npm packages that this layer may import, by name without subpath. `node:*` stands for all modules of Node. */
  readonly packages?: readonly string[];
  /** Which files of the same layer a file may import: those of its folder, or none. Absent: all. */
  readonly own?: 'folder' | 'none';
  /** Whether the folder must not contain TypeScript or JavaScript, such as a folder of shaders. */
  readonly noCode?: true;
}

const TEST_FILES = ['**/*.test.{ts,tsx}', 'tests/**'];
const SHELLS = 'app/{services,electron,server,cli}/**';
const PAGES = '{export/runtime,export/page,export/emulator,renderer}/**';
const EXPORT_KIT = ['kit', 'kit runtime'];
const NODE_KIT = [...EXPORT_KIT, 'kit with three'];
const HOST = [
  'kit',
  'contract',
  'host client',
  'graph',
  'glsl',
  'gltf',
  'captures',
  'compiler',
  'program',
  'bundle',
  'registry of definitions',
  'manifest',
];

export const LAYERS: readonly Layer[] = [
  // Tests may import everything; only tests may import tests (see `check.ts`).
  { name: 'tests', files: TEST_FILES },
  // Build configurations may stand in the folder that they build; they belong to no layer of it.
  { name: 'configuration', files: ['**/*.config.{mjs,ts}', '*.d.ts'], packages: ['vite', '@vitejs/plugin-react', 'node:*'] },

  {
    name: 'kit',
    files: [
      'nodes/kit/{panorama,splats}/**',
      'nodes/kit/{arithmetic,asset-words,capture,capture-size,categories,choice-options,color-math,curve,definition,diagnostics,drawing-options,ease,expression,facts,frame-times,glyphs,gradient,hand-joints,handles,light-params,material-params,phone-memory,photo-blob,play-expression,play-size,pointer-params,poster-framing,room-depth-glsl,pose-params,surface-params,track-time,wire-types}.ts',
    ],
  },
  { name: 'kit with three', files: ['nodes/kit/three/**'], imports: EXPORT_KIT, packages: ['three'] },
  { name: 'kit runtime', files: ['nodes/kit/**'], imports: ['kit'], types: ['three'] },
  { name: 'registry of definitions', files: ['nodes/generated/definitions.gen.ts'], imports: ['kit', 'node definition'] },
  { name: 'registry of runtimes', files: ['nodes/generated/runtimes.gen.ts'], imports: ['kit runtime', 'node', 'workers as text'] },
  { name: 'decoder as text', files: ['nodes/generated/workers/decode-radiance.gen.ts'] },
  { name: 'workers as text', files: ['nodes/generated/workers/*.gen.ts'], imports: ['node'] },
  { name: 'registry of runtime files', files: ['nodes/generated/runtime-files.gen.ts'] },
  { name: 'registry of recipes', files: ['nodes/generated/recipes.gen.ts'] },
  { name: 'node definition', files: ['nodes/*/*/definition.ts'], imports: ['kit'], own: 'none' },
  { name: 'node', files: ['nodes/*/*/**'], imports: NODE_KIT, packages: ['three', 'cannon-es'], own: 'folder' },
  { name: 'shader library', files: ['shader-library/**'], noCode: true },

  { name: 'program', files: ['export/program/**'], types: ['kit'] },
  { name: 'gltf', files: ['export/gltf/**'], imports: ['kit'] },
  { name: 'captures', files: ['export/captures/**'], imports: ['kit', 'gltf'] },
  { name: 'scores', files: ['export/score/**'] },
  { name: 'graph', files: ['export/graph/**'], imports: ['kit'], packages: ['immer', 'jsonc-parser'] },
  { name: 'glsl', files: ['export/glsl/**'], imports: ['kit', 'program'], packages: ['jsonc-parser'] },
  { name: 'compiler', files: ['export/compiler/**'], imports: ['kit', 'graph', 'glsl', 'program'] },
  // Image passes need no three.js: only the scenes load it, and a page without objects leaves them out.
  {
    name: 'scenes',
    files: ['export/runtime/scenes/**'],
    imports: [...EXPORT_KIT, 'program', 'gltf', 'runtime'],
    packages: ['three', 'cannon-es'],
  },
  { name: 'recorded session format', files: ['export/runtime/sessions/{session-format,print-session}.ts'] },
  // Plays recordings, in the preview and `scrim render`; like the emulator it is never in a page.
  {
    name: 'recorded session',
    files: ['export/runtime/sessions/recorded/**'],
    imports: [...EXPORT_KIT, 'program', 'runtime', 'recorded session format'],
    packages: ['fast-png'],
  },
  {
    name: 'runtime',
    files: ['export/runtime/**'],
    imports: [...EXPORT_KIT, 'program', 'recorded session format'],
    types: ['three'],
  },
  {
    name: 'emulator',
    files: ['export/emulator/**'],
    imports: [...EXPORT_KIT, 'program', 'runtime', 'recorded session format', 'scenes'],
    packages: ['iwer', '@iwer/sem', 'three', 'three-mesh-bvh'],
  },
  { name: 'page', files: ['export/page/**'], imports: [...EXPORT_KIT, 'program', 'gltf', 'runtime', 'scenes'] },
  {
    name: 'bundle',
    files: ['export/bundle/**'],
    imports: ['kit', 'captures', 'compiler', 'program', 'gltf', 'page', 'scenes', 'registry of runtime files'],
    packages: [
      '@jsquash/avif',
      '@jsquash/jpeg',
      'esbuild',
      'node:*',
      'fast-png',
      'jpeg-js',
      '@gltf-transform/core',
      '@gltf-transform/extensions',
      '@gltf-transform/functions',
      'meshoptimizer',
      'ktx2-encoder',
    ],
  },

  {
    name: 'contract',
    files: ['app/contract/contract.ts', 'app/contract/call-parts.ts', 'app/contract/*-calls.ts'],
    imports: ['kit'],
    packages: ['zod'],
  },
  // What the editor calls its host with; without zod, whose generated checks a strict CSP refuses.
  { name: 'host client', files: ['app/contract/**'], types: ['contract'] },
  {
    name: 'services',
    files: ['app/services/**'],
    imports: HOST,
    packages: ['node:*', 'zod', 'esbuild', 'playwright-core', '@sparticuz/chromium', 'fast-png', 'jpeg-js'],
  },
  { name: 'electron shell', files: ['app/electron/**'], imports: [...HOST, 'services'], packages: ['electron', 'node:*', 'zod'] },
  { name: 'server shell', files: ['app/server/**'], imports: [...HOST, 'services'], packages: ['node:*', 'zod'] },
  {
    name: 'command line page',
    files: ['app/cli/**/*.page.ts'],
    imports: [
      ...EXPORT_KIT,
      'program',
      'captures',
      'scores',
      'runtime',
      'scenes',
      'emulator',
      'recorded session',
      'recorded session format',
      'registry of runtimes',
    ],
    packages: ['three'],
  },
  {
    name: 'command line',
    files: ['app/cli/**'],
    imports: [...HOST, 'services', 'server shell', 'scores', 'command line page'],
    packages: ['node:*', 'zod', 'playwright-core', 'fast-png'],
  },

  // The preview is a page of its own, without the editor's host: messages are all they share.
  {
    name: 'preview protocol',
    files: ['renderer/preview-{costs,protocol}.ts', 'renderer/keybinding.ts', 'renderer/drag-watch.ts', 'renderer/drag-keys.ts'],
    imports: ['kit', 'program'],
    types: ['captures'],
  },
  {
    name: 'preview',
    files: ['renderer/preview/**'],
    imports: [
      ...NODE_KIT,
      'program',
      'gltf',
      'captures',
      'preview protocol',
      'runtime',
      'recorded session format',
      'scenes',
      'decoder as text',
      'emulator',
      'recorded session',
      'registry of runtimes',
    ],
    packages: ['three', 'mediabunny', 'fast-png'],
  },
  // Decodes panoramas as the page does; it is loaded only while the inspector shows one.
  {
    name: 'panorama worker',
    files: ['renderer/state/lamps/lamps.worker.ts'],
    imports: ['kit', 'scenes', 'runtime'],
    own: 'folder',
    types: ['editor'],
  },
  {
    name: 'editor',
    files: ['renderer/**'],
    imports: [
      'kit',
      'graph',
      'glsl',
      'gltf',
      'captures',
      'compiler',
      'program',
      'preview protocol',
      'host client',
      'registry of definitions',
      'registry of recipes',
      'panorama worker',
    ],
    types: ['contract'],
    packages: ['react', 'react-dom', '@xyflow/react', 'elkjs', 'monaco-editor', 'zustand', 'immer', 'fast-png', 'qr'],
  },

  {
    name: 'makers of examples',
    files: ['tools/{examples,sessions}/**'],
    // The studio is filmed in a browser, by the emulator's own means.
    imports: ['kit', 'graph', 'registry of definitions', 'recorded session format', 'tools', 'services', 'emulator'],
    packages: [
      'node:*',
      'three',
      '@gltf-transform/core',
      '@gltf-transform/extensions',
      '@gltf-transform/functions',
      'fast-png',
      'mediabunny',
      'esbuild',
      'playwright-core',
      'sharp',
    ],
  },
  {
    name: 'measured page',
    files: ['tools/bench/pages/**'],
    imports: [...EXPORT_KIT, 'program', 'runtime', 'emulator', 'scenes', 'registry of runtimes'],
    packages: ['three', 'postprocessing'],
  },
  {
    name: 'measured physics',
    files: ['tools/bench/physics/**'],
    imports: ['kit', 'kit runtime', 'node', 'node definition'],
    packages: ['node:*', 'three', 'cannon-es', '@dimforge/rapier3d-compat'],
  },
  {
    name: 'tools',
    files: ['tools/**'],
    imports: [...HOST, 'services', 'server shell', 'makers of examples', 'measured page', 'measured physics'],
    packages: [
      'node:*',
      '@gltf-transform/core',
      '@gltf-transform/extensions',
      'meshoptimizer',
      'esbuild',
      'vite',
      'oxc-parser',
      'fast-png',
      'fflate',
      'playwright-core',
      'sharp',
      '@electron/packager',
      '@electron/fuses',
    ],
  },
  { name: 'start script', files: ['bin/**'], imports: ['build output', 'tools'], packages: ['node:*'] },
  { name: 'build output', files: ['dist/**'] },
  { name: 'manifest', files: ['package.json'] },
];

/** The folders of the table in ARCHITECTURE. Between any two of them, imports go in only one direction. */
export const ROOMS = [
  'nodes/kit',
  'export/program',
  'export/graph',
  'export/glsl',
  'export/gltf',
  'export/compiler',
  'export/runtime',
  'export/score',
  'export/emulator',
  'export/page',
  'export/bundle',
  'app',
  'renderer',
] as const;

/** In these folders, imports between two sibling folders go in only one direction. A folder and its subfolders may import each other. */
export const SIBLINGS = ['renderer'] as const;

/** No two files of these folders, taken together, have the same name, except tests and the names that `FIXED_NAMES` lists. */
export const UNIQUE_NAMES = [
  'app',
  'nodes/kit',
  'export/program',
  'export/graph',
  'export/glsl',
  'export/gltf',
  'export/compiler',
  'export/emulator',
  'export/page',
  'export/bundle',
] as const;

/** File names with one fixed meaning in every folder. */
export const FIXED_NAMES = ['definition', 'runtime', 'main', 'index'] as const;

/**
 * Globals that make a run unrepeatable, each with the only files that may use them. All other code gets them injected.
 * Tests may use the clock and the network, but take random numbers from a seed.
 */
export const RAW_GLOBALS = {
  clock: {
    names: ['Date.now', 'new Date', 'performance.now', 'setTimeout', 'setInterval', 'requestAnimationFrame'],
    files: [SHELLS, `${PAGES}/clock.ts`, 'tools/**', ...TEST_FILES],
  },
  network: { names: ['fetch'], files: [SHELLS, `${PAGES}/network.ts`, 'tools/**', ...TEST_FILES] },
  chance: { names: ['Math.random'], files: [`${PAGES}/random.ts`] },
} as const satisfies Record<string, { names: readonly string[]; files: readonly string[] }>;

/** Maximum number of lines of a file. Most files have fewer than 150. */
export const MAX_LINES = 400;
