import type { NodeModule } from '../../nodes/kit/runtime.ts';
import { type Program, readProgram } from '../program/program.ts';
import { createFetchAssetSource } from '../runtime/assets/asset-source.ts';
import type { CreateSceneBackend } from '../runtime/scene-backend.ts';
import { noArReason } from './ar-texts.ts';
import { countingFetch } from './load-progress.ts';
import { browserFetch } from './network.ts';
import { CONFIG_ID, type PageConfig } from './page-html.ts';
import { createStage } from './stage.ts';
import { createVisit, type Visit } from './visit.ts';

/** What the page's own script hands in: the behaviour of the nodes in use, and three.js where they draw objects. */
export interface PageParts {
  readonly modules: Readonly<Record<string, NodeModule>>;
  readonly createScenes: CreateSceneBackend | null;
}

/** Runs an exported page: loads the program, shows it to be looked around, and offers AR where the browser has it. */
export async function startPage(page: Window, parts: PageParts): Promise<void> {
  const config = readConfig(page.document);
  let visit: Visit | null = null;
  const stage = createStage({
    ...config,
    document: page.document,
    onEnter: () => void visit?.enterAr(),
    onLeave: () => void visit?.lookAround(),
  });
  const { panel } = stage;
  panel.show({ kind: 'loading', progress: null });
  const expectedBytes = Object.values(config.bytes).reduce((sum, bytes) => sum + bytes, 0);
  const fetchFile = countingFetch(browserFetch(), expectedBytes, (progress) => {
    if (visit === null || !visit.isReady) panel.show({ kind: 'loading', progress });
  });
  try {
    const program = await loadProgram(new URL(config.program, page.document.baseURI), fetchFile);
    const assets = createFetchAssetSource(page.document.baseURI, fetchFile);
    const noAr = noArReason(page);
    visit = createVisit({ page, stage, program, assets, ...parts });
    await visit.ready;
    const reason = await noAr;
    panel.show(reason === null ? { kind: 'ar' } : { kind: 'view', reason });
  } catch (error) {
    panel.show({ kind: 'failed', reason: error instanceof Error ? error.message : String(error) });
  }
}

function readConfig(document: Document): PageConfig {
  const text = document.getElementById(CONFIG_ID)?.textContent;
  if (!text) throw new Error(`The page has no #${CONFIG_ID}.`);
  return JSON.parse(text) as PageConfig;
}

async function loadProgram(url: URL, fetchFile: typeof fetch): Promise<Program> {
  const response = await fetchFile(url).catch(() => null);
  if (!response?.ok) throw new Error('The page could not be loaded whole. Check the connection, then reload it.');
  return readProgram(await response.json());
}
