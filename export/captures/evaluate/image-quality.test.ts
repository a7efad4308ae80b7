import { expect, test } from '@jest/globals';
import { chromaErrorAt, chromaErrorMap, compareImages } from './image-quality.ts';

const SIDE = 12;

function image(color: (column: number, row: number) => readonly number[]): Uint8ClampedArray {
  return Uint8ClampedArray.from({ length: 4 * SIDE * SIDE }, (_, i) => {
    const pixel = Math.floor(i / 4);
    return color(pixel % SIDE, Math.floor(pixel / SIDE))[i % 4] ?? 255;
  });
}

const pair = (shown: Uint8ClampedArray, truth: Uint8ClampedArray) => ({ shown, truth, widthPx: SIDE, heightPx: SIDE });
const stripes = image((column) => (column % 2 === 0 ? [200, 200, 200] : [40, 40, 40]));

test('equal images have no error', () => {
  expect(compareImages(pair(stripes, stripes))).toEqual({ psnrDb: Infinity, ssim: expect.closeTo(1, 9), chromaError: 0, covered: 1 });
});

test('a step of 10 in all channels is 28.13 dB, without an error of color', () => {
  const gray = (value: number) => image(() => [value, value, value]);
  const { psnrDb, ssim, chromaError } = compareImages(pair(gray(110), gray(100)));
  expect(psnrDb).toBeCloseTo(20 * Math.log10(25.5), 9);
  expect(chromaError).toBeCloseTo(0, 9);
  // Without variance, only the means differ: (2·110·100 + C1) / (110² + 100² + C1).
  expect(ssim).toBeCloseTo((22_000 + 6.5025) / (22_100 + 6.5025), 9);
});

test('the negative of stripes is unlike them, though as bright', () => {
  const negative = image((column) => (column % 2 === 0 ? [40, 40, 40] : [200, 200, 200]));
  // Covariance −v, variances v: (−2v + C2) / (2v + C2), with v = 80²; the Gaussian weighs dark and bright columns alike within 2e-5.
  const v = 80 ** 2;
  expect(compareImages(pair(negative, stripes)).ssim).toBeCloseTo((-2 * v + 58.5225) / (2 * v + 58.5225), 5);
});

test('the error of color is that of Cb and Cr', () => {
  // Blue of 255 instead of black: Cb 127.5, Cr −20.73.
  expect(chromaErrorAt({ shown: [0, 0, 255, 255], truth: [0, 0, 0, 255], widthPx: 1, heightPx: 1 }, 0)).toBeCloseTo(148.23, 1);
});

test('pixels that are not covered do not count, and are black in the map', () => {
  const half = image((column) => [255, 0, 0, column < 6 ? 255 : 0]);
  const red = image((column) => (column < 6 ? [255, 0, 0] : [0, 0, 255]));
  const compared = pair(half, red);
  expect(compareImages(compared)).toMatchObject({ psnrDb: Infinity, covered: 0.5, chromaError: 0 });
  const map = chromaErrorMap(compared);
  expect([...map.slice(0, 4), ...map.slice(24, 28)]).toEqual([13, 8, 135, 255, 0, 0, 0, 255]);
});
