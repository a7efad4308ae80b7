import type { SessionFrame } from '../../../nodes/kit/session.ts';
import type { Program } from '../../program/program.ts';
import type { Engine } from '../engine.ts';
import { EMPTY_FRAME, enterView } from '../play-state.ts';
import { createSessionFrame } from '../sessions/session-frame.ts';
import { makesValues, type NodeInstances } from './node-instances.ts';
import type { Step } from './step.ts';

/** Compiles the materials of the objects that a program draws, in an empty world. Returns at once where there are none. */
export async function prepareMaterials(engine: Engine, program: Program, { nodes }: NodeInstances, steps: readonly Step[]): Promise<void> {
  const { state } = engine;
  const backend = engine.scenesIfMade();
  if (!backend) return;
  state.frame = createEmptyWorld();
  enterView(state, 0);
  for (const [id, { runtime }] of nodes) {
    // Nodes with state begin with the first frame.
    if (makesValues(program, id)) runtime.prepare?.();
    else runtime.update(state.frame);
  }
  const compiled = backend.prepare(() => {
    for (const step of steps) step.prepare?.(state);
  });
  state.frame = EMPTY_FRAME;
  await compiled;
}

const PREPARED_SIDE_PX = 64;

/** A frame with one view of an empty world. */
function createEmptyWorld(): SessionFrame {
  const frame = createSessionFrame();
  const [view] = frame.views;
  frame.viewCount = 1;
  if (view) {
    view.viewport.widthPx = PREPARED_SIDE_PX;
    view.viewport.heightPx = PREPARED_SIDE_PX;
  }
  return frame;
}
