import { describe, expect, test } from '@jest/globals';
import { plyOf, splatAt, splatCloud } from '../../../tests/support/splat-files.ts';
import { reduceSplats } from './reduce-splats.ts';
import { readSplatPly } from './splat-ply.ts';
import { splatSize } from './splat-size.ts';
import { type Splats, splatGpuBytes, WORDS } from './splats.ts';

const cloud = readSplatPly(plyOf(splatCloud(300, 15)));

function positionsOf({ words, count }: Splats): string[] {
  const floats = new Float32Array(words.buffer, words.byteOffset, words.length);
  return Array.from({ length: count }, (_, i) => [...floats.subarray(i * WORDS, i * WORDS + 3)].map((x) => x.toFixed(3)).join());
}

/** A flat row: x is the number of the splat. */
function rowOf(scales: readonly number[], opacities: readonly number[]): Splats {
  const splats = scales.map((scale, i) => splatAt(i, 0, 0, { scale: [scale, scale, scale], opacity: opacities[i] ?? 0.5 }));
  return readSplatPly(plyOf(splats));
}

describe('how much of splats has room on a phone', () => {
  test('all of them without a limit or with enough memory', () => {
    expect(splatSize(1_000_000, 3)).toEqual({ count: 1_000_000, degree: 3, gpuBytes: 84e6 });
    expect(splatSize(1_000_000, 3, 128e6)).toEqual(splatSize(1_000_000, 3));
  });

  test('first fewer degrees of harmonics', () => {
    expect([80e6, 60e6, 45e6].map((bytes) => splatSize(1_000_000, 3, bytes).degree)).toEqual([2, 1, 0]);
    expect(splatSize(1_000_000, 3, 45e6).count).toBe(1_000_000);
  });

  test('then fewer splats, in whole rows of the textures', () => {
    const { count, degree, gpuBytes } = splatSize(4_000_000, 2, 64e6);
    expect([degree, count % 1024]).toEqual([0, 0]);
    expect(gpuBytes).toBeLessThanOrEqual(64e6);
    expect(gpuBytes).toBeGreaterThan(63e6);
    expect(splatSize(4_000_000, 2, 1).count).toBe(1024);
    expect(splatSize(500, 3, 36 * 1024)).toMatchObject({ count: 500, degree: 0 });
  });
});

describe('reduced splats', () => {
  test('are the same object if all have room', () => {
    expect(reduceSplats(cloud, { count: 300, degree: 3 })).toBe(cloud);
  });

  test.each([1, 2] as const)('keep the colors of degree %i', (degree) => {
    const { count, words, harmonics, ranges } = reduceSplats(cloud, { count: 300, degree });
    expect([count, words]).toEqual([300, cloud.words]);
    expect(ranges).toEqual(cloud.ranges);
    expect(4 * (words.length + harmonics.length + count)).toBe(splatGpuBytes(300, degree));
    const coefficients = degree === 1 ? 9 : 24;
    const [bytes, whole] = [harmonics, cloud.harmonics].map((all) => new Uint8Array(all.buffer));
    for (let i = 0; i < 300; i++) {
      expect(bytes?.subarray(16 * degree * i, 16 * degree * i + coefficients)).toEqual(whole?.subarray(48 * i, 48 * i + coefficients));
    }
  });

  test('lose the smallest and the faintest, and keep their order', () => {
    const row = rowOf([0.1, 0.5, 0.1, 0.3, 0.3], [0.9, 0.5, 0.5, 0.05, 0.9]);
    // x of the kept splats: opacity times area is 0.009, 0.125, 0.005, 0.0045, 0.081 times 3.
    const kept = (count: number) => positionsOf(reduceSplats(row, { count, degree: 0 })).map((text) => Number(text.split(',')[0]));
    expect(kept(4).sort()).toEqual([0, 1, 2, 4]);
    expect(kept(2).sort()).toEqual([1, 4]);
    const all = positionsOf(cloud);
    const some = positionsOf(reduceSplats(cloud, { count: 100, degree: 0 }));
    expect(some).toHaveLength(100);
    expect(all.filter((position) => some.includes(position))).toEqual(some);
  });

  test('are those of a sort by importance', () => {
    const splats = splatCloud(300, 0);
    const importance = splats.map(({ scale: [a, b, c], opacity }) => opacity * (a * b + b * c + c * a));
    const least = [...importance].sort((a, b) => b - a)[100] ?? 0;
    const expected = splats.filter((_, i) => (importance[i] ?? 0) > least).map(({ position }) => position.map((x) => x.toFixed(3)).join());
    const { words } = readSplatPly(plyOf(splats));
    expect(positionsOf(reduceSplats({ ...cloud, degree: 0, words }, { count: 100, degree: 0 })).sort()).toEqual(expected.sort());
  });

  test('of equal importance are the first ones', () => {
    const row = rowOf([0.2, 0.2, 0.2, 0.2], [0.5, 0.5, 0.5, 0.5]);
    expect(positionsOf(reduceSplats(row, { count: 2, degree: 0 }))).toEqual(positionsOf(row).slice(0, 2));
  });
});
