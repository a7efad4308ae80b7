import type { NodeContext, NodeRuntime } from '../../kit/runtime.ts';
import type { definition } from './definition.ts';

/**
 * The exact solution of a damped oscillator for a target that is constant during a frame: `e″ + 2ζω e′ + ω² e = 0`, where `ω = 2πf` and `e`
 * is the distance from the target. Semi-implicit Euler steps are not used: they diverge if `ω Δt` exceeds 2, as with a spring of 30 Hz
 * below 95 frames per second.
 */
export function create(ctx: NodeContext<typeof definition>): NodeRuntime {
  const { number, frequencyHz, damping } = ctx.params;
  let at: number | null = null;
  let speed = 0;

  function move(deltaS: number, target: number, from: number): number {
    const omega = 2 * Math.PI * frequencyHz.value;
    if (!(omega > 0)) return from;
    const zeta = Math.max(damping.value, 0);
    const decay = zeta * omega;
    const way = from - target;
    const turn = omega * Math.sqrt(Math.abs(zeta * zeta - 1));
    let cosine: number;
    let sine: number;
    // Both contain e^(−ζωΔt), and the sine is divided by its frequency, so they stay finite in long frames and near critical damping.
    if (turn * deltaS < 1e-6) {
      cosine = Math.exp(-decay * deltaS);
      sine = deltaS * cosine;
    } else if (zeta < 1) {
      cosine = Math.exp(-decay * deltaS) * Math.cos(turn * deltaS);
      sine = (Math.exp(-decay * deltaS) * Math.sin(turn * deltaS)) / turn;
    } else {
      const slow = Math.exp((turn - decay) * deltaS);
      const fast = Math.exp(-(turn + decay) * deltaS);
      cosine = (slow + fast) / 2;
      sine = (slow - fast) / (2 * turn);
    }
    const next = way * cosine + (speed + decay * way) * sine;
    speed = speed * cosine - (omega * omega * way + decay * speed) * sine;
    return target + next;
  }

  return {
    update: () => {
      const target = number.value;
      if (at === null || ctx.inputs.jump.count > 0) {
        at = target;
        speed = 0;
      } else {
        at = move(ctx.clock.deltaS, target, at);
      }
      ctx.outputs.result.value = at;
      ctx.outputs.speed.value = speed;
    },
    reset: () => {
      at = null;
      speed = 0;
    },
    dispose: () => {},
  };
}
