import { describe, expect, test } from '@jest/globals';
import { createSpectrum } from './spectrum.ts';

function measure(samples: Float32Array, binCount: number): Float32Array {
  const bins = new Float32Array(binCount);
  createSpectrum(binCount).measure(samples, bins);
  return bins;
}

/** By the definition of the transform, one sum per frequency. */
function slowly(samples: Float32Array, binCount: number): number[] {
  const size = binCount * 2;
  const last = samples.subarray(samples.length - size);
  return Array.from({ length: binCount }, (_, bin) => {
    let re = 0;
    let im = 0;
    last.forEach((sample, i) => {
      const windowed = sample * (0.5 - 0.5 * Math.cos((2 * Math.PI * i) / size));
      re += windowed * Math.cos((2 * Math.PI * bin * i) / size);
      im -= windowed * Math.sin((2 * Math.PI * bin * i) / size);
    });
    return (Math.hypot(re, im) * (bin === 0 ? 2 : 4)) / size;
  });
}

describe('a spectrum', () => {
  test('is the discrete Fourier transform of the last samples under a Hann window', () => {
    // Anything but regular, and the same every time.
    const samples = Float32Array.from({ length: 700 }, (_, i) => Math.sin(i * i * 0.013) * 0.4 + Math.cos(i * 1.7) * 0.3 + 0.1);
    const quick = measure(samples, 128);
    slowly(samples, 128).forEach((amplitude, bin) => {
      expect(quick[bin]).toBeCloseTo(amplitude, 5);
    });
  });

  test('shows a tone at its bin with its amplitude, half of it beside, and nothing elsewhere', () => {
    // 1,500 Hz at 48 kHz: 48000 / 1024 Hz a bin, so bin 32.
    const tone = Float32Array.from({ length: 4096 }, (_, i) => 0.5 * Math.sin((2 * Math.PI * 1500 * i) / 48_000));
    const bins = measure(tone, 512);
    expect(bins.indexOf(Math.max(...bins))).toBe(32);
    expect([...bins.subarray(30, 35)].map((value) => Number(value.toFixed(4)))).toEqual([0, 0.25, 0.5, 0.25, 0]);
    expect(Math.max(...bins.subarray(40))).toBeLessThan(1e-4);
  });

  test('shows what does not move at 0 Hz', () => {
    expect(measure(new Float32Array(1024).fill(0.3), 256)[0]).toBeCloseTo(0.3, 5);
  });

  test('is silent in silence, and has a power of two of bins', () => {
    expect([...measure(new Float32Array(64), 32)]).toEqual(new Array(32).fill(0));
    expect(() => createSpectrum(48)).toThrow('power of two');
  });
});
