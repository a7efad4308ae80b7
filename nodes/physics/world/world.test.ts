import { describe, expect, test } from '@jest/globals';
import { ball, createLab, cube, turned } from '../../../tests/support/physics/lab.ts';
import type { Triple } from '../../kit/physics.ts';
import { boxShape } from '../body/solids.ts';
import { massProperties } from './mass-properties.ts';

const G = 9.81;
const length = (v: Triple) => Math.hypot(...v);

test('a body that is held still falls asleep, and follows its holder again', () => {
  const lab = createLab({ sleep: true });
  const id = lab.add({ shapes: cube(0.2) }, { positionM: [0, 1, 0] });
  const joint = lab.join('lock', id, null, { frequencyHz: 8, dampingRatio: 1 }, [0, 1, 0]);
  lab.run(3);
  expect(lab.body(id).isAsleep).toBe(true);
  lab.engine.apply({ kind: 'target', id: joint, worldFromBody: [1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0.5, 1, 0, 1] });
  lab.run(1);
  expect(lab.body(id).positionM[0]).toBeCloseTo(0.5, 1);
});

describe('motion by formula', () => {
  test('a body falls by g t² / 2', () => {
    const lab = createLab();
    const id = lab.add({ shapes: ball(0.05) }, { positionM: [0, 10, 0] });
    lab.run(1);
    expect(10 - lab.body(id).positionM[1]).toBeCloseTo(G / 2, 1);
    expect(lab.body(id).velocity[1]).toBeCloseTo(-G, 4);
  });

  test.each([0.3, 0.6, 0.9])('a ball with restitution %p rises to e² of its height', (restitution) => {
    const lab = createLab();
    lab.floor(0.5, 0);
    const id = lab.add({ shapes: ball(0.05), restitution }, { positionM: [0, 1.05, 0] });
    let isUp = false;
    let highestM = 0;
    lab.run(1.2, () => {
      const { positionM, velocity } = lab.body(id);
      isUp ||= velocity[1] > 0;
      if (isUp) highestM = Math.max(highestM, positionM[1] - 0.05);
    });
    expect(highestM / restitution ** 2).toBeGreaterThan(0.93);
    expect(highestM / restitution ** 2).toBeLessThan(1.02);
  });

  test.each([1 / 120, 1 / 90, 1 / 60, 1 / 20])('a box that lands flat bounces straight up, at %p s a frame', (frameS) => {
    for (const restitution of [0, 0.2, 0.6]) {
      const lab = createLab();
      lab.floor(0.5, 0);
      const id = lab.add({ shapes: cube(0.4), restitution }, { positionM: [0, 0.9, 0] });
      for (let timeS = 0; timeS < 3; timeS += frameS) lab.engine.step(frameS);
      const { positionM, rotation } = lab.body(id);
      expect(Math.hypot(positionM[0], positionM[2])).toBeLessThan(0.02);
      expect(2 * Math.hypot(rotation[0], rotation[1], rotation[2])).toBeLessThan(0.05);
    }
  });

  test.each([0.5, 1, 2])('a pendulum of %p m swings with 2π √(l / g)', (lengthM) => {
    const lab = createLab();
    const angleRad = 0.1;
    const id = lab.add({ shapes: ball(0.01) }, { positionM: [lengthM * Math.sin(angleRad), -lengthM * Math.cos(angleRad), 0] });
    lab.join('rope', id, null, { lengthM });
    const crossings: number[] = [];
    let before = 1;
    lab.run(10, (frame) => {
      const x = lab.body(id).positionM[0];
      if (before > 0 && x <= 0) crossings.push((frame + before / (before - x)) / 60);
      before = x;
    });
    const periodS = ((crossings.at(-1) ?? 0) - (crossings[0] ?? 0)) / (crossings.length - 1);
    const exactS = 2 * Math.PI * Math.sqrt(lengthM / G) * (1 + angleRad ** 2 / 16);
    expect(periodS / exactS).toBeGreaterThan(0.99);
    expect(periodS / exactS).toBeLessThan(1.01);
  });

  test('a ball with rolling resistance rolls 7/10 v² r / (g s) far, where s is the lever arm', () => {
    const lab = createLab();
    lab.floor();
    const id = lab.add({ shapes: ball(0.1), rollingM: 0.004 }, { positionM: [0, 0.1, 0], velocity: [1, 0, 0], spin: [0, 0, -10] });
    lab.run(5);
    const { positionM, velocity } = lab.body(id);
    expect(length(velocity)).toBeLessThan(0.001);
    expect(positionM[0] / ((0.7 * 0.1) / (G * 0.004))).toBeCloseTo(1, 1);
  });

  test('a collision keeps momentum', () => {
    const lab = createLab({ gravity: [0, 0, 0] });
    const a = lab.add({ shapes: ball(0.1), massKg: 2, restitution: 0.5 }, { velocity: [3, 0, 0] });
    const b = lab.add({ shapes: cube(0.2), massKg: 1 }, { positionM: [1, 0.05, 0.02] });
    lab.run(1);
    const [p, q] = [lab.body(a).velocity, lab.body(b).velocity];
    expect([2 * p[0] + q[0], 2 * p[1] + q[1], 2 * p[2] + q[2]].map((x) => Math.round(x * 1e4) / 1e4 + 0)).toEqual([6, 0, 0]);
    expect(q[0]).toBeGreaterThan(1);
  });

  test.each([0.2, 0.5, 0.8])('a box with friction %p stays on a slope below the angle of friction and slides above', (friction) => {
    const slidM = (slopeRad: number): number => {
      const lab = createLab();
      const rotation = turned([0, 0, 1], slopeRad);
      lab.add({ mode: 'static', shapes: [boxShape([20, 0.2, 2])], friction }, { rotation });
      const up: Triple = [-Math.sin(slopeRad), Math.cos(slopeRad), 0];
      const id = lab.add({ shapes: cube(0.2), friction }, { positionM: [up[0] * 0.2, up[1] * 0.2, 0], rotation });
      lab.run(4);
      return length(lab.body(id).positionM.map((x, i) => x - (up[i] ?? 0) * 0.2) as unknown as Triple);
    };
    const angleRad = Math.atan(friction);
    expect(slidM(angleRad - (1.6 * Math.PI) / 180)).toBeLessThan(0.005);
    expect(slidM(angleRad + (1.4 * Math.PI) / 180)).toBeGreaterThan(0.3);
  });

  test('a free body keeps its angular momentum and gains no energy, about its unstable axis too', () => {
    const lab = createLab({ gravity: [0, 0, 0] });
    const shapes = [boxShape([0.1, 0.2, 0.4])];
    const { inertia } = massProperties(shapes, 1, 0);
    const id = lab.add({ shapes }, { spin: [0.05, 12, 0.1] });
    const measure = () => {
      const { rotation: q, spin } = lab.body(id);
      // The spin in the axes of the body.
      const [x, y, z, w] = [-q[0], -q[1], -q[2], q[3]];
      const t = [2 * (y * spin[2] - z * spin[1]), 2 * (z * spin[0] - x * spin[2]), 2 * (x * spin[1] - y * spin[0])] as const;
      const local: Triple = [
        spin[0] + w * t[0] + y * t[2] - z * t[1],
        spin[1] + w * t[1] + z * t[0] - x * t[2],
        spin[2] + w * t[2] + x * t[1] - y * t[0],
      ];
      const momentum: Triple = [inertia.xx * local[0], inertia.yy * local[1], inertia.zz * local[2]];
      return { momentum: length(momentum), energy: 0.5 * momentum.reduce((sum, m, i) => sum + m * (local[i] ?? 0), 0), local };
    };
    const start = measure();
    let most = 0;
    let flipped = false;
    lab.run(10, () => {
      const { energy, local } = measure();
      most = Math.max(most, energy);
      flipped ||= local[1] < -6;
    });
    expect(measure().momentum / start.momentum).toBeCloseTo(1, 2);
    expect(most / start.energy).toBeLessThan(1.01);
    expect(flipped).toBe(true);
  });
});

describe('what stands', () => {
  const stack = (sleep: boolean) => {
    const lab = createLab({ sleep });
    lab.floor();
    const ids = Array.from({ length: 10 }, (_, i) => lab.add({ shapes: cube(0.2) }, { positionM: [0, 0.1 + 0.2 * i, 0] }));
    return { lab, top: ids[9] ?? 0, ids };
  };
  const offM = ({ positionM: [x, y, z] }: { readonly positionM: Triple }) => Math.hypot(x, y - 1.9, z);

  test('ten boxes stand 10 s without sleep, also after a push', () => {
    const { lab, top } = stack(false);
    lab.run(3);
    const values = [1 / 60, 0, 0, 0, 0, 0, 0, 1.9, 0];
    lab.engine.apply({ kind: 'impulse', id: top, values });
    lab.run(7);
    expect(offM(lab.body(top))).toBeLessThan(0.01);
  });

  test('ten boxes stand 60 s and sleep', () => {
    const { lab, top, ids } = stack(true);
    lab.run(60);
    expect(offM(lab.body(top))).toBeLessThan(0.01);
    expect(ids.every((id) => lab.body(id).isAsleep)).toBe(true);
  });

  test('ten boxes stand 60 s with sleep, also after a push at the third second', () => {
    const { lab, top } = stack(true);
    lab.run(3);
    // 1 N for one step.
    lab.engine.apply({ kind: 'impulse', id: top, values: [1 / 60, 0, 0, 0, 0, 0, 0, 1.9, 0] });
    lab.run(57);
    expect(offM(lab.body(top))).toBeLessThan(0.01);
    expect(lab.body(top).isAsleep).toBe(true);
  });

  test('a heap gains no energy', () => {
    const lab = createLab();
    lab.floor();
    const ids = Array.from({ length: 30 }, (_, i) =>
      lab.add({ shapes: i % 2 ? ball(0.1) : cube(0.2) }, { positionM: [0.13 * Math.sin(i * 7), 0.3 + 0.22 * i, 0.13 * Math.cos(i * 5)] }),
    );
    // Balls and cubes turn as easily about each axis.
    const inertias = [cube(0.2), ball(0.1)].map((shapes) => massProperties(shapes, 1, 0).inertia.xx);
    const energy = () =>
      ids.reduce((sum, id, i) => {
        const { positionM, velocity, spin } = lab.body(id);
        return sum + G * positionM[1] + 0.5 * length(velocity) ** 2 + 0.5 * (inertias[i % 2] ?? 0) * length(spin) ** 2;
      }, 0);
    const start = energy();
    let most = start;
    lab.run(8, () => {
      most = Math.max(most, energy());
    });
    expect(most / start).toBeLessThan(1.01);
    expect(Math.min(...ids.map((id) => lab.body(id).positionM[1]))).toBeGreaterThan(0.09);
  });

  test('neither balls nor boxes of 30 m/s pass through a thin table, at 40 angles and times within a step, and all stay finite', () => {
    // Also in the last part of a step, at a slope, and beside the middle.
    for (let i = 0; i < 40; i++) {
      const lab = createLab({ gravity: [0, 0, 0] });
      lab.add({ mode: 'static', shapes: [boxShape([2, 0.02, 2])] }, { positionM: [0, 0.7, 0] });
      const angleRad = 0.03 * i;
      const velocity: Triple = [30 * Math.sin(angleRad) * Math.cos(i), -30 * Math.cos(angleRad), 30 * Math.sin(angleRad) * Math.sin(i)];
      const at = 0.02 + 0.011 * i;
      const id = lab.add(
        { shapes: i % 2 ? ball(0.03) : cube(0.06), restitution: (i % 5) / 5 },
        { positionM: [-velocity[0] * at, 0.74 - velocity[1] * at, -velocity[2] * at], velocity },
      );
      lab.run(at + 0.03, () =>
        expect(
          Object.values(lab.body(id))
            .flat()
            .every((x) => typeof x === 'boolean' || Number.isFinite(x)),
        ).toBe(true),
      );
      expect([i, lab.body(id).positionM[1] > 0.7]).toEqual([i, true]);
    }
  });

  test('a fast ball does not pass through a thin table', () => {
    const lab = createLab();
    lab.add({ mode: 'static', shapes: [boxShape([2, 0.02, 2])] }, { positionM: [0, 0.7, 0] });
    const id = lab.add({ shapes: ball(0.03) }, { positionM: [0, 2.113, 0], velocity: [0, -30, 0] });
    lab.run(2);
    expect(lab.body(id).positionM[1]).toBeCloseTo(0.74, 2);
  });
});
