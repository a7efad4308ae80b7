import type { NodeContext, NodeRuntime } from '../../kit/runtime.ts';
import type { definition } from './definition.ts';

/** Plays the Button node. Its param counts presses, so that no press between two frames is lost. */
export function create(ctx: NodeContext<typeof definition>): NodeRuntime {
  const { presses } = ctx.params;
  /** The count in the previous frame. Null before the first frame: presses before it do not count. */
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
