import type { NodeContext, NodeRuntime } from '../../kit/runtime.ts';
import type { definition } from './definition.ts';

/** The param is a count, not an event, so that no press between two frames is lost. */
export function create(ctx: NodeContext<typeof definition>): NodeRuntime {
  const { presses } = ctx.params;
  /** Null before the first frame: earlier presses do not count. */
  let seen: number | null = null;
  let pressed = 0;
  return {
    update: () => {
      const now = Math.floor(presses.value);
      for (let count = seen ?? now; count < now; count++) ctx.outputs.pressed.emit().number = ++pressed;
      seen = now;
    },
    reset: () => {
      seen = null;
      pressed = 0;
    },
    dispose: () => {},
  };
}
