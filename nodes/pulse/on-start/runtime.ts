import type { NodeContext, NodeRuntime } from '../../kit/runtime.ts';
import type { definition } from './definition.ts';

export function create(ctx: NodeContext<typeof definition>): NodeRuntime {
  let beganAtS: number | null = null;
  let done = false;
  return {
    update: () => {
      beganAtS ??= ctx.clock.timeS;
      if (done || ctx.clock.timeS - beganAtS < ctx.params.delayS.value) return;
      done = true;
      ctx.outputs.pulse.emit();
    },
    reset: () => {
      beganAtS = null;
      done = false;
    },
    dispose: () => {},
  };
}
