import type { NodeContext, NodeRuntime } from '../../kit/runtime.ts';
import type { definition } from './definition.ts';

export function create(ctx: NodeContext<typeof definition>): NodeRuntime {
  const { low, high, whole } = ctx.params;
  let state = 0;
  /** The last random number, in [0, 1). It is stored instead of the result, so that changes of the limits apply to it. */
  let drawn: number | null = null;

  /** Draws the next random number, by Mulberry32 (Tommy Ettinger, 2017, public domain), seeded from `ctx.random` and the seed param. */
  function next(): number {
    state = (state + 0x6d2b79f5) | 0;
    let mixed = Math.imul(state ^ (state >>> 15), 1 | state);
    mixed = (mixed + Math.imul(mixed ^ (mixed >>> 7), 61 | mixed)) ^ mixed;
    return ((mixed ^ (mixed >>> 14)) >>> 0) / 2 ** 32;
  }

  return {
    update: () => {
      if (drawn === null) {
        state = Math.floor(ctx.random() * 2 ** 32) ^ Math.imul(ctx.config.seed, 0x9e3779b1);
        drawn = next();
      }
      for (let i = 0; i < ctx.inputs.draw.count; i++) drawn = next();
      const from = Math.min(low.value, high.value);
      const to = Math.max(low.value, high.value);
      const least = Math.ceil(from);
      const number = whole.value ? least + Math.floor(drawn * (Math.floor(to) - least + 1)) : from + (to - from) * drawn;
      ctx.outputs.number.value = number;
    },
    reset: () => {
      drawn = null;
    },
    dispose: () => {},
  };
}
