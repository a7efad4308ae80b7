import { describe, expect, test } from '@jest/globals';
import { BLACK_TO_WHITE, type Gradient, gradientAt, gradientMisfit, sampleGradient } from './gradient.ts';

function at(gradient: Gradient, position: number): number[] {
  const color = new Float32Array(4);
  gradientAt(gradient, position, color);
  return [...color].map((number) => Math.round(number * 1000) / 1000);
}

/** Red, a step to green, a smooth way to blue. */
const THREE: Gradient = [0.2, 1, 0, 0, 1, 2, 0.5, 0, 1, 0, 1, 1, 0.9, 0, 0, 1, 1, 0];

test('a table begins with the first color and ends with the last', () => {
  const colors = new Float32Array(12);
  sampleGradient(BLACK_TO_WHITE, colors);
  expect([...colors]).toEqual([0, 0, 0, 1, 0.5, 0.5, 0.5, 1, 1, 1, 1, 1]);
});

describe('the interpolation of a stop', () => {
  test('hold keeps its color up to the next stop, where the next color begins', () => {
    expect(at(THREE, 0.1)).toEqual([1, 0, 0, 1]);
    expect(at(THREE, 0.499)).toEqual([1, 0, 0, 1]);
    expect(at(THREE, 0.5)).toEqual([0, 1, 0, 1]);
  });

  test('ease in-out is 3t² − 2t³', () => {
    expect(at(THREE, 0.6)).toEqual([0, 0.844, 0.156, 1]);
    expect(at(THREE, 0.7)).toEqual([0, 0.5, 0.5, 1]);
    expect(at(THREE, 1)).toEqual([0, 0, 1, 1]);
  });
});

test('a transparent stop takes no part in the colors beside it', () => {
  // Premultiplied: half of opaque red.
  expect(at([0, 1, 0, 0, 1, 0, 1, 0, 0, 0, 0, 0], 0.5)).toEqual([0.5, 0, 0, 0.5]);
});

test('the padding of a slot changes no color', () => {
  const padded = [...THREE, ...THREE.slice(-6), ...THREE.slice(-6)];
  for (const position of [0, 0.3, 0.7, 0.95, 1]) expect(at(padded, position)).toEqual(at(THREE, position));
});

test.each([
  ['one stop', [0, 0, 0, 0, 1, 0]],
  ['a list that is cut off', BLACK_TO_WHITE.slice(1)],
  ['a color above 1', [0, 2, 0, 0, 1, 0, 1, 1, 1, 1, 1, 0]],
  ['an unknown interpolation', [0, 0, 0, 0, 1, 3, 1, 1, 1, 1, 1, 0]],
  ['part of an interpolation', [0, 0, 0, 0, 1, 0.5, 1, 1, 1, 1, 1, 0]],
  ['two stops at one position', [0.5, 0, 0, 0, 1, 0, 0.5, 1, 1, 1, 1, 0]],
  ['a text', 'red to blue'],
])('%s is no gradient', (_, value) => {
  expect(gradientMisfit(value)).toMatch(/^a gradient/);
});
