import type { NodeContext, NodeRuntime } from '../../kit/runtime.ts';
import type { definition } from './definition.ts';
import { gradientNoise } from './gradient-noise.ts';

/**
 * Offset of the coordinates to between the integers: gradient noise is 0 at integer coordinates, so noise along an axis would be 0 at each
 * of them.
 */
const BETWEEN = [0.37, 0.61, 0.43] as const;
/** Difference between the seeds of two components, so that they are independent. */
const APART = 0x3c6ef372;

export function create(ctx: NodeContext<typeof definition>): NodeRuntime {
  const { along, place, frequency, low, high } = ctx.params;
  const octaves = Math.max(1, Math.floor(ctx.config.octaves));
  const vector = new Float64Array(3);
  /** The maximum of the sum of octaves. */
  const most = 2 - 2 ** (1 - octaves);

  function noise(seed: number): number {
    const px = place.value[0] ?? 0;
    const py = place.value[1] ?? 0;
    const pz = place.value[2] ?? 0;
    let sum = 0;
    for (let octave = 0; octave < octaves; octave++) {
      const scale = frequency.value * 2 ** octave;
      const x = (along.value + px) * scale + BETWEEN[0];
      sum += gradientNoise(x, py * scale + BETWEEN[1], pz * scale + BETWEEN[2], seed + octave) / 2 ** octave;
    }
    const part = Math.min(Math.max(sum / most, -1), 1) * 0.5 + 0.5;
    return low.value + (high.value - low.value) * part;
  }

  return {
    update: () => {
      const { seed } = ctx.config;
      vector[0] = noise(seed);
      vector[1] = noise(seed + APART);
      vector[2] = noise(seed + 2 * APART);
      ctx.outputs.number.value = vector[0];
      ctx.outputs.vector.value = vector;
    },
    dispose: () => {},
  };
}
