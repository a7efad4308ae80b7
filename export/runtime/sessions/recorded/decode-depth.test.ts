import { describe, expect, test } from '@jest/globals';
import { encode } from 'fast-png';
import type { SessionFile } from '../session-format.ts';
import { decodeDepth } from './decode-depth.ts';

const FORMAT: NonNullable<SessionFile['depth']> = {
  widthPx: 3,
  heightPx: 2,
  intrinsics: { fxPx: 2, fyPx: 2, cxPx: 1.5, cyPx: 1 },
  metresPerUnit: 0.001,
  kind: 'z',
};

function png(data: Uint16Array | Uint8Array, width = 3, height = 2, channels = 1): ArrayBuffer {
  return new Uint8Array(encode({ width, height, data, depth: data instanceof Uint16Array ? 16 : 8, channels })).buffer;
}

describe('a depth picture', () => {
  test('holds meters along the axis, rows from the top, to the last bit', () => {
    const meters = decodeDepth(png(Uint16Array.of(0, 1, 1000, 2500, 40_000, 65_535)), FORMAT);
    expect([...meters]).toEqual([0, 0.001, 1, 2.5, 40, 65.535].map(Math.fround));
  });

  test('of distances along the rays is turned into meters along the axis', () => {
    const meters = decodeDepth(png(new Uint16Array(6).fill(3000)), { ...FORMAT, kind: 'range' });
    // The pixel center (0.5, 0.5) is seen along (-0.5, -0.25, 1), the middle column's along (0, -0.25, 1).
    expect(meters[0]).toBeCloseTo(3 / Math.hypot(0.5, 0.25, 1), 6);
    expect(meters[1]).toBeCloseTo(3 / Math.hypot(0.25, 1), 6);
    expect(meters[0]).toBe(meters[2]);
    expect(meters[3]).toBe(meters[0]);
  });

  test.each([
    ['8 bits', () => png(new Uint8Array(6)), '1 channels of 8 bits'],
    ['three channels', () => png(new Uint16Array(18), 3, 2, 3), '3 channels of 16 bits'],
    ['another size', () => png(new Uint16Array(6), 2, 3), '2 × 3 pixels, and session.json says 3 × 2'],
    ['no picture', () => new TextEncoder().encode('hello').buffer, 'it is not a whole PNG file'],
    ['half a picture', () => png(new Uint16Array(6)).slice(0, 50), 'it is not a whole PNG file'],
  ])('with %s is refused', (_name, make, reason) => {
    expect(() => decodeDepth(make(), FORMAT)).toThrow(reason);
  });
});
