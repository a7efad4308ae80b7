import type { PlayedModule } from '../../../nodes/kit/cpu-filter.ts';
import type { TakenPanorama } from '../../../nodes/kit/taken-panorama.ts';
import type { Program } from '../../program/program.ts';
import type { PageRoot } from '../page-root.ts';
import { createPanoramaCard } from './panorama-card.ts';
import { createPanoramaStep, type PanoramaStep } from './panorama-step.ts';
import { createPanoramaStorage } from './panorama-storage.ts';
import { createStepBar } from './step-bar.ts';

export interface PagePanoramaOptions {
  readonly page: Window;
  readonly root: PageRoot;
  readonly program: Program;
  readonly modules: Readonly<Record<string, PlayedModule>>;
  readonly gl: WebGL2RenderingContext;
  readonly setPanorama: (panorama: TakenPanorama | null) => void;
}

export type CreatePagePanorama = (options: PagePanoramaOptions) => PanoramaStep;

const TYPE = 'source/panorama-capture';

/** Adds the step that takes a panorama, and its elements, to a page whose program has the node `source/panorama-capture`. */
export const createPagePanorama: CreatePagePanorama = ({ page, root, program, modules, gl, setPanorama }) => {
  const { document } = page;
  const node = program.operations.find((operation) => 'type' in operation && operation.type === TYPE);
  const module = modules[TYPE];
  if (!node || !('type' in node) || !module || !('worker' in module) || module.worker === undefined) {
    throw new Error(`The program has no node of the type ${TYPE}.`);
  }
  const widthPx = Number(node.config.size);
  const storage = createPanoramaStorage(() => page.indexedDB, page.location.pathname);
  const bar = createStepBar(document);
  root.overlay.append(bar.element);
  const step = createPanoramaStep({
    gl,
    bar,
    notices: root.notices,
    storage,
    worker: module.worker,
    widthPx,
    hasFile: Object.values(node.assets).some((asset) => asset !== null),
    setPanorama,
  });
  const card = createPanoramaCard({ document, storage, widthPx, onUse: step.use, onForget: step.forget });
  root.panel.element.querySelector('#panel-body')?.append(card);
  return step;
};
