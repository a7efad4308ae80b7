import { setPassState } from '../../../nodes/kit/pass-state.ts';
import type { DrawView } from '../../../nodes/kit/runtime.ts';
import type { ViewFrame } from '../../../nodes/kit/session.ts';
import type { DrawOperation, Program, ResourceId } from '../../program/program.ts';
import type { Engine } from '../engine.ts';
import { clearAll, clearRectangle } from '../gl/clear.ts';
import type { NodeInstance } from '../operations/node-instance.ts';
import { type LiveResources, liveResource } from '../resources/resources.ts';
import type { Step } from './step.ts';

/** Creates the step in which a node draws one view: into its render target, or over what the screen already shows. */
export function createDrawStep(
  engine: Engine,
  program: Program,
  operation: DrawOperation,
  instance: NodeInstance,
  resources: LiveResources,
): Step {
  const { gl } = engine.objects;
  const { runtime, effects } = instance;
  const sampled = operation.reads.flatMap((id) => {
    const resource = resources.get(id);
    return resource?.kind === 'target' ? [resource] : [];
  });
  const destination = operation.target === 'screen' ? null : liveResource(resources, operation.target, 'target');
  if (!runtime.draw) throw new Error(`The node type ${operation.type} has a drawing operation and no draw().`);
  const viewport = { x: 0, y: 0, widthPx: 0, heightPx: 0 };
  const under = engine.scenesIfMade()?.createUnder?.(program, operation, resources);
  const drawView: { -readonly [K in keyof DrawView]: DrawView[K] | null } & { viewport: typeof viewport } = {
    view: null,
    readsDepth: operation.target !== 'screen' && isDepthRead(program, operation.target),
    viewIndex: 0,
    framebuffer: null,
    viewport,
  };
  const draw = (view: ViewFrame, viewIndex: number, framebuffer: WebGLFramebuffer | null): void => {
    // `draw` starts with the target bound and GL's default state.
    setPassState(gl, framebuffer, null, viewport.x, viewport.y, viewport.widthPx, viewport.heightPx);
    drawView.view = view;
    drawView.viewIndex = viewIndex;
    drawView.framebuffer = framebuffer;
    drawView.under = under?.(view, viewIndex, viewport.widthPx, viewport.heightPx) ?? null;
    runtime.draw?.(drawView as DrawView);
  };
  return {
    prepare: ({ view, viewIndex, widthPx, heightPx }) => {
      if (!view) return;
      viewport.widthPx = widthPx;
      viewport.heightPx = heightPx;
      draw(view, viewIndex, null);
    },
    run: (state) => {
      const { view, viewIndex } = state;
      if (!view) return;
      effects?.set(state);
      // Resolves multisampled images that techniques read, before a framebuffer is bound.
      for (let i = 0; i < sampled.length; i++) sampled[i]?.target.front(sampled[i]?.domain === 'view' ? viewIndex : 0);
      if (destination) {
        const buffer = destination.target.back(viewIndex);
        clearAll(gl, buffer.framebuffer, buffer.hasDepth);
        viewport.x = 0;
        viewport.y = 0;
        viewport.widthPx = buffer.widthPx;
        viewport.heightPx = buffer.heightPx;
        draw(view, viewIndex, buffer.framebuffer);
        destination.target.finish(viewIndex);
      } else {
        viewport.x = view.viewport.x;
        viewport.y = view.viewport.y;
        viewport.widthPx = view.viewport.widthPx;
        viewport.heightPx = view.viewport.heightPx;
        const { framebuffer } = state.frame;
        clearRectangle(gl, framebuffer, viewport.x, viewport.y, viewport.widthPx, viewport.heightPx, null);
        draw(view, viewIndex, framebuffer);
        state.screenIsEmpty = false;
      }
    },
  };
}

/** Whether something reads the depth of a layer, or that of another layer in the same texture. */
function isDepthRead({ resources, taps }: Program, layer: ResourceId): boolean {
  const targets = resources.filter((resource) => resource.kind === 'target');
  const owner = targets.find(({ id }) => id === layer)?.shares ?? layer;
  const isRead = targets.some(({ id, depthRead }) => id === owner && depthRead === true);
  return isRead || Object.values(taps).some(({ depth }) => depth?.resource === layer);
}
