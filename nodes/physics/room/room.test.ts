import { describe, expect, test } from '@jest/globals';
import { Matrix4, Vector3 } from 'three';
import { fakeContext } from '../../../tests/support/node-context.ts';
import { ball, createLab, cube } from '../../../tests/support/physics/lab.ts';
import { BOX, CENTER, EYE, look, type Ray, SEEN_BOX, SEEN_FLOOR, SETTINGS } from '../../../tests/support/physics/seen-room.ts';
import { createStage, placeOf } from '../../../tests/support/physics/stage.ts';
import { createPhysicsRoom } from '../../kit/physics.ts';
import { createVoxelGrid, type VoxelGrid } from '../world/voxel-grid.ts';
import { definition } from './definition.ts';
import { create } from './runtime.ts';

describe('the voxel grid', () => {
  test('a surface is there after ⌈ln(1 - T) / ln(1 - U)⌉ frames, and gone as soon at T and U', () => {
    const grid = createVoxelGrid(SETTINGS);
    const above = () => grid.isOccupied(0, 7, 0);
    const appears = Math.ceil(Math.log(0.5) / Math.log(0.8));
    for (let i = 1; i <= appears; i++) {
      grid.update(SEEN_BOX);
      expect(above()).toBe(i === appears);
    }
    for (let i = 0; i < 20; i++) grid.update(SEEN_BOX);
    const limit = Math.ceil(Math.log(0.5) / Math.log(1 - 0.2)) + 2;
    let frames = 0;
    while (above() && frames < 50) {
      grid.update(SEEN_FLOOR);
      frames++;
    }
    expect(frames).toBeLessThanOrEqual(limit);
  });

  test('what is out of view, or behind what is seen, stays', () => {
    const grid = createVoxelGrid(SETTINGS);
    for (let i = 0; i < 10; i++) grid.update(SEEN_BOX);
    const count = (at: VoxelGrid) => {
      let n = 0;
      at.forEachOccupied(() => n++);
      return n;
    };
    const before = count(grid);
    expect(before).toBeGreaterThan(200);
    // The other way: a wall.
    const wall = look(EYE, new Vector3(0.3, 1.4, 5), () => 1.5);
    for (let i = 0; i < 60; i++) grid.update(wall);
    // A sheet in front of the camera hides everything.
    const sheet = look(EYE, CENTER, () => 0.5);
    for (let i = 0; i < 60; i++) grid.update(sheet);
    expect(grid.isOccupied(0, 7, 0)).toBe(true);
    expect(count(grid)).toBeGreaterThanOrEqual(before);
  });

  test('a rate is that of time, not of frames', () => {
    const weight = (hz: number) => {
      const grid = createVoxelGrid(SETTINGS);
      for (let i = 0; i < hz / 10; i++) grid.update({ ...SEEN_BOX, deltaS: 1 / hz });
      return grid.weightAt(0, 7, 0);
    };
    expect(weight(60)).toBeCloseTo(weight(30), 6);
    expect(weight(10)).toBeCloseTo(weight(30), 6);
  });

  test('numbers that are none change nothing', () => {
    const grid = createVoxelGrid(SETTINGS);
    grid.update({ ...SEEN_BOX, worldFromDepth: new Array(16).fill(Number.NaN) });
    grid.update(look(EYE, CENTER, () => Number.NaN));
    let n = 0;
    grid.forEachOccupied(() => n++);
    expect(n).toBe(0);
  });
});

describe('bodies in a room', () => {
  const see = (lab: ReturnType<typeof createLab>, box: typeof BOX | null, frames = 30) => {
    for (let i = 0; i < frames; i++) lab.engine.apply({ kind: 'depth', frame: box ? SEEN_BOX : SEEN_FLOOR });
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

  test.each([false, true])('a box that lands flat bounces straight up (a smooth surface: %p)', (isSmooth) => {
    const lab = createLab();
    lab.engine.apply({ kind: 'room', room: { ...SETTINGS, isSmooth }, friction: 0.5, restitution: 0 });
    for (let i = 0; i < 20; i++) lab.engine.apply({ kind: 'depth', frame: SEEN_FLOOR });
    const id = lab.add({ shapes: cube(0.4), restitution: 0.6 }, { positionM: [0, 1, 0] });
    lab.run(3);
    const { positionM, rotation } = lab.body(id);
    expect(Math.hypot(positionM[0], positionM[2])).toBeLessThan(0.05);
    expect(2 * Math.hypot(rotation[0], rotation[1], rotation[2])).toBeLessThan(0.15);
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

/** A plane that rises towards -x. */
const slope = (angleRad: number) => (ray: Ray) => {
  const [nx, ny] = [Math.sin(angleRad), Math.cos(angleRad)];
  const speed = nx * ray.to.x + ny * ray.to.y;
  return speed < 0 ? (0.3 * ny - nx * ray.from.x - ny * ray.from.y) / speed : Number.POSITIVE_INFINITY;
};

describe('a smooth surface', () => {
  const G = 9.81;
  const RADIUS_M = 0.05;
  /** Rolls a ball for 80 cm over a plane that depth has shown. */
  function roll(isSmooth: boolean, angleRad: number, startMps: number) {
    const lab = createLab({ sleep: true });
    lab.engine.apply({ kind: 'room', room: { ...SETTINGS, isSmooth }, friction: 1, restitution: 0 });
    const frame = look(new Vector3(0.1, 1.4, 1), new Vector3(0, 0.3, 0), slope(angleRad));
    for (let i = 0; i < 30; i++) lab.engine.apply({ kind: 'depth', frame });
    const [nx, ny] = [Math.sin(angleRad), Math.cos(angleRad)];
    const heightM = ([x, y]: readonly number[]) => nx * (x ?? 0) + ny * ((y ?? 0) - 0.3) - RADIUS_M;
    const start = new Vector3(-0.4, 0.3 + (RADIUS_M + 0.4 * nx) / ny, 0.02);
    const velocity = [startMps * ny, -startMps * nx, 0] as const;
    const id = lab.add(
      { shapes: ball(RADIUS_M), friction: 1 },
      { positionM: [start.x, start.y, start.z], velocity, spin: [0, 0, -startMps / RADIUS_M] },
    );
    let [mostM, leastM, rolledM] = [-1, 1, 0];
    for (let frame = 0; frame < 600 && rolledM < 0.8; frame++) {
      lab.run(1 / 60);
      const { positionM } = lab.body(id);
      rolledM = ny * (positionM[0] - start.x) - nx * (positionM[1] - start.y);
      if (rolledM > 0.1) {
        mostM = Math.max(mostM, heightM(positionM));
        leastM = Math.min(leastM, heightM(positionM));
      }
    }
    const exactMps = Math.sqrt(startMps ** 2 + (10 / 7) * G * nx * rolledM);
    return { mostM, leastM, speed: Math.hypot(...lab.body(id).velocity) / exactMps, rolledM };
  }

  test.each([0, 5, 15])('a ball rolls down %p° as on a plane, where voxels are steps', (degrees) => {
    const angleRad = (degrees * Math.PI) / 180;
    const smooth = roll(true, angleRad, 0.7);
    expect(smooth.rolledM).toBeGreaterThanOrEqual(0.8);
    expect(smooth.mostM).toBeLessThan(0.001);
    expect(smooth.leastM).toBeGreaterThan(-0.001);
    expect(smooth.speed).toBeGreaterThan(0.99);
    expect(smooth.speed).toBeLessThan(1.01);
    const boxes = roll(false, angleRad, 0.7);
    expect(smooth.mostM).toBeLessThan(boxes.mostM - 0.01);
    expect(smooth.speed).toBeGreaterThan(boxes.speed + 0.05);
    if (degrees > 0) expect(boxes.mostM - boxes.leastM).toBeGreaterThan(0.02);
  });

  test('boxes rest on it flat, and fast balls do not pass', () => {
    const lab = createLab({ sleep: true });
    lab.engine.apply({ kind: 'room', room: { ...SETTINGS, isSmooth: true }, friction: 0.6, restitution: 0.1 });
    for (let i = 0; i < 30; i++) lab.engine.apply({ kind: 'depth', frame: SEEN_BOX });
    const box = lab.add({ shapes: cube(0.12) }, { positionM: [-0.06, 0.6, -0.06] });
    const shot = lab.add({ shapes: ball(0.03) }, { positionM: [0.12, 1.63, 0.12], velocity: [0, -30, 0] });
    lab.run(0.1);
    expect(lab.body(shot).positionM[1]).toBeGreaterThan(BOX.top);
    lab.run(3);
    expect(lab.body(box).positionM[1] - 0.06).toBeCloseTo(BOX.top, 2);
    expect(lab.body(box).isAsleep).toBe(true);
  });
});

test('depth that jumps by 40 cm and back in each frame throws no resting body, and none falls through', () => {
  const lab = createLab({ sleep: true });
  lab.engine.apply({ kind: 'room', room: SETTINGS, friction: 0.6, restitution: 0.1 });
  for (let i = 0; i < 30; i++) lab.engine.apply({ kind: 'depth', frame: SEEN_BOX });
  const ids = [-0.1, 0, 0.1].map((x) => lab.add({ shapes: ball(0.05), rollingM: 0.005 }, { positionM: [x, BOX.top + 0.1, 0] }));
  lab.run(2);
  const nearer = { ...SEEN_BOX, meters: Float32Array.from(SEEN_BOX.meters, (d) => d && d - 0.4) };
  let fastest = 0;
  lab.run(4, (frame) => {
    if (frame % 2 === 0) lab.engine.apply({ kind: 'depth', frame: frame % 4 === 0 ? nearer : SEEN_BOX });
    for (const id of ids) fastest = Math.max(fastest, Math.hypot(...lab.body(id).velocity));
  });
  expect(fastest).toBeLessThan(4);
  for (const id of ids) expect(lab.body(id).positionM[1]).toBeGreaterThan(0.04);
});

describe('the memory of the grid', () => {
  test('follows the surface, not the space', () => {
    const chunksOf = (sideM: number) => {
      const grid = createVoxelGrid({ ...SETTINGS, farM: 20 });
      // A wall that is as far away as it is wide.
      for (let i = 0; i < 3; i++) grid.update(look(new Vector3(), new Vector3(0, 0, -1), () => sideM));
      return grid.chunkCount;
    };
    expect(chunksOf(4) / chunksOf(2)).toBeLessThan(5);
    // A dense grid of the same space has (2 / 0.4)³ = 125 chunks.
    expect(chunksOf(2)).toBeLessThan(50);
  });

  test('depth of any numbers leaves only finite bodies', () => {
    const lab = createLab();
    lab.engine.apply({ kind: 'room', room: { ...SETTINGS, isSmooth: true }, friction: 0.6, restitution: 0.1 });
    const ids = [0, 1, 2].map((i) => lab.add({ shapes: i === 1 ? cube(0.1) : ball(0.05) }, { positionM: [0.1 * i, 0.6, 0] }));
    const strange = [Number.NaN, Number.POSITIVE_INFINITY, -1, 0, 1e-9, 1e30];
    for (let i = 0; i < 60; i++) {
      const frame = SEEN_BOX;
      const meters = Float32Array.from(frame.meters, (d, k) => ((k * 7919 + i) % 5 === 0 ? (strange[(k + i) % 6] ?? 0) : d));
      const worldFromDepth = i % 7 === 0 ? new Array<number>(16).fill(Number.NaN) : frame.worldFromDepth;
      lab.engine.apply({ kind: 'depth', frame: { ...frame, meters, worldFromDepth } });
      lab.run(1 / 30);
      for (const id of ids) expect([...lab.body(id).positionM, ...lab.body(id).velocity].every(Number.isFinite)).toBe(true);
    }
  });
});

test('600 steps in a room give the same bytes twice', () => {
  const play = () => {
    const lab = createLab({ sleep: true });
    lab.engine.apply({ kind: 'room', room: { ...SETTINGS, isSmooth: true }, friction: 0.6, restitution: 0.1 });
    const frame = SEEN_BOX;
    for (let i = 0; i < 20; i++) lab.engine.apply({ kind: 'depth', frame });
    for (let i = 0; i < 6; i++)
      lab.add({ shapes: i % 2 ? ball(0.05) : cube(0.1) }, { positionM: [0.05 * Math.sin(i), 0.6 + 0.2 * i, 0.05 * Math.cos(i)] });
    lab.run(10, (n) => n % 20 === 0 && lab.engine.apply({ kind: 'depth', frame }));
    return [...lab.all().values()];
  };
  expect(play()).toEqual(play());
});

describe('physics/room', () => {
  function start() {
    const image = {
      meters: new Float32Array(320 * 240).fill(1.5),
      widthPx: 320,
      heightPx: 240,
      uvFromViewUv: Float32Array.of(1, 0, 0, 0, 1, 0, 0, 0, 1),
      clipFromView: Float32Array.from(new Matrix4().makePerspective(-0.1, 0.1, 0.075, -0.075, 0.1, 100).elements),
      worldFromView: Float32Array.from(new Matrix4().makeTranslation(0, 1, 0).elements),
      frame: 0,
    };
    const fake = fakeContext(definition, {
      services: { session: { sessions: 0, depthImage: () => image, answerRays: () => () => {} } as never },
    });
    const node = create(fake.ctx);
    const frame = () => {
      image.frame++;
      fake.tick(1 / 30);
      node.update({ jumps: 0 } as never);
    };
    return { ...fake, node, frame, room: fake.ctx.outputs.body.room };
  }

  test('gives thinned depth in buffers that are used again', () => {
    const { frame, room: shared } = start();
    const buffers = new Set<unknown>();
    for (let i = 0; i < 50; i++) {
      frame();
      const [depth] = shared?.frames.splice(0) ?? [];
      expect([depth?.widthPx, depth?.heightPx, depth?.meters[0]]).toEqual([160, 120, 1.5]);
      // The middle of the first texel: tan 45° at the border of the view.
      expect(depth?.rayFromTexel[2]).toBeCloseTo(-1 + 1 / 320, 6);
      buffers.add(depth?.meters);
    }
    expect(buffers.size).toBeLessThanOrEqual(3);
  });

  test('two frames that wait are not overwritten by the next ones', () => {
    const { frame, room: shared } = start();
    for (let i = 0; i < 5; i++) frame();
    expect(shared?.frames).toHaveLength(2);
    expect(shared?.frames[0]?.meters).not.toBe(shared?.frames[1]?.meters);
  });

  test('a room that is disconnected no longer holds bodies, and one that fell out of a room is lost', () => {
    const stage = createStage({ floor: false });
    const frames = Array.from({ length: 20 }, () => SEEN_FLOOR);
    stage.list.room = createPhysicsRoom(SETTINGS, 0.6, 0);
    stage.list.room.frames.push(...frames);
    const body = stage.add([0, 0.2, 0], ball(0.05));
    const away = stage.add([0, -0.8, 0], ball(0.05));
    const idle = { update: () => {} } as never;
    stage.play(60, idle, fakeContext(definition));
    expect(placeOf(body)[1]).toBeGreaterThan(0.05);
    expect([body.isLost, away.isLost]).toEqual([false, true]);
    const control = body.world?.control;
    if (!control) throw new Error('No world has taken the body.');
    expect(control.voxels).toBeNull();
    control.wantsVoxels = true;
    stage.play(3, idle, fakeContext(definition));
    // The floor, which is half a voxel thick in each of them.
    const heights = (control.voxels ?? new Float32Array()).filter((_, i) => i % 3 === 1);
    expect(heights.length).toBeGreaterThan(100);
    expect(Math.max(...heights)).toBeLessThanOrEqual(control.edgeM);
    control.wantsVoxels = false;
    stage.play(3, idle, fakeContext(definition));
    expect(control.voxels).toBeNull();
    delete stage.list.room;
    stage.list.version++;
    stage.play(60, idle, fakeContext(definition));
    expect(placeOf(body)[1]).toBeLessThan(-2);
  });
});
