import type { NodeContext, NodeRuntime } from '../../kit/runtime.ts';
import { PULSE_CAPACITY } from '../../kit/runtime.ts';
import type { definition } from './definition.ts';

/**
 * Plays the Interval node. The number of pulses is computed from the time since the last change of the period, not summed, so that rounding
 * errors do not accumulate.
 */
export function create(ctx: NodeContext<typeof definition>): NodeRuntime {
  const { periodS } = ctx.params;
  let periodSince = Number.NaN;
  let changedAtS = 0;
  /** The number of periods that had passed when the period last changed. */
  let gone = 0;
  let given = 0;

  const goneAt = (timeS: number): number => gone + (periodSince > 0 ? (timeS - changedAtS) / periodSince : 0);

  return {
    update: () => {
      const nowS = ctx.clock.timeS;
      if (periodS.value !== periodSince) {
        const isFirst = Number.isNaN(periodSince);
        gone = isFirst ? 0 : goneAt(nowS);
        if (isFirst && !ctx.config.atOnce) given = 1;
        changedAtS = nowS;
        periodSince = periodS.value;
      }
      if (!(periodSince > 0)) return;
      // Rounding: a frame at 3 × 0.1 s is 5e-17 s too early for the third period.
      const due = Math.floor(goneAt(nowS) + 1e-9) + 1;
      // After a long stall, missed pulses beyond the capacity of a frame are dropped.
      given = Math.max(given, due - PULSE_CAPACITY);
      const from = ctx.config.atOnce ? 0 : 1;
      while (given < due) ctx.outputs.pulse.emit().number = ++given - from;
    },
    reset: () => {
      periodSince = Number.NaN;
      given = 0;
    },
    dispose: () => {},
  };
}
