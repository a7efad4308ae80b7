import { describe, expect, test } from '@jest/globals';
import { Matrix4 } from 'three';
import { createPoseFilter } from './one-euro.ts';

const RATE_HZ = 60;

/** The reference implementation of the authors, for one number: `OneEuroFilter` of their page, in its own words. */
function reference(minCutoffHz: number, beta: number) {
  const alpha = (cutoffHz: number) => 1 / (1 + RATE_HZ / (2 * Math.PI * cutoffHz));
  let last: number | null = null;
  let speed = 0;
  return (x: number) => {
    if (last === null) {
      last = x;
      return x;
    }
    speed = alpha(1) * ((x - last) * RATE_HZ) + (1 - alpha(1)) * speed;
    const share = alpha(minCutoffHz + beta * Math.abs(speed));
    last = share * x + (1 - share) * last;
    return last;
  };
}

describe('the One Euro filter of poses', () => {
  test('is that of its authors, for a motion along one axis', () => {
    const filter = createPoseFilter();
    const expected = reference(1.5, 4);
    for (let frame = 0; frame < 200; frame++) {
      const x = Math.sin(frame / 20) + 0.01 * Math.sin(frame * 7.3);
      const pose = new Float32Array(new Matrix4().setPosition(x, 1, 2).elements);
      filter.apply(pose, 1 / RATE_HZ, 1.5, 4);
      expect(pose[12]).toBeCloseTo(expected(x), 5);
      expect([pose[13], pose[14]]).toEqual([1, 2]);
    }
  });

  test('calms a pose at rest, follows a fast one, and keeps it rigid', () => {
    const filter = createPoseFilter();
    let worst = 0;
    for (let frame = 0; frame < 120; frame++) {
      const noise = 0.01 * Math.sin(frame * 12.9898);
      const pose = new Float32Array(new Matrix4().makeRotationY(noise).setPosition(noise, 0, 0).elements);
      filter.apply(pose, 1 / RATE_HZ, 0.5, 1);
      if (frame > 60) worst = Math.max(worst, Math.abs(pose[12] ?? 0), Math.abs(Math.atan2(pose[8] ?? 0, pose[0] ?? 1)));
      expect(new Matrix4().fromArray(pose).determinant()).toBeCloseTo(1, 5);
    }
    expect(worst).toBeLessThan(0.003);
    for (let frame = 0; frame < 60; frame++) {
      const pose = new Float32Array(new Matrix4().setPosition(frame / 20, 0, 0).elements);
      filter.apply(pose, 1 / RATE_HZ, 0.5, 20);
      // 3 m/s: a cutoff of 60 Hz lags 3 m/s / (2 π 60 Hz) = 8 mm, and a frame.
      if (frame > 30) expect(frame / 20 - (pose[12] ?? 0)).toBeLessThan(0.02);
    }
  });

  test('starts at the first pose after a restart, and stays while no time passes', () => {
    const filter = createPoseFilter();
    const at = (x: number) => new Float32Array(new Matrix4().setPosition(x, 0, 0).elements);
    filter.apply(at(0), 1 / RATE_HZ, 1, 0);
    const held = at(1);
    filter.apply(held, 0, 1, 0);
    expect(held[12]).toBe(0);
    filter.restart();
    const jumped = at(5);
    filter.apply(jumped, 1 / RATE_HZ, 1, 0);
    expect(jumped[12]).toBe(5);
  });
});
