import { createRandom } from '../../runtime/random.ts';

/** How a sensor's depth differs from the truth. Each shot has noise of its own, the same every time. */
export interface DepthNoise {
  /** Standard deviation: `sigmaM` and, for each meter of distance, `sigmaPerM` more. */
  readonly sigmaM?: number;
  readonly sigmaPerM?: number;
  /** Share of the texels about which nothing is known, in [0, 1]. */
  readonly holes?: number;
  readonly seed?: number;
}

/** Smallest distance told; nearer would mean unknown. */
const NEAREST_M = 0.001;

/** Spoils exact meters in place; 0 stays unknown. `shot` names the picture that is spoiled. */
export function addDepthNoise(meters: Float32Array, { sigmaM = 0, sigmaPerM = 0, holes = 0, seed = 0 }: DepthNoise, shot: string): void {
  const { next } = createRandom(seed, shot);
  for (let i = 0; i < meters.length; i++) {
    // Drawn for every texel, so that one distance more or less leaves the others' noise alone.
    const [a, b, c] = [next(), next(), next()];
    const exact = meters[i] ?? 0;
    if (exact === 0) continue;
    // Box and Muller 1958: 1 − a is never 0.
    const normal = Math.sqrt(-2 * Math.log(1 - a)) * Math.cos(2 * Math.PI * b);
    meters[i] = c < holes ? 0 : Math.max(exact + normal * (sigmaM + sigmaPerM * exact), NEAREST_M);
  }
}
