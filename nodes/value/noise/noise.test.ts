import { describe, expect, test } from '@jest/globals';
import { fakeContext } from '../../../tests/support/node-context.ts';
import { definition } from './definition.ts';
import { gradientNoise } from './gradient-noise.ts';
import { create } from './runtime.ts';

type Params = {
  along?: number;
  place?: readonly number[];
  frequency?: number;
  octaves?: number;
  low?: number;
  high?: number;
  seed?: number;
};

function start(params: Params = {}) {
  const { ctx, set } = fakeContext(definition, { params });
  const node = create(ctx);
  return (along: number): number => {
    set('along', along);
    node.update({} as never);
    return ctx.outputs.number.value;
  };
}

function samples(params: Params, count: number, step: number): number[] {
  const at = start(params);
  return Array.from({ length: count }, (_, i) => at(i * step));
}

describe('gradient noise', () => {
  test('is 0 at whole coordinates, and slopes there in one of twelve directions', () => {
    const directions = new Set<string>();
    for (let i = 0; i < 400; i++) {
      const [x, y, z] = [(i * 7) % 23, (i * 5) % 19, -(i % 11)] as const;
      expect(gradientNoise(x, y, z, 3)).toBeCloseTo(0, 15);
      const h = 1e-6;
      const slope = [gradientNoise(x + h, y, z, 3), gradientNoise(x, y + h, z, 3), gradientNoise(x, y, z + h, 3)];
      directions.add(slope.map((d) => Math.round(d / h)).join(' '));
    }
    expect(directions.size).toBe(12);
    for (const direction of directions) {
      expect(
        direction
          .split(' ')
          .map((d) => Math.abs(Number(d)))
          .sort(),
      ).toEqual([0, 1, 1]);
    }
  });

  test('halfway between two corners is the mean of their gradients', () => {
    // On the line between two corners only they count, and the fade is 1/2: (s₀ · ½ − s₁ · ½) / 2.
    const h = 1e-6;
    const slopeAt = (x: number) => gradientNoise(x + h, 2, 5, 1) / h;
    expect(gradientNoise(4.5, 2, 5, 1)).toBeCloseTo((slopeAt(4) * 0.5 - slopeAt(5) * 0.5) / 2, 4);
  });
});

describe('noise', () => {
  test.each([1, 4])('of %d octaves stays between its ends, and wanders over most of the way', (octaves) => {
    const numbers = samples({ octaves, low: 10, high: 20 }, 20000, 0.083);
    expect(Math.min(...numbers)).toBeGreaterThanOrEqual(10);
    expect(Math.max(...numbers)).toBeLessThanOrEqual(20);
    expect(Math.max(...numbers) - Math.min(...numbers)).toBeGreaterThan(5);
    expect(numbers.reduce((sum, x) => sum + x, 0) / numbers.length).toBeCloseTo(15, 0);
  });

  test('is continuous, and so is its slope', () => {
    const numbers = samples({}, 20000, 0.001);
    const slopes = numbers.slice(1).map((x, i) => (x - (numbers[i] ?? 0)) / 0.001);
    const bends = slopes.slice(1).map((x, i) => Math.abs(x - (slopes[i] ?? 0)));
    expect(Math.max(...slopes.map(Math.abs))).toBeLessThan(4);
    expect(Math.max(...bends)).toBeLessThan(0.02);
  });

  test('is not 0 at all integers', () => {
    const numbers = samples({}, 50, 1);
    expect(new Set(numbers.map((x) => x.toFixed(3))).size).toBeGreaterThan(40);
  });

  test('is the same at the same place, and another with another seed or position', () => {
    expect(start({ seed: 1 })(2.5)).toBe(start({ seed: 1 })(2.5));
    expect(start({ seed: 1 })(2.5)).not.toBeCloseTo(start({ seed: 2 })(2.5), 3);
    expect(start({})(2.5)).not.toBeCloseTo(start({ place: [0, 3, 0] })(2.5), 3);
    expect(start({ place: [1.5, 0, 0] })(1)).toBeCloseTo(start({})(2.5), 12);
  });

  test('outputs three independent noises', () => {
    const { ctx, set } = fakeContext(definition);
    const node = create(ctx);
    const points = Array.from({ length: 2000 }, (_, i) => {
      set('along', i * 0.7);
      node.update({} as never);
      return [...ctx.outputs.vector.value];
    });
    const dot = (a: number, b: number) => points.reduce((sum, p) => sum + (p[a] ?? 0) * (p[b] ?? 0), 0);
    for (const [a, b] of [
      [0, 1],
      [0, 2],
      [1, 2],
    ] as const)
      expect(Math.abs(dot(a, b) / Math.sqrt(dot(a, a) * dot(b, b)))).toBeLessThan(0.15);
  });
});
