import { RUNTIME_FILES } from '../../nodes/generated/runtime-files.gen.ts';
import type { DecoderName } from '../gltf/decoders.ts';
import type { ModelUse } from './model-use.ts';
import type { ProgramUse } from './program-use.ts';

/** What a page needs: by its program, by its models, and by the way it is laid out. */
export interface PageUse extends ProgramUse {
  readonly decoders: readonly DecoderName[];
  readonly models: ModelUse;
  /** Whether it names authors. */
  readonly credits: boolean;
  /** Whether `index.html` contains everything. */
  readonly singleFile: boolean;
}

/** Whether the program of a page plays in a session that a visitor enters: with AR, with a camera or in VR. */
export const entersSessions = ({ tiers }: Pick<PageUse, 'tiers'>): boolean => [...tiers].some((id) => id !== 'orbit');

/** Name by which the script of a single-file page imports the sessions. */
export const SESSIONS_MODULE = 'scrim:sessions';

/** The global of a page of two scripts, by which that of the sessions gets the functions that both use. */
const SHARED_GLOBAL = 'scrimShared';

/** The files of functions that both scripts of every page use, with the exports that the sessions import. */
export const SHARED: Readonly<Record<string, readonly string[]>> = {
  'export/runtime/gl/allocate-texture.ts': ['allocateTexture'],
  'export/runtime/gl/copy-shader.ts': ['COPY_SHADER', 'COPY_SAMPLER', 'COPY_UV'],
  'export/runtime/sessions/fit-canvas.ts': ['createCanvasFitter'],
  'export/runtime/sessions/frame-time.ts': ['createFrameTime', 'MAX_STEP_S'],
  'export/runtime/sessions/input/session-input.ts': ['createSessionInput'],
  'export/runtime/sessions/matrix.ts': ['NEAR_M', 'FAR_M', 'createMatrix', 'setFrustum', 'setRigidInverse'],
  'export/runtime/sessions/orbit/orbit-input.ts': ['listenForOrbit'],
  'export/runtime/sessions/session-frame.ts': ['createSessionFrame', 'coverCanvas'],
  'nodes/kit/pass-state.ts': ['setPassState', 'setSampler'],
};

/** The text of a shared file in the script of the sessions: what the page shares, and the other exports of the file `own`. */
export function sharedModule(file: string, own: string): string {
  return `export const { ${(SHARED[file] ?? []).join(', ')} } = ${SHARED_GLOBAL};\nexport * from ${JSON.stringify(own)};`;
}

const OPENERS: Readonly<Record<DecoderName, string>> = { draco: 'openDraco', meshopt: 'openMeshopt', ktx2: 'openKtx2' };

const WORKERS_FOLDER = 'nodes/generated/workers/';

/** The text of the page's script: imports of the parts that the page uses, and the call that starts it. */
export function pageEntry(use: PageUse): string {
  const { nodeTypes, scenes, spatial, input, panoramas, labels, workerTypes, takesPanorama, decoders, singleFile } = use;
  const enters = entersSessions(use);
  const loadSessions = !enters ? 'null' : singleFile ? 'async () => sessions' : '(path) => import(new URL(path, document.baseURI).href)';
  const glass = scenes && (use.glass || use.models.extensions.has('KHR_materials_transmission'));
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
    ...(panoramas
      ? [
          `import { readRadianceInWorker } from './export/runtime/scenes/environments/read-radiance-in-worker.ts';`,
          `import { text as radianceText } from './${WORKERS_FOLDER}decode-radiance.gen.ts';`,
          'const readRadiance = readRadianceInWorker(radianceText);',
        ]
      : []),
    ...(glass ? [`import { createGlass } from './export/runtime/scenes/glass/glass-scene.ts';`] : []),
    ...(labels ? [`import { createLabelLayer } from './export/page/label-layer.ts';`] : []),
    ...(takesPanorama ? [`import { createPagePanorama as createPanorama } from './export/page/panorama-step/page-panorama.ts';`] : []),
    ...(enters && singleFile ? [`import * as sessions from '${SESSIONS_MODULE}';`] : []),
    ...(enters && !singleFile ? shareLines() : []),
    ...decoders.map((name) => `import { ${OPENERS[name]} } from './export/runtime/scenes/models/decoders/${name}.ts';`),
    ...played.map((type, i) => `import * as node${i} from ${JSON.stringify(`./${fileOf(type)}`)};`),
    `const modules = { ${played.map((type, i) => `${JSON.stringify(type)}: node${i}`).join(', ')} };`,
    `const decoders = { ${decoders.map((name) => `${name}: ${OPENERS[name]}`).join(', ')} };`,
    `const createScenes = ${scenes ? `(files) => createScenesWith({ ${tools.join(', ')} })` : 'null'};`,
    `startPage(window, { modules, createScenes, createSpatial${orNull(spatial)}, inputs: ${input ? 'SESSION_INPUTS' : 'null'}, createLabelLayer${orNull(labels)}, createPanorama${orNull(takesPanorama)}, loadSessions: ${loadSessions} });`,
  ];
  return lines.join('\n');
}

function shareLines(): string[] {
  const imports = Object.entries(SHARED).map(([file, names]) => `import { ${names.join(', ')} } from './${file}';`);
  return [...imports, `globalThis.${SHARED_GLOBAL} = { ${Object.values(SHARED).flat().join(', ')} };`];
}

/** The text of the script with the sessions that a visitor enters: an `EnteredSessions` as a module. */
export function sessionsEntry({ scenes, controls, input, readsView, capabilities, tiers }: PageUse): string {
  const part = (isUsed: boolean, exported: string, name: string, file: string): string =>
    isUsed ? `export { ${name} as ${exported} } from './export/${file}';` : `export const ${exported} = null;`;
  return [
    part(true, 'requestWebXr', 'requestWebXrSession', 'runtime/sessions/webxr/request-session.ts'),
    part(tiers.has('camera'), 'requestCamera', 'requestCameraSession', 'runtime/sessions/camera/request-camera.ts'),
    part(scenes && tiers.has('camera'), 'createLens', 'createLens', 'runtime/sessions/camera/lens.ts'),
    part(controls, 'createRoomPanel', 'createRoomPanel', 'page/room-panel/room-panel.ts'),
    // Of a page that reads no input, for the panel that offers a scan.
    part(capabilities.has('planes') && !input, 'inputs', 'SESSION_INPUTS', 'runtime/sessions/input/session-inputs.ts'),
    part(capabilities.has('planes'), 'offerRoomScan', 'offerRoomScan', 'page/room-scan.ts'),
    part(true, 'texts', 'SESSION_TEXTS', 'page/entered-sessions.ts'),
    part(readsView && tiers.has('camera'), 'cameraHint', 'CAMERA_HINT', 'page/entered-sessions.ts'),
  ].join('\n');
}

function orNull(isUsed: boolean): string {
  return isUsed ? '' : ': null';
}
