import { execFile } from 'node:child_process';
import { mkdtemp, rm } from 'node:fs/promises';
import { tmpdir } from 'node:os';
import { dirname, join, resolve } from 'node:path';
import process from 'node:process';
import { promisify } from 'node:util';
import { afterAll, beforeAll, describe, expect, test } from '@jest/globals';
import { Vector3 } from 'three';
import { addDepthNoise, type DepthNoise } from '../../export/emulator/depth/depth-noise.ts';
import type { DepthFrame, VoxelSettings } from '../../nodes/kit/physics.ts';
import { createVoxelGrid } from '../../nodes/physics/world/voxel-grid.ts';
import { crossesSurface, nearestIn, pointAt, pointsOf, readDepthSession } from '../support/physics/depth-session.ts';
import { ball, createLab } from '../support/physics/lab.ts';
import { describeWithData } from '../support/shared-data.ts';

const run = promisify(execFile);
const SETTINGS: VoxelSettings = { edgeM: 0.05, threshold: 0.5, speed: 0.2, farM: 5 };
const FRAMES = 30;
const LEAST_EQUAL = 0.97;

/** The part of all voxels that have the same occupancy as by ray traversal, after so many frames. */
function equalToRays(frames: readonly DepthFrame[]): { equal: number; count: number } {
  const grid = createVoxelGrid(SETTINGS);
  const { edgeM: e } = SETTINGS;
  const weights = new Map<number, number>();
  const keyOf = (x: number, y: number, z: number) => (x + 1000) * 4e6 + (y + 1000) * 2000 + z + 1000;
  const at = (p: Vector3) => keyOf(Math.floor(p.x / e), Math.floor(p.y / e), Math.floor(p.z / e));
  for (const frame of frames) {
    grid.update(frame);
    // Each ray frees the voxels before its end, but for the last edge, and occupies that of its end.
    const hit = new Set<number>();
    const passed = new Set<number>();
    const eye = new Vector3().fromArray([...(frame.worldFromDepth as number[])], 12);
    const p = new Vector3();
    for (let n = 0; n < frame.widthPx * frame.heightPx; n++) {
      const d = frame.meters[n] ?? 0;
      if (d <= 0 || d >= SETTINGS.farM) continue;
      const end = pointAt(frame, n);
      hit.add(at(end));
      const to = end.sub(eye);
      for (let s = 0; s < 1 - e / d; s += 0.025 / d) passed.add(at(p.copy(eye).addScaledVector(to, s)));
    }
    for (const key of hit) weights.set(key, (weights.get(key) ?? 0) * 0.8 + 0.2);
    for (const key of passed) if (!hit.has(key) && weights.has(key)) weights.set(key, (weights.get(key) ?? 0) * 0.8);
  }
  const occupied = new Set<number>();
  grid.forEachOccupied((x, y, z) => occupied.add(keyOf(x, y, z)));
  const keys = new Set([...weights.keys(), ...occupied]);
  const equal = [...keys].filter((key) => occupied.has(key) === (weights.get(key) ?? 0) >= 0.5).length;
  return { equal: equal / keys.size, count: keys.size };
}

describe('in the studio', () => {
  test('the grid has the occupancy of a ray traversal', () => {
    const session = readDepthSession(resolve(import.meta.dirname, '../../examples/sessions/studio'));
    const { equal, count } = equalToRays(session.frames(FRAMES));
    expect(count).toBeGreaterThan(1000);
    expect(equal).toBeGreaterThan(LEAST_EQUAL);
  });
});

describeWithData('in a recorded living room', 'sessions/icl-livingroom/session.json', (path) => {
  let folder = '';
  beforeAll(async () => {
    folder = await mkdtemp(join(tmpdir(), 'scrim-room-'));
    await run(process.execPath, ['tools/run.mjs', 'sessions/convert-session.ts', dirname(path), folder]);
  });
  afterAll(() => rm(folder, { recursive: true, force: true }));

  test('the grid has the occupancy of a ray traversal', () => {
    const { equal, count } = equalToRays(readDepthSession(folder).frames(FRAMES));
    expect(count).toBeGreaterThan(2000);
    expect(equal).toBeGreaterThan(LEAST_EQUAL);
  });

  /** The noise of the emulated headset. */
  const NOISE: DepthNoise = { sigmaM: 0.01, sigmaPerM: 0.005, holes: 0.05, seed: 3 };
  const RADIUS_M = 0.04;
  const BALLS = 100;
  /** Balls fall 30 cm inside the area that the last frame shows. */
  const INSIDE = 3;

  test.each([
    ['voxels', false, null, 60, 0.06, 95],
    ['a smooth surface', true, null, 60, 0.02, 95],
    ['voxels of a noisy sensor', false, NOISE, 20, 0.06, 95],
    ['a smooth surface of a noisy sensor', true, NOISE, 20, 0.02, 90],
  ] as const)(
    'of 100 balls that rain, nearly all rest on %s and none falls through while the last frame is held',
    (_name, isSmooth, noise, seconds, nearM, least) => {
      const lab = createLab({ sleep: true });
      lab.engine.apply({ kind: 'room', room: { ...SETTINGS, isSmooth }, friction: 0.6, restitution: 0.1 });
      const frames = readDepthSession(folder).frames(60);
      const last = frames.at(-1);
      if (!last) throw new Error('There are no frames.');
      let shot = 0;
      const see = (frame: DepthFrame) => {
        const meters = Float32Array.from(frame.meters);
        if (noise) addDepthNoise(meters, noise, `${shot++}`);
        lab.engine.apply({ kind: 'depth', frame: { ...frame, meters } });
      };
      for (const frame of frames) see(frame);
      for (let i = 0; i < 15; i++) see(last);
      const distanceTo = nearestIn(frames.flatMap(pointsOf), 0.1);
      const crosses = crossesSurface(last);

      // Columns of 10 cm that the last frame shows, with their highest point.
      const seen = pointsOf(last);
      const columns = new Map<string, number>();
      const columnOf = (x: number, z: number) => `${x} ${z}`;
      const cell = (v: number) => Math.floor(v / 0.1);
      for (const { x, y, z } of seen) columns.set(columnOf(cell(x), cell(z)), Math.max(columns.get(columnOf(cell(x), cell(z))) ?? -9, y));
      const inner = seen.filter(({ x, z }) => {
        for (let i = -INSIDE; i <= INSIDE; i++)
          for (let j = -INSIDE; j <= INSIDE; j++) if (!columns.has(columnOf(cell(x) + i, cell(z) + j))) return false;
        return true;
      });
      let drops = 0;
      const place = (): [number, number, number] => {
        const { x, z } = inner[Math.floor(((drops++ * 0.618034) % 1) * inner.length)] ?? new Vector3();
        return [x, (columns.get(columnOf(cell(x), cell(z))) ?? 0) + 0.3, z];
      };

      const balls: { readonly id: number; readonly before: Vector3; restS: number; bestS: number; restsAt: Vector3 }[] = [];
      let throughCount = 0;
      let lostCount = 0;
      for (let frame = 0; frame < seconds * 60; frame++) {
        if (frame % 3 === 0 && balls.length < BALLS) {
          const positionM = place();
          const id = lab.add({ shapes: ball(RADIUS_M), rollingM: 0.004, massKg: 0.1 }, { positionM });
          balls.push({ id, before: new Vector3(...positionM), restS: 0, bestS: 0, restsAt: new Vector3() });
        }
        if (frame % 2 === 0) see(last);
        lab.run(1 / 60);
        const all = lab.all();
        for (const each of balls) {
          const body = all.get(each.id);
          if (!body) throw new Error('A ball is missing.');
          const p = new Vector3(...body.positionM);
          if (p.distanceTo(each.before) > 1e-5 && crosses(each.before, p)) throughCount++;
          each.before.copy(p);
          each.restS = Math.hypot(...body.velocity) < 0.01 ? each.restS + 1 / 60 : 0;
          if (each.restS > 1) each.restsAt.copy(p);
          each.bestS = Math.max(each.bestS, each.restS);
          if (!body.isLost) continue;
          // As a body node recycles it.
          lostCount++;
          const positionM = place();
          each.before.set(...positionM);
          each.bestS = 0;
          const worldFromBody = [1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, ...positionM, 1];
          lab.engine.apply({ kind: 'move', id: each.id, worldFromBody, velocity: [0, 0, 0] });
        }
      }
      const rested = balls.filter(
        ({ bestS, before, restsAt }) => bestS > 1 && before.distanceTo(restsAt) < nearM && Math.abs(distanceTo(before) - RADIUS_M) < nearM,
      );
      expect(throughCount).toBe(0);
      expect(rested.length).toBeGreaterThanOrEqual(least);
      // Those that left roll over the border of what was seen.
      expect(lostCount).toBeLessThan(15);
    },
  );
});
