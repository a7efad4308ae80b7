/** Computes the spectrum of a sound: the amplitude of each band of frequencies. */
export interface Spectrum {
  /** Writes the amplitudes of `bins.length` equal bands from 0 Hz to half the sample rate, from the last samples of `samples`. */
  measure(samples: Float32Array, bins: Float32Array): void;
}

/**
 * Creates a discrete Fourier transform of the last `2 × binCount` samples under a Hann window, by Cooley and Tukey's radix-2 algorithm
 * (Mathematics of Computation 19, 1965). A sine of amplitude a that fits the window gives a at its bin and a / 2 at both neighbors; the
 * gain of the window is compensated. `binCount` must be a power of two.
 */
export function createSpectrum(binCount: number): Spectrum {
  const size = binCount * 2;
  if (!Number.isInteger(Math.log2(size))) throw new Error('A spectrum has a power of two of bins.');
  const real = new Float64Array(size);
  const imaginary = new Float64Array(size);
  const window = Float64Array.from({ length: size }, (_, i) => 0.5 - 0.5 * Math.cos((2 * Math.PI * i) / size));
  const reversed = bitReversal(size);
  const cosines = Float64Array.from({ length: size / 2 }, (_, i) => Math.cos((2 * Math.PI * i) / size));
  const sines = Float64Array.from({ length: size / 2 }, (_, i) => Math.sin((2 * Math.PI * i) / size));

  function transform(): void {
    for (let half = 1; half < size; half *= 2) {
      const step = size / (half * 2);
      for (let start = 0; start < size; start += half * 2) {
        for (let i = 0; i < half; i++) {
          const even = start + i;
          const odd = even + half;
          const cos = cosines[i * step] ?? 0;
          const sin = sines[i * step] ?? 0;
          const re = (real[odd] ?? 0) * cos + (imaginary[odd] ?? 0) * sin;
          const im = (imaginary[odd] ?? 0) * cos - (real[odd] ?? 0) * sin;
          real[odd] = (real[even] ?? 0) - re;
          imaginary[odd] = (imaginary[even] ?? 0) - im;
          real[even] = (real[even] ?? 0) + re;
          imaginary[even] = (imaginary[even] ?? 0) + im;
        }
      }
    }
  }

  return {
    measure: (samples, bins) => {
      const first = samples.length - size;
      for (let i = 0; i < size; i++) {
        const at = reversed[i] ?? 0;
        real[i] = (samples[first + at] ?? 0) * (window[at] ?? 0);
        imaginary[i] = 0;
      }
      transform();
      // The values of the window add up to half its length, and a sine has two frequencies, one of them negative.
      for (let bin = 0; bin < binCount; bin++) {
        const scale = bin === 0 ? 2 / size : 4 / size;
        bins[bin] = Math.hypot(real[bin] ?? 0, imaginary[bin] ?? 0) * scale;
      }
    },
  };
}

function bitReversal(size: number): Uint32Array {
  const reversed = new Uint32Array(size);
  for (let i = 1; i < size; i++) reversed[i] = ((reversed[i >> 1] ?? 0) >> 1) | (i & 1 ? size >> 1 : 0);
  return reversed;
}
