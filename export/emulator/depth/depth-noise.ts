import { createRandom } from '../../runtime/random.ts';

/** Noise of a depth sensor. Each shot has its own noise, which is the same in every run. */
export interface DepthNoise {
  /** Standard deviation in meters: `sigmaM` plus `sigmaPerM` per meter of distance. */
  readonly sigmaM?: number;
  readonly sigmaPerM?: number;
  /** Fraction of texels without a value, in [0, 1]. */
  readonly holes?: number;
  readonly seed?: number;
}

/** Smallest distance reported, in meters; 0 would mean unknown. */
const NEAREST_M = 0.001;

/** Adds noise to `meters` in place; 0 stays unknown. `shot` seeds the noise. */
export function addDepthNoise(meters: Float32Array, { sigmaM = 0, sigmaPerM = 0, holes = 0, seed = 0 }: DepthNoise, shot: string): void {
  const { next } = createRandom(seed, shot);
  for (let i = 0; i < meters.length; i++) {
    // Random numbers are drawn for every texel, so one changed distance does not change the noise of the others.
    const [a, b, c] = [next(), next(), next()];
    const exact = meters[i] ?? 0;
    if (exact === 0) continue;
    // Box–Muller transform (1958); 1 − a is never 0.
    const normal = Math.sqrt(-2 * Math.log(1 - a)) * Math.cos(2 * Math.PI * b);
    meters[i] = c < holes ? 0 : Math.max(exact + normal * (sigmaM + sigmaPerM * exact), NEAREST_M);
  }
}
