import type { NodeContext, NodeRuntime } from '../../kit/runtime.ts';
import type { definition } from './definition.ts';

/**
 * Plays the Time node. Time is measured from the last change of speed, not summed over frames, so that with a constant speed each frame of
 * a render can be drawn independently.
 */
export function create(ctx: NodeContext<typeof definition>): NodeRuntime {
  const { speed, loopS } = ctx.params;
  let changedAtS = 0;
  let timeThenS = 0;
  let speedSince: number | null = null;
  return {
    update: () => {
      const nowS = ctx.clock.timeS;
      if (speedSince !== null && speed.value !== speedSince) {
        timeThenS += (nowS - changedAtS) * speedSince;
        changedAtS = nowS;
      }
      speedSince = speed.value;
      const timeS = timeThenS + (nowS - changedAtS) * speedSince;
      const endS = loopS.value;
      ctx.outputs.seconds.value = endS > 0 ? timeS - endS * Math.floor(timeS / endS) : timeS;
    },
    reset: () => {
      changedAtS = 0;
      timeThenS = 0;
      speedSince = null;
    },
    dispose: () => {},
  };
}
