import { expect, test } from '@jest/globals';
import { decode } from 'fast-png';
import { encodeDepth, encodeLayer } from './encode-png.ts';

test('a layer is written with straight alpha, in the rows’ order', () => {
  const pixels = new Uint8Array([255, 0, 0, 255, 64, 32, 0, 128, 0, 0, 0, 0, 10, 200, 3, 255]);
  const png = decode(encodeLayer({ widthPx: 2, heightPx: 2, pixels }));
  expect(png).toMatchObject({ width: 2, height: 2, channels: 4, depth: 8 });
  // 64 · 255 / 128 = 127.5, 32 · 255 / 128 = 63.75.
  expect([...png.data]).toEqual([255, 0, 0, 255, 128, 64, 0, 128, 0, 0, 0, 0, 10, 200, 3, 255]);
});

test('depth is written in millimeters of 16 bits', () => {
  const meters = new Float32Array([0, 1, 2.7104, 0.0001, 65.535, 200, Number.NaN, -1]);
  const png = decode(encodeDepth({ widthPx: 4, heightPx: 2, meters }));
  expect(png).toMatchObject({ width: 4, height: 2, channels: 1, depth: 16 });
  expect([...png.data]).toEqual([0, 1000, 2710, 1, 65_535, 65_535, 0, 0]);
});
