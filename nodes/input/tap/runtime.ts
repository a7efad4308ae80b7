import type { NodeContext, NodeRuntime } from '../../kit/runtime.ts';
import type { Tap } from '../../kit/session.ts';
import type { definition } from './definition.ts';

export function create(ctx: NodeContext<typeof definition>): NodeRuntime {
  const { by } = ctx.config;
  const point = new Float64Array(3);
  let count = 0;
  const lastRay = new Float32Array(16);

  function matters(tap: Tap): boolean {
    return by === 'any' || (tap.by === 'screen') === (by === 'screen');
  }

  return {
    update: ({ input }) => {
      for (let i = 0; i < input.tapCount; i++) {
        const tap = input.taps[i];
        if (!tap || !matters(tap)) continue;
        count++;
        lastRay.set(tap.worldFromRay);
        const pulse = ctx.outputs.tapped.emit();
        pulse.number = count;
        pulse.setPose(tap.worldFromRay);
      }
      for (let row = 0; row < 3; row++) {
        const along = (lastRay[12 + row] ?? 0) - (lastRay[8 + row] ?? 0) * ctx.params.distanceM.value;
        point[row] = count === 0 ? (ctx.params.start.value[row] ?? 0) : along;
      }
      ctx.outputs.point.value = point;
    },
    reset: () => {
      count = 0;
    },
    dispose: () => {},
  };
}
