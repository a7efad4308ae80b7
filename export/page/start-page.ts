import type { NodeModule } from '../../nodes/kit/runtime.ts';
import type { Program } from '../program/program.ts';
import { readProgram } from '../program/read-program.ts';
import { type AssetSource, createFetchAssetSource } from '../runtime/assets/asset-source.ts';
import type { CreateSceneBackend } from '../runtime/scene-backend.ts';
import type { DecoderFiles } from '../runtime/scenes/models/decoders/decoder.ts';
import type { SessionInputs } from '../runtime/sessions/input/session-inputs.ts';
import type { CreateSpatial, KeptAnchors } from '../runtime/spatial/spatial.ts';
import { createControlValues } from './control-values.ts';
import { createEmbeddedAssetSource, hasEmbeddedFiles } from './embedded-files.ts';
import type { EnteredSessions } from './entered-sessions.ts';
import type { CreateLabelLayer } from './label-layer.ts';
import { countingFetch } from './load-progress.ts';
import { browserFetch } from './network.ts';
import { createPageController, type PageController } from './page-controller.ts';
import { CONFIG_ID, type PageConfig } from './page-html.ts';
import { createPageRoot } from './page-root.ts';
import type { CreatePagePanorama } from './panorama-step/page-panorama.ts';
import { findSessionModes, lacksOf, NOT_LOADED } from './session-modes.ts';

/** Parts that the page's own script supplies: the runtimes of its nodes, and optional modules. */
export interface PageParts {
  readonly modules: Readonly<Record<string, NodeModule>>;
  readonly createScenes: ((files: DecoderFiles) => CreateSceneBackend) | null;
  readonly createSpatial: CreateSpatial | null;
  /** Functions by which sessions read input; null if the program reads no input. */
  readonly inputs: SessionInputs | null;
  /** Creates the element that contains labels; null if there are no labels. */
  readonly createLabelLayer: CreateLabelLayer | null;
  /** Creates the step that takes a panorama of the room; null if the program uses none. */
  readonly createPanorama: CreatePagePanorama | null;
  /**
   * Loads the sessions that a visitor enters from the path of their script, or returns those of the page's own script; null if the program
   * plays in none.
   */
  readonly loadSessions: ((path: string) => Promise<EnteredSessions>) | null;
}

/** Runs an exported page: loads the program, starts the orbit view and offers the available session modes. */
export async function startPage(page: Window, parts: PageParts): Promise<void> {
  const { document } = page;
  const config = readConfig(document);
  let controller: PageController | null = null;
  const values = createControlValues(config.controls, ({ node, param }, value) => controller?.setParam(node, param, value));
  const root = createPageRoot({
    ...config,
    document,
    values,
    lacks: { camera: lacksOf(config.tiers, 'camera'), vr: lacksOf(config.tiers, 'authored-vr'), orbit: lacksOf(config.tiers, 'orbit') },
    totalBytes: Object.values(config.bytes).reduce((sum, bytes) => sum + bytes, 0),
    onEnter: (mode) => void controller?.enter(mode),
    onLeave: () => void controller?.lookAround(),
  });
  const { panel } = root;
  panel.show({ kind: 'loading', loadedBytes: 0 });
  const fetchFile = countingFetch(browserFetch(), (loadedBytes) => {
    if (controller === null || !controller.isReady) panel.show({ kind: 'loading', loadedBytes });
  });
  const files = hasEmbeddedFiles(document) ? createEmbeddedAssetSource(document) : createFetchAssetSource(document.baseURI, fetchFile);
  try {
    const found = findSessionModes(page, config.tiers);
    const program = await loadProgram(files, config.program);
    const modes = await found;
    const createScenes = parts.createScenes?.((file) => files.load(config.decoders[file] ?? file)) ?? null;
    const { modules, createSpatial, inputs, createPanorama } = parts;
    let sessions: EnteredSessions | null = null;
    controller = createPageController({
      page,
      root,
      program,
      assets: files,
      modes,
      modules,
      createScenes,
      createSpatial: createSpatial && ((given) => createSpatial({ ...given, keptAnchors: keptAnchorsOf(page) })),
      inputs,
      createPanel: (gl) => sessions?.createRoomPanel?.({ gl, document, title: config.title, values }) ?? null,
      createPanorama,
      overlay: parts.createLabelLayer?.(root) ?? null,
    });
    await controller.ready;
    root.showCanvas(createScenes ? 'behind soft' : readsRoom(program) ? 'behind' : 'gone');
    // After the first image, which needs none of them. A device with no session to enter does not load them.
    const { loadSessions } = parts;
    const entered = loadSessions !== null && modes.fallbacks.length > 0;
    if (entered) sessions = await loadSessions(config.sessions ?? '').catch(() => null);
    controller.offer(sessions, entered && sessions === null ? NOT_LOADED : modes.noAr);
  } catch (error) {
    panel.show({ kind: 'failed', reason: error instanceof Error ? error.message : String(error) });
  }
  if (config.offline === null) return;
  // The worker loads all files, and would take the connection from those that the page still waits for.
  await controller?.complete;
  await keepForOffline(page, config.offline);
}

/** Whether the orbit view lacks a part of the image: that of the camera, or of the depth of the room. */
function readsRoom({ needs }: Program): boolean {
  return needs.some(({ capability }) => capability === 'camera-image' || capability === 'depth');
}

function readConfig(document: Document): PageConfig {
  const text = document.getElementById(CONFIG_ID)?.textContent;
  if (!text) throw new Error(`The page has no #${CONFIG_ID}.`);
  return JSON.parse(text) as PageConfig;
}

async function loadProgram(files: AssetSource, path: string): Promise<Program> {
  const bytes = await files.load(path).catch(() => {
    throw new Error('The page did not load completely. Check the connection, then reload it.');
  });
  return readProgram(JSON.parse(new TextDecoder().decode(bytes)));
}

/** Returns where kept anchors are stored. In sandboxed frames and with cookies off, browsers refuse the storage. */
function keptAnchorsOf(page: Window): KeptAnchors {
  try {
    return { storage: page.localStorage, page: page.location.pathname };
  } catch {
    return { storage: null, page: page.location.pathname };
  }
}

/**
 * Registers a service worker that stores the page's files, so that the page opens offline the next time. Without support, or if the browser
 * refuses, the page works as before.
 */
async function keepForOffline({ navigator, location, isSecureContext }: Window, script: string): Promise<void> {
  if (!isSecureContext || !/^https?:$/.test(location.protocol)) return;
  try {
    // The scope is the folder of the page, so other pages of the host are not affected.
    await navigator.serviceWorker?.register(script, { updateViaCache: 'none' });
  } catch {
    // Fails in sandboxed frames, private windows and by a policy of the host.
  }
}
