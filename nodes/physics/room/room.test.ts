import { describe, expect, test } from '@jest/globals';
import { Matrix4, Vector3 } from 'three';
import { ball, createLab, cube } from '../../../tests/support/physics/lab.ts';
import type { DepthFrame, VoxelSettings } from '../../kit/physics.ts';
import { createVoxelGrid, type VoxelGrid } from '../world/voxel-grid.ts';

const SETTINGS: VoxelSettings = { edgeM: 0.05, threshold: 0.5, speed: 0.2, farM: 5 };
const WIDTH = 80;
const HEIGHT = 60;
/** 60° wide. */
const TAN = Math.tan(Math.PI / 6);
const RAY = [(2 * TAN) / WIDTH, 0, -TAN + TAN / WIDTH, 0, (2 * TAN) / WIDTH, (-TAN * HEIGHT) / WIDTH + TAN / WIDTH];

type Ray = { readonly from: Vector3; readonly to: Vector3 };

/** Depth of a scene that is told by the distance along rays whose length is 1 along the axis of the view. */
function look(eye: Vector3, target: Vector3, distance: (ray: Ray) => number, deltaS = 1 / 30): DepthFrame {
  const worldFromDepth = new Matrix4().lookAt(eye, target, new Vector3(0, 1, 0.001)).setPosition(eye);
  const turn = worldFromDepth.clone().setPosition(0, 0, 0);
  const meters = Float32Array.from({ length: WIDTH * HEIGHT }, (_, k) => {
    const i = k % WIDTH;
    const j = Math.floor(k / WIDTH);
    const to = new Vector3((RAY[0] ?? 0) * i + (RAY[2] ?? 0), (RAY[4] ?? 0) * j + (RAY[5] ?? 0), -1).applyMatrix4(turn);
    const d = distance({ from: eye, to });
    return Number.isFinite(d) ? d : 0;
  });
  return { meters, widthPx: WIDTH, heightPx: HEIGHT, worldFromDepth: worldFromDepth.elements, rayFromTexel: RAY, deltaS };
}

/** The floor at a height of 0.01 m, and a box that stands on it, if there is one. */
const room =
  (box: { readonly half: number; readonly top: number } | null) =>
  (ray: Ray): number => {
    const { from, to } = ray;
    let nearest = to.y < 0 ? (0.01 - from.y) / to.y : Number.POSITIVE_INFINITY;
    if (!box) return nearest;
    const low = new Vector3(-box.half, 0, -box.half);
    const high = new Vector3(box.half, box.top, box.half);
    let enter = 0;
    let leave = Number.POSITIVE_INFINITY;
    for (const axis of ['x', 'y', 'z'] as const) {
      const a = (low[axis] - from[axis]) / to[axis];
      const b = (high[axis] - from[axis]) / to[axis];
      enter = Math.max(enter, Math.min(a, b));
      leave = Math.min(leave, Math.max(a, b));
    }
    if (enter <= leave) nearest = Math.min(nearest, enter);
    return nearest;
  };

const EYE = new Vector3(0.3, 1.4, 1.4);
const CENTER = new Vector3(0, 0.2, 0);
const BOX = { half: 0.24, top: 0.38 };

describe('the voxel grid', () => {
  test('a surface is there after ⌈ln(1 - T) / ln(1 - U)⌉ frames, and gone as soon at T and U', () => {
    const grid = createVoxelGrid(SETTINGS);
    const above = () => grid.isOccupied(0, 7, 0);
    const appears = Math.ceil(Math.log(0.5) / Math.log(0.8));
    for (let i = 1; i <= appears; i++) {
      grid.update(look(EYE, CENTER, room(BOX)));
      expect(above()).toBe(i === appears);
    }
    for (let i = 0; i < 20; i++) grid.update(look(EYE, CENTER, room(BOX)));
    const limit = Math.ceil(Math.log(0.5) / Math.log(1 - 0.2)) + 2;
    let frames = 0;
    while (above() && frames < 50) {
      grid.update(look(EYE, CENTER, room(null)));
      frames++;
    }
    expect(frames).toBeLessThanOrEqual(limit);
  });

  test('what is out of view, or behind what is seen, stays', () => {
    const grid = createVoxelGrid(SETTINGS);
    for (let i = 0; i < 10; i++) grid.update(look(EYE, CENTER, room(BOX)));
    const count = (at: VoxelGrid) => {
      let n = 0;
      at.forEachOccupied(() => n++);
      return n;
    };
    const before = count(grid);
    expect(before).toBeGreaterThan(200);
    // The other way: a wall.
    for (let i = 0; i < 60; i++) grid.update(look(EYE, new Vector3(0.3, 1.4, 5), () => 1.5));
    // A sheet in front of the camera hides everything.
    for (let i = 0; i < 60; i++) grid.update(look(EYE, CENTER, () => 0.5));
    expect(grid.isOccupied(0, 7, 0)).toBe(true);
    expect(count(grid)).toBeGreaterThanOrEqual(before);
  });

  test('a rate is that of time, not of frames', () => {
    const weight = (hz: number) => {
      const grid = createVoxelGrid(SETTINGS);
      for (let i = 0; i < hz / 10; i++) grid.update(look(EYE, CENTER, room(BOX), 1 / hz));
      return grid.weightAt(0, 7, 0);
    };
    expect(weight(60)).toBeCloseTo(weight(30), 6);
    expect(weight(10)).toBeCloseTo(weight(30), 6);
  });

  test('numbers that are none change nothing', () => {
    const grid = createVoxelGrid(SETTINGS);
    grid.update({ ...look(EYE, CENTER, room(BOX)), worldFromDepth: new Array(16).fill(Number.NaN) });
    grid.update(look(EYE, CENTER, () => Number.NaN));
    let n = 0;
    grid.forEachOccupied(() => n++);
    expect(n).toBe(0);
  });
});

describe('bodies in a room', () => {
  const see = (lab: ReturnType<typeof createLab>, box: typeof BOX | null, frames = 30) => {
    for (let i = 0; i < frames; i++) lab.engine.apply({ kind: 'depth', frame: look(EYE, CENTER, room(box)) });
  };
  const start = () => {
    const lab = createLab({ sleep: true });
    lab.engine.apply({ kind: 'room', room: SETTINGS, friction: 0.6, restitution: 0.1 });
    see(lab, BOX);
    return lab;
  };

  test('a ball and a box rest on a cardboard box, asleep, while nobody looks; when it is removed they fall to the floor', () => {
    const lab = start();
    const balls = lab.add({ shapes: ball(0.06), rollingM: 0.003 }, { positionM: [0.03, 0.7, 0.02] });
    const box = lab.add({ shapes: cube(0.12) }, { positionM: [-0.12, 0.7, -0.1] });
    lab.run(4);
    expect(Math.abs(lab.body(balls).positionM[1] - 0.06 - BOX.top)).toBeLessThan(0.06);
    expect(Math.abs(lab.body(box).positionM[1] - 0.06 - BOX.top)).toBeLessThan(0.06);
    lab.run(30);
    expect([lab.body(balls).isAsleep, lab.body(box).isAsleep]).toEqual([true, true]);
    see(lab, null, 6);
    lab.run(2);
    expect(lab.body(balls).positionM[1]).toBeLessThan(0.13);
    expect(lab.body(box).positionM[1]).toBeLessThan(0.13);
  });

  test('a fast ball does not pass through the top of the box', () => {
    const lab = start();
    const id = lab.add({ shapes: ball(0.03) }, { positionM: [0.02, 1.63, 0.02], velocity: [0, -30, 0] });
    lab.run(0.1);
    expect(lab.body(id).positionM[1]).toBeGreaterThan(BOX.top - 0.03);
  });

  test('a ball rolls over the edges between voxels without a bump', () => {
    const lab = start();
    const id = lab.add({ shapes: ball(0.05) }, { positionM: [-0.6, 0.1, 0.5], velocity: [1, 0, 0] });
    let highest = 0;
    lab.run(0.7, () => {
      highest = Math.max(highest, lab.body(id).positionM[1]);
    });
    expect(highest).toBeLessThan(0.103);
    expect(lab.body(id).velocity[0]).toBeGreaterThan(0.5);
  });
});
