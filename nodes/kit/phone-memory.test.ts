import { describe, expect, test } from '@jest/globals';
import { memoryShares } from './phone-memory.ts';

describe('the memory of phones that captures and splats of a page share', () => {
  test('belongs to one asset alone, whatever it needs', () => {
    expect(memoryShares([1e6], 128e6)).toEqual([128e6]);
    expect(memoryShares([900e6], 128e6)).toEqual([128e6]);
    expect(memoryShares([], 128e6)).toEqual([]);
  });

  test('is divided equally among large assets', () => {
    expect(memoryShares([500e6, 200e6], 128e6)).toEqual([64e6, 64e6]);
  });

  test('goes to the larger ones where a small one leaves some', () => {
    expect(memoryShares([10e6, 200e6, 90e6], 128e6)).toEqual([10e6, 59e6, 59e6]);
    expect(memoryShares([200e6, 50e6, 10e6], 128e6)).toEqual([68e6, 50e6, 10e6]);
  });

  test('reduces none if all have room, and is never more in sum', () => {
    const shares = memoryShares([30e6, 40e6], 128e6);
    expect(shares).toEqual([59e6, 69e6]);
    const many = [3, 141_592_653, 58_979_323, 84_626_433, 83_279_502, 88_419_716];
    expect(memoryShares(many, 128e6).reduce((sum, share) => sum + share)).toBeLessThanOrEqual(128e6);
  });
});
