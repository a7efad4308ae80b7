import { execFile } from 'node:child_process';
import { readFileSync } from 'node:fs';
import { mkdtemp, rm } from 'node:fs/promises';
import { tmpdir } from 'node:os';
import { dirname, join } from 'node:path';
import process from 'node:process';
import { promisify } from 'node:util';
import { afterAll, beforeAll, expect, test } from '@jest/globals';
import { Matrix4, Vector3 } from 'three';
import { decodeDepth } from '../../export/runtime/sessions/recorded/decode-depth.ts';
import type { DepthFrame, VoxelSettings } from '../../nodes/kit/physics.ts';
import { createVoxelGrid } from '../../nodes/physics/world/voxel-grid.ts';
import { ball, createLab } from '../support/physics/lab.ts';
import { describeWithData } from '../support/shared-data.ts';

const run = promisify(execFile);
const SETTINGS: VoxelSettings = { edgeM: 0.05, threshold: 0.5, speed: 0.2, farM: 5 };

describeWithData('in a recorded living room', 'sessions/icl-livingroom/session.json', (path) => {
  let folder = '';
  // biome-ignore lint/suspicious/noExplicitAny: the file is checked by its own test.
  let session: any;
  const STRIDE = 4;
  let width = 0;
  let height = 0;

  beforeAll(async () => {
    folder = await mkdtemp(join(tmpdir(), 'scrim-room-'));
    await run(process.execPath, ['tools/run.mjs', 'sessions/convert-session.ts', dirname(path), folder]);
    session = JSON.parse(readFileSync(join(folder, 'session.json'), 'utf8'));
    width = session.depth.widthPx / STRIDE;
    height = session.depth.heightPx / STRIDE;
  });
  afterAll(() => rm(folder, { recursive: true, force: true }));

  function frameAt(index: number): DepthFrame {
    const { depth, worldFromCamera } = session.frames[index];
    const { widthPx, intrinsics: k } = session.depth;
    const all = decodeDepth(new Uint8Array(readFileSync(join(folder, depth))).buffer, session.depth);
    const meters = Float32Array.from(
      { length: width * height },
      (_, n) => all[Math.floor(n / width) * STRIDE * widthPx + (n % width) * STRIDE] ?? 0,
    );
    const rayFromTexel = [STRIDE / k.fxPx, 0, (0.5 - k.cxPx) / k.fxPx, 0, -STRIDE / k.fyPx, (k.cyPx - 0.5) / k.fyPx];
    return { meters, widthPx: width, heightPx: height, worldFromDepth: worldFromCamera, rayFromTexel, deltaS: 1 / 30 };
  }

  /** Where the ray of a texel ends, world space. */
  function pointAt({ meters, worldFromDepth: m, rayFromTexel: r }: DepthFrame, n: number): Vector3 {
    const d = meters[n] ?? 0;
    const x = (r[0] ?? 0) * (n % width) + (r[2] ?? 0);
    const y = (r[4] ?? 0) * Math.floor(n / width) + (r[5] ?? 0);
    return new Vector3(x * d, y * d, -d).applyMatrix4(new Matrix4().fromArray([...(m as number[])]));
  }

  const LEAST_EQUAL = 0.99;
  const MOST_LOST = 30;
  /** Frames that build the room. */
  const FRAMES = 10;

  test('the grid has the occupancy of a ray traversal', () => {
    const grid = createVoxelGrid(SETTINGS);
    const { edgeM: e } = SETTINGS;
    const weights = new Map<number, number>();
    const keyOf = (x: number, y: number, z: number) => (x + 1000) * 4e6 + (y + 1000) * 2000 + z + 1000;
    const at = (p: Vector3) => keyOf(Math.floor(p.x / e), Math.floor(p.y / e), Math.floor(p.z / e));
    for (let f = 0; f < FRAMES; f++) {
      const frame = frameAt(f);
      grid.update(frame);
      // Each ray frees the voxels before its end, but for the last edge, and occupies that of its end.
      const hit = new Set<number>();
      const passed = new Set<number>();
      const eye = new Vector3().fromArray([...(frame.worldFromDepth as number[])], 12);
      const p = new Vector3();
      for (let n = 0; n < width * height; n++) {
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
    expect(keys.size).toBeGreaterThan(2000);
    expect(equal / keys.size).toBeGreaterThan(LEAST_EQUAL);
  });

  test('of 100 balls, 95 % of those that stay in the observed area come to rest on what was measured, and fewer than 30 leave it', () => {
    const lab = createLab({ sleep: true });
    lab.engine.apply({ kind: 'room', room: SETTINGS, friction: 0.6, restitution: 0.1 });
    const cells = new Map<string, Vector3[]>();
    const cellOf = (p: Vector3, size: number) => [Math.floor(p.x / size), Math.floor(p.y / size), Math.floor(p.z / size)] as const;
    const SIZE = 0.12;
    let seen: Vector3[] = [];
    for (let f = 0; f < FRAMES; f++) {
      const frame = frameAt(f);
      lab.engine.apply({ kind: 'depth', frame });
      seen = [];
      for (let n = 0; n < width * height; n++) {
        const d = frame.meters[n] ?? 0;
        if (d < 0.3 || d > 4.5) continue;
        const point = pointAt(frame, n);
        seen.push(point);
        const key = cellOf(point, SIZE).join(' ');
        cells.set(key, [...(cells.get(key) ?? []), point]);
      }
    }
    /** The distance to the nearest measured point, up to a cell. */
    const distanceTo = (p: Vector3) => {
      const [x, y, z] = cellOf(p, SIZE);
      let least = SIZE;
      for (let i = -1; i <= 1; i++)
        for (let j = -1; j <= 1; j++)
          for (let k = -1; k <= 1; k++)
            for (const q of cells.get(`${x + i} ${y + j} ${z + k}`) ?? []) least = Math.min(least, q.distanceTo(p));
      return least;
    };
    // Inside the observed area: over a patch of 40 cm that was seen all over, by its highest points.
    const columns = new Map<string, number>();
    const columnOf = (p: Vector3) => `${Math.floor(p.x / 0.1)} ${Math.floor(p.z / 0.1)}`;
    for (const p of seen) columns.set(columnOf(p), Math.max(columns.get(columnOf(p)) ?? -9, p.y));
    const inner = seen.filter((p) => {
      const x = Math.floor(p.x / 0.1);
      const z = Math.floor(p.z / 0.1);
      for (let i = -2; i <= 2; i++) for (let j = -2; j <= 2; j++) if (!columns.has(`${x + i} ${z + j}`)) return false;
      return true;
    });
    const radiusM = 0.04;
    const ids = Array.from({ length: 100 }, (_, i) => {
      const p = inner[Math.floor(((i * 0.618034) % 1) * inner.length)] ?? new Vector3();
      const y = (columns.get(columnOf(p)) ?? 0) + 0.3;
      return lab.add({ shapes: ball(radiusM), rollingM: 0.004, massKg: 0.1 }, { positionM: [p.x, y, p.z] });
    });
    lab.run(8);
    const lowest = Math.min(...columns.values());
    const results = ids.map((id) => {
      const { positionM, velocity } = lab.body(id);
      return { gapM: distanceTo(new Vector3(...positionM)) - radiusM, speed: Math.hypot(...velocity), y: positionM[1] };
    });
    const rested = results.filter(({ gapM, speed }) => Math.abs(gapM) < 0.06 && speed < 0.01);
    const lost = results.filter(({ y }) => y < lowest - 0.5);
    // The others left the observed area: beyond it there is nothing to rest on.
    expect(lost.length).toBeLessThan(MOST_LOST);
    expect(rested.length / (100 - lost.length)).toBeGreaterThanOrEqual(0.95);
  });
});
