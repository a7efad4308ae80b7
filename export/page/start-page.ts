import type { NodeModule } from '../../nodes/kit/runtime.ts';
import { type Program, readProgram } from '../program/program.ts';
import { type AssetSource, createFetchAssetSource } from '../runtime/assets/asset-source.ts';
import type { CreateSceneBackend } from '../runtime/scene-backend.ts';
import type { DecoderFiles } from '../runtime/scenes/models/decoders/decoder.ts';
import { createEmbeddedAssetSource, hasEmbeddedFiles } from './embedded-files.ts';
import { countingFetch } from './load-progress.ts';
import { browserFetch } from './network.ts';
import { keepForOffline } from './offline.ts';
import { CONFIG_ID, type PageConfig } from './page-html.ts';
import { createStage } from './stage.ts';
import { createVisit, type Visit } from './visit.ts';
import { findWays, lacksOf } from './way-texts.ts';

/** What the page's own script hands in: the behaviour of the nodes in use, and three.js where they draw objects. */
export interface PageParts {
  readonly modules: Readonly<Record<string, NodeModule>>;
  readonly createScenes: ((files: DecoderFiles) => CreateSceneBackend) | null;
}

/** Runs an exported page: loads the program, shows it to be looked around, and offers what the browser and the device have. */
export async function startPage(page: Window, parts: PageParts): Promise<void> {
  const { document } = page;
  const config = readConfig(document);
  let visit: Visit | null = null;
  const stage = createStage({
    ...config,
    document,
    lacks: { camera: lacksOf(config.tiers, 'camera'), orbit: lacksOf(config.tiers, 'orbit') },
    totalBytes: Object.values(config.bytes).reduce((sum, bytes) => sum + bytes, 0),
    onSet: ({ node, param }, value) => visit?.setParam(node, param, value),
    onEnter: (way) => void visit?.enter(way),
    onLeave: () => void visit?.lookAround(),
  });
  const { panel } = stage;
  panel.show({ kind: 'loading', loadedBytes: 0 });
  const fetchFile = countingFetch(browserFetch(), (loadedBytes) => {
    if (visit === null || !visit.isReady) panel.show({ kind: 'loading', loadedBytes });
  });
  const files = hasEmbeddedFiles(document) ? createEmbeddedAssetSource(document) : createFetchAssetSource(document.baseURI, fetchFile);
  try {
    const found = findWays(page, config.tiers);
    const program = await loadProgram(files, config.program);
    const ways = await found;
    const createScenes = parts.createScenes?.((file) => files.load(config.decoders[file] ?? file)) ?? null;
    visit = createVisit({ page, stage, program, assets: files, ways, modules: parts.modules, createScenes });
    await visit.ready;
    panel.show({ kind: 'ready', offers: ways.offers, reason: ways.noAr });
    stage.showPicture();
  } catch (error) {
    panel.show({ kind: 'failed', reason: error instanceof Error ? error.message : String(error) });
  }
  if (config.offline !== null) await keepForOffline(page, config.offline);
}

function readConfig(document: Document): PageConfig {
  const text = document.getElementById(CONFIG_ID)?.textContent;
  if (!text) throw new Error(`The page has no #${CONFIG_ID}.`);
  return JSON.parse(text) as PageConfig;
}

async function loadProgram(files: AssetSource, path: string): Promise<Program> {
  const bytes = await files.load(path).catch(() => {
    throw new Error('The page could not be loaded whole. Check the connection, then reload it.');
  });
  return readProgram(JSON.parse(new TextDecoder().decode(bytes)));
}
