import type { NodeContext, NodeRuntime } from '../../kit/runtime.ts';
import type { definition } from './definition.ts';

/** The most samples that are kept: ten seconds at 200 frames per second. */
const CAPACITY = 2000;

export function create(ctx: NodeContext<typeof definition>): NodeRuntime {
  /** A ring buffer of `count` samples; the newest is at `newest`. */
  const times = new Float64Array(CAPACITY);
  const numbers = new Float64Array(CAPACITY);
  let newest = -1;
  let count = 0;
  let delayS = 0;

  const place = (age: number): number => (newest - age + CAPACITY) % CAPACITY;

  function numberAt(timeS: number): number {
    let age = 0;
    while (age < count - 1 && (times[place(age)] ?? 0) > timeS) age++;
    const before = place(age);
    const numberBefore = numbers[before] ?? 0;
    const timeBefore = times[before] ?? 0;
    if (age === 0 || timeBefore > timeS) return numberBefore;
    const after = place(age - 1);
    const along = (timeS - timeBefore) / ((times[after] ?? 0) - timeBefore);
    return numberBefore + ((numbers[after] ?? 0) - numberBefore) * along;
  }

  return {
    update: () => {
      ctx.outputs.result.value = count === 0 ? ctx.params.start.value : numberAt(ctx.clock.timeS - delayS);
    },
    remember: () => {
      const { timeS } = ctx.clock;
      delayS = Math.max(ctx.params.delayS.value, 0);
      // After a seek backwards the history is invalid.
      if (count > 0 && timeS < (times[newest] ?? 0)) count = 0;
      if (count === 0 || timeS > (times[newest] ?? 0)) {
        newest = (newest + 1) % CAPACITY;
        count = Math.min(count + 1, CAPACITY);
      }
      times[newest] = timeS;
      numbers[newest] = ctx.params.number.value;
    },
    reset: () => {
      newest = -1;
      count = 0;
    },
    dispose: () => {},
  };
}
