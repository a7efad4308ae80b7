import { expect, test } from '@jest/globals';
import { encodeDepth, encodeWindowDepth } from './depth-encoding.ts';

test('16-bit formats hold millimeters, and nothing beyond their range', () => {
  const { data, rawValueToMeters } = encodeDepth(new Float32Array([0, 1.2344, 65.535, 65.6]), 'luminance-alpha');
  expect([...new Uint16Array(data)]).toEqual([0, 1234, 65_535, 0]);
  expect(rawValueToMeters).toBe(0.001);
  // Luminance is the low byte.
  expect([...new Uint8Array(data).subarray(2, 4)]).toEqual([1234 & 255, 1234 >> 8]);
});

test('floats hold meters', () => {
  const { data, rawValueToMeters } = encodeDepth(new Float32Array([0, 1.25]), 'float32');
  expect([...new Float32Array(data)]).toEqual([0, 1.25]);
  expect(rawValueToMeters).toBe(1);
});

test('window depth is that of an endless far plane, rows from the bottom', () => {
  const { data } = encodeWindowDepth(new Float32Array([0.1, 0.2, 1, 0]), 2, 0.1);
  expect([...new Float32Array(data)]).toEqual([0.9, 0, 0, 0.5].map((value) => expect.closeTo(value, 6)));
});
