import type { AudioAsset } from '../../kit/sound.ts';

/** The sound of a struck body: partials that ring, and the noise of the blow. */
interface Material {
  readonly durationS: number;
  /** The partials: frequency, amplitude, and the time in which the amplitude falls to 1/e. */
  readonly partials: readonly (readonly [frequencyHz: number, amplitude: number, decayS: number])[];
  readonly noise: number;
  readonly noiseDecayS: number;
  /** For the noise: the fraction of the previous sample that each sample keeps; more is duller. */
  readonly dullness: number;
}

export type StruckMaterial = 'glass' | 'metal' | 'wood' | 'soft';

const SAMPLE_RATE_HZ = 48_000;
/** Time in which the sound rises from silence, so that it does not click. */
const ATTACK_S = 0.0004;

/**
 * Partials of free solids: the ratios of a free bar (1, 2.756, 5.404; Rossing, “Science of Percussion Instruments”, 2000) for wood and
 * glass; of a thin shell, many that are close to each other, for tin.
 */
const MATERIALS: Readonly<Record<StruckMaterial, Material>> = {
  glass: {
    durationS: 0.18,
    partials: [
      [3200, 0.5, 0.03],
      [8820, 0.3, 0.016],
      [5150, 0.25, 0.02],
      [12100, 0.12, 0.008],
    ],
    noise: 0.25,
    noiseDecayS: 0.0025,
    dullness: 0.1,
  },
  metal: {
    durationS: 0.7,
    partials: [
      [612, 0.22, 0.09],
      [941, 0.26, 0.13],
      [1377, 0.24, 0.16],
      [1893, 0.18, 0.12],
      [2611, 0.14, 0.1],
      [3742, 0.1, 0.07],
      [5180, 0.06, 0.05],
    ],
    noise: 0.35,
    noiseDecayS: 0.012,
    dullness: 0.35,
  },
  wood: {
    durationS: 0.25,
    partials: [
      [520, 0.6, 0.035],
      [1433, 0.3, 0.018],
      [2810, 0.12, 0.009],
    ],
    noise: 0.4,
    noiseDecayS: 0.006,
    dullness: 0.7,
  },
  soft: {
    durationS: 0.3,
    partials: [
      [82, 0.8, 0.06],
      [131, 0.35, 0.04],
    ],
    noise: 0.5,
    noiseDecayS: 0.02,
    dullness: 0.93,
  },
};

/** Computes the sound of a blow; the result is the same each time. Its peak is 1. */
export function strike(name: StruckMaterial): AudioAsset {
  const { durationS, partials, noise, noiseDecayS, dullness } = MATERIALS[name];
  const samples = new Float32Array(Math.round(durationS * SAMPLE_RATE_HZ));
  let seed = 1;
  let dull = 0;
  for (let i = 0; i < samples.length; i++) {
    const timeS = i / SAMPLE_RATE_HZ;
    // Numerical Recipes’ “quick and dirty” generator.
    seed = (Math.imul(seed, 1_664_525) + 1_013_904_223) >>> 0;
    dull += (1 - dullness) * (seed / 2 ** 31 - 1 - dull);
    let sum = noise * dull * Math.exp(-timeS / noiseDecayS);
    for (const [frequencyHz, amplitude, decayS] of partials) {
      sum += amplitude * Math.exp(-timeS / decayS) * Math.sin(2 * Math.PI * frequencyHz * timeS);
    }
    samples[i] = sum * Math.min(1, timeS / ATTACK_S) * Math.min(1, (durationS - timeS) / 0.02);
  }
  const peak = samples.reduce((most, sample) => Math.max(most, Math.abs(sample)), 0);
  for (let i = 0; i < samples.length; i++) samples[i] = (samples[i] ?? 0) / peak;
  return { durationS, sampleRateHz: SAMPLE_RATE_HZ, channels: [samples] };
}
