import { expect, test } from '@jest/globals';
import { type CubeFace, evaluateBasis, projectCube } from './spherical-harmonics.ts';

const SIZE_PX = 24;
const AXES = [
  { forward: [1, 0, 0], right: [0, 0, 1], up: [0, 1, 0] },
  { forward: [-1, 0, 0], right: [0, 0, -1], up: [0, 1, 0] },
  { forward: [0, 1, 0], right: [-1, 0, 0], up: [0, 0, -1] },
  { forward: [0, -1, 0], right: [-1, 0, 0], up: [0, 0, 1] },
  { forward: [0, 0, 1], right: [-1, 0, 0], up: [0, 1, 0] },
  { forward: [0, 0, -1], right: [1, 0, 0], up: [0, 1, 0] },
] as const;

/** A cube of pictures of a radiance given by direction. */
function photograph(radiance: (x: number, y: number, z: number) => number): CubeFace[] {
  return AXES.map(({ forward, right, up }) => {
    const rgba = new Float32Array(SIZE_PX * SIZE_PX * 4);
    for (let i = 0; i < SIZE_PX * SIZE_PX; i++) {
      const s = (2 * ((i % SIZE_PX) + 0.5)) / SIZE_PX - 1;
      const t = (2 * (Math.floor(i / SIZE_PX) + 0.5)) / SIZE_PX - 1;
      const d = [0, 1, 2].map((k) => (forward[k] ?? 0) + s * (right[k] ?? 0) + t * (up[k] ?? 0));
      const length = Math.hypot(...d);
      rgba.fill(radiance(...(d.map((c) => c / length) as [number, number, number])), i * 4, i * 4 + 3);
    }
    return { rgba, forward, right, up };
  });
}

/** Red of each coefficient. */
function project(radiance: (x: number, y: number, z: number) => number): number[] {
  return [...projectCube(photograph(radiance), SIZE_PX)].filter((_, i) => i % 3 === 0);
}

test('even light is its first coefficient: L √(4π)', () => {
  const [first, ...others] = project(() => 2);
  expect(first).toBeCloseTo(2 * Math.sqrt(4 * Math.PI), 2);
  for (const other of others) expect(other).toBeCloseTo(0, 3);
});

test.each([
  ['y', 1, (_x: number, y: number, _z: number) => y],
  ['z', 2, (_x: number, _y: number, z: number) => z],
  ['x', 3, (x: number, _y: number, _z: number) => x],
] as const)('light that grows along %s is the coefficient %i: √(4π / 3)', (_, index, radiance) => {
  project(radiance).forEach((value, i) => {
    expect(value).toBeCloseTo(i === index ? Math.sqrt((4 * Math.PI) / 3) : 0, 2);
  });
});

test('the second band comes back as it was put in', () => {
  const basis = new Float64Array(9);
  for (let k = 4; k < 9; k++) {
    const found = project((x, y, z) => {
      evaluateBasis(x, y, z, basis);
      return basis[k] ?? 0;
    });
    found.forEach((value, i) => {
      expect(value).toBeCloseTo(i === k ? 1 : 0, 2);
    });
  }
});
