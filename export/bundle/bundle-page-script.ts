import { resolve } from 'node:path';
import { build, type Metafile } from 'esbuild';
import { RUNTIME_FILES } from '../../nodes/generated/runtime-files.gen.ts';
import type { DecoderName } from '../gltf/decoders.ts';
import type { ProgramUse } from './program-use.ts';

export interface Script {
  readonly bytes: Uint8Array;
  /** Source file relative to the root → its bytes in the script. */
  readonly parts: Readonly<Record<string, number>>;
}

/** What the models of a page need. */
export interface ModelUse {
  readonly decoders: readonly DecoderName[];
  /** Whether any has glass. */
  readonly glass: boolean;
}

/** JavaScript version of the script: that of browsers with WebXR, and of other browsers since 2022. There are no polyfills. */
const TARGET = 'es2022';

/**
 * Bundles the page's only script: player, page and the runtimes of the used nodes. It is a classic script, because browsers load no modules
 * from `file:` URLs. esbuild returns the same bytes for the same sources.
 */
export async function bundleScript(root: string, use: ProgramUse, models: ModelUse): Promise<Script> {
  const { outputFiles, metafile } = await build({
    stdin: { contents: entryText(use, models), resolveDir: root, sourcefile: 'page.ts', loader: 'ts' },
    absWorkingDir: root,
    bundle: true,
    write: false,
    metafile: true,
    minify: true,
    format: 'iife',
    platform: 'browser',
    target: TARGET,
    charset: 'utf8',
    legalComments: 'eof',
    loader: { '.fs': 'text', '.vs': 'text', '.glsl': 'text' },
    // three.js decoders refer to files by `import.meta.url`, which classic scripts do not have. The URLs are not used.
    define: { 'process.env.NODE_ENV': '"production"', 'import.meta.url': 'document.baseURI' },
    logLevel: 'silent',
  });
  const [file] = outputFiles;
  if (!file) throw new Error('esbuild made no script.');
  return { bytes: file.contents, parts: partsOf(metafile) };
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

const OPENERS: Readonly<Record<DecoderName, string>> = { draco: 'openDraco', meshopt: 'openMeshopt', ktx2: 'openKtx2' };

const WORKERS_FOLDER = 'nodes/generated/workers/';

function entryText(
  { nodeTypes, scenes, spatial, input, panoramas, controls, labels, workerTypes, takesPanorama, glass: ownGlass }: ProgramUse,
  { decoders, glass: modelGlass }: ModelUse,
): string {
  const glass = scenes && (ownGlass || modelGlass);
  const tools = ['decoders', 'files', ...(panoramas ? ['readRadiance'] : []), ...(glass ? ['createGlass'] : [])];
  const played = nodeTypes.filter((type) => Object.hasOwn(RUNTIME_FILES, type));
  // A node that starts no worker is played without its text.
  const fileOf = (type: string): string | undefined =>
    RUNTIME_FILES[type]?.startsWith(WORKERS_FOLDER) && !workerTypes.has(type) ? `nodes/${type}/runtime.ts` : RUNTIME_FILES[type];
  const lines = [
    `import { startPage } from './export/page/start-page.ts';`,
    ...(scenes ? [`import { createScenesWith } from './export/runtime/scenes/create-scenes.ts';`] : []),
    ...(spatial ? [`import { createSpatial } from './export/runtime/spatial/create-spatial.ts';`] : []),
    ...(input ? [`import { SESSION_INPUTS } from './export/runtime/sessions/input/session-inputs.ts';`] : []),
    ...(scenes ? [`import { createLens } from './export/runtime/sessions/camera/lens.ts';`] : []),
    ...(panoramas
      ? [
          `import { readRadianceInWorker } from './export/runtime/scenes/environments/read-radiance-in-worker.ts';`,
          `import { text as radianceText } from './${WORKERS_FOLDER}decode-radiance.gen.ts';`,
          'const readRadiance = readRadianceInWorker(radianceText);',
        ]
      : []),
    ...(glass ? [`import { createGlass } from './export/runtime/scenes/glass/glass-scene.ts';`] : []),
    ...(controls ? [`import { createRoomPanel } from './export/page/room-panel/room-panel.ts';`] : []),
    ...(labels ? [`import { createLabelLayer } from './export/page/label-layer.ts';`] : []),
    ...(takesPanorama ? [`import { createPagePanorama as createPanorama } from './export/page/panorama-step/page-panorama.ts';`] : []),
    ...decoders.map((name) => `import { ${OPENERS[name]} } from './export/runtime/scenes/models/decoders/${name}.ts';`),
    ...played.map((type, i) => `import * as node${i} from ${JSON.stringify(`./${fileOf(type)}`)};`),
    `const modules = { ${played.map((type, i) => `${JSON.stringify(type)}: node${i}`).join(', ')} };`,
    `const decoders = { ${decoders.map((name) => `${name}: ${OPENERS[name]}`).join(', ')} };`,
    `const createScenes = ${scenes ? `(files) => createScenesWith({ ${tools.join(', ')} })` : 'null'};`,
    `startPage(window, { modules, createScenes, createSpatial${spatial ? '' : ': null'}, inputs: ${input ? 'SESSION_INPUTS' : 'null'}, createRoomPanel${controls ? '' : ': null'}, createLabelLayer${labels ? '' : ': null'}, createLens${scenes ? '' : ': null'}, createPanorama${takesPanorama ? '' : ': null'} });`,
  ];
  return lines.join('\n');
}

function partsOf(metafile: Metafile): Record<string, number> {
  const [output] = Object.values(metafile.outputs);
  const parts = Object.entries(output?.inputs ?? {}).map(([path, { bytesInOutput }]) => [path, bytesInOutput] as const);
  return Object.fromEntries(parts.filter(([, bytes]) => bytes > 0).sort(([a], [b]) => (a < b ? -1 : 1)));
}
