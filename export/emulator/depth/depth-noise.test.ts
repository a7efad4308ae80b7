import { expect, test } from '@jest/globals';
import { addDepthNoise } from './depth-noise.ts';

function noisy(exactM: number, noise: Parameters<typeof addDepthNoise>[1], shot = '0'): Float32Array {
  const meters = new Float32Array(20_000).fill(exactM);
  addDepthNoise(meters, noise, shot);
  return meters;
}

function spread(values: Float32Array): { readonly mean: number; readonly sigma: number } {
  const mean = values.reduce((sum, value) => sum + value, 0) / values.length;
  return { mean, sigma: Math.sqrt(values.reduce((sum, value) => sum + (value - mean) ** 2, 0) / values.length) };
}

test('noise is normal, centered on the truth, and grows with the distance', () => {
  const { mean, sigma } = spread(noisy(4, { sigmaM: 0.01, sigmaPerM: 0.005 }));
  expect(mean).toBeCloseTo(4, 2);
  // 1 cm + 0.5 % of 4 m; the estimate from 20,000 samples is good to 2 %.
  expect(sigma / 0.03).toBeCloseTo(1, 1);
  const beyond = noisy(4, { sigmaM: 0.01, sigmaPerM: 0.005 }).filter((value) => Math.abs(value - 4) > 0.06).length;
  expect(beyond / 20_000).toBeCloseTo(0.0455, 2);
});

test('holes are of the share asked for, and what is unknown stays so', () => {
  const holed = noisy(2, { holes: 0.1 });
  expect(holed.filter((value) => value === 0).length / holed.length).toBeCloseTo(0.1, 1);
  expect(new Set(holed.filter((value) => value !== 0))).toEqual(new Set([2]));
  expect(new Set(noisy(0, { sigmaM: 0.5 }))).toEqual(new Set([0]));
});

test('the same seed and shot give the same noise, others do not', () => {
  const noise = { sigmaM: 0.01, seed: 7 };
  expect(noisy(1, noise)).toEqual(noisy(1, noise));
  expect(noisy(1, noise)).not.toEqual(noisy(1, noise, '1'));
  expect(noisy(1, noise)).not.toEqual(noisy(1, { ...noise, seed: 8 }));
});

test('the nearest is never unknown', () => {
  expect(noisy(0.01, { sigmaM: 1 }).every((value) => value > 0)).toBe(true);
});
