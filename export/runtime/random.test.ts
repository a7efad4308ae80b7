import { expect, test } from '@jest/globals';
import { createRandom } from './random.ts';

function take(count: number, seed: number, name: string): number[] {
  const { next } = createRandom(seed, name);
  return Array.from({ length: count }, next);
}

test('a seed and a name give one sequence, others give others', () => {
  expect(take(5, 1, 'rain-a1b2')).toEqual(take(5, 1, 'rain-a1b2'));
  expect(take(5, 1, 'rain-a1b2')).not.toEqual(take(5, 2, 'rain-a1b2'));
  expect(take(5, 1, 'rain-a1b2')).not.toEqual(take(5, 1, 'rain-a1b3'));
});

test('reset starts over', () => {
  const random = createRandom(7, 'x');
  const first = [random.next(), random.next()];
  random.reset();
  expect([random.next(), random.next()]).toEqual(first);
});

test('values are spread evenly over [0, 1)', () => {
  const bins = new Array<number>(10).fill(0);
  for (const value of take(10_000, 3, 'bins')) bins[Math.floor(value * 10)] = (bins[Math.floor(value * 10)] ?? 0) + 1;
  // Four standard deviations of a bin's count: sqrt(10,000 * 0.1 * 0.9) = 30.
  for (const bin of bins) expect(Math.abs(bin - 1000)).toBeLessThan(120);
});
