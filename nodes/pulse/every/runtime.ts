import { PULSE_CAPACITY } from '../../kit/pulse-capacity.ts';
import type { NodeContext, NodeRuntime } from '../../kit/runtime.ts';
import type { definition } from './definition.ts';

/** Counted from the last change of the period rather than added up, so that no error gathers over an hour. */
export function create(ctx: NodeContext<typeof definition>): NodeRuntime {
  const { periodS } = ctx.params;
  let periodSince = Number.NaN;
  let changedAtS = 0;
  /** Periods that had gone by then. */
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
      // A frame at 3 × 0.1 s is there 5e-17 s too early to count three periods.
      const due = Math.floor(goneAt(nowS) + 1e-9) + 1;
      // After a long stall the pulses that were missed are not made up for.
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
