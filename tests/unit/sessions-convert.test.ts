import { execFile } from 'node:child_process';
import { existsSync } from 'node:fs';
import { mkdir, mkdtemp, readdir, readFile, rm, writeFile } from 'node:fs/promises';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import process from 'node:process';
import { promisify } from 'node:util';
import { afterAll, beforeAll, describe, expect, test } from '@jest/globals';
import { readSessionFile } from '../../export/runtime/sessions/recorded/read-session-file.ts';
import { dot, normalize, scale, subtract, transformDirection, type Vector } from '../../tools/sessions/vector.ts';
import { describeWithData } from '../support/shared-data.ts';
import { readPng16, writePng16 } from './png16.ts';
import { loadSession, quantile, reproject, toDegrees, worldPoints } from './sessions-kit.ts';

const run = promisify(execFile);
let folder: string;

/** The converter as a user starts it. */
async function convert(input: string, output: string, ...options: string[]): Promise<{ readonly code: number; readonly said: string }> {
  try {
    const { stdout, stderr } = await run(process.execPath, ['tools/run.mjs', 'sessions/convert-session.ts', input, output, ...options]);
    return { code: 0, said: stdout + stderr };
  } catch (error) {
    const { code, stdout, stderr } = error as { code: number; stdout: string; stderr: string };
    return { code, said: stdout + stderr };
  }
}

beforeAll(async () => {
  folder = await mkdtemp(join(tmpdir(), 'scrim-convert-'));
});
afterAll(async () => {
  await rm(folder, { recursive: true, force: true });
});

// --- A room that is known: a floor, two walls and a large table, recorded in a world that is tilted and shifted ------------------

const WIDTH = 160;
const HEIGHT = 120;
/** OpenCV's: pixel centers at whole numbers. */
const INTRINSICS = { fx: 130, fy: 130, cx: 79.5, cy: 59.5 };
const EYE_HEIGHT_M = 1.4;

type Rotation = readonly [Vector, Vector, Vector];

function turn(axis: Vector, angleRad: number): Rotation {
  const [x, y, z] = normalize(axis);
  const [s, c] = [Math.sin(angleRad), Math.cos(angleRad)];
  const k = 1 - c;
  // Rows.
  return [
    [c + x * x * k, x * y * k - z * s, x * z * k + y * s],
    [y * x * k + z * s, c + y * y * k, y * z * k - x * s],
    [z * x * k - y * s, z * y * k + x * s, c + z * z * k],
  ];
}

function apply(r: Rotation, v: Vector): Vector {
  return [dot(r[0], v), dot(r[1], v), dot(r[2], v)];
}

/** Distance to the nearest surface along a ray, in units of its direction: floor, wall at z = −3, wall at x = −2.5, table top. */
function meet(o: Vector, d: Vector): number {
  const hits = [-o[1] / d[1], (-3 - o[2]) / d[2], (-2.5 - o[0]) / d[0]];
  const table = (0.72 - o[1]) / d[1];
  const [tx, tz] = [o[0] + d[0] * table, o[2] + d[2] * table];
  if (tx > -0.6 && tx < 1.4 && tz > -2.4 && tz < -1.1) hits.push(table);
  return Math.min(...hits.filter((t) => t > 1e-6));
}

const RECORDED_FROM_ROOM = turn([0.3, 0.5, 0.8], 0.35);
const SHIFT: Vector = [4, -2, 7];

/** A walk that looks down at the room; camera axes as OpenCV has them (x right, y down, z forward), as columns. */
function cameraAt(i: number): { readonly eye: Vector; readonly axes: readonly [Vector, Vector, Vector] } {
  const eye: Vector = [0.2 + 0.08 * i, EYE_HEIGHT_M + 0.02 * i, 1.2 - 0.05 * i];
  const forward = normalize(subtract([-0.2 + 0.05 * i, 0.5, -1.5], eye));
  const right = normalize([-forward[2], 0, forward[0]]);
  const down: Vector = [
    forward[1] * right[2] - forward[2] * right[1],
    forward[2] * right[0] - forward[0] * right[2],
    forward[0] * right[1] - forward[1] * right[0],
  ];
  return { eye, axes: [right, down, forward] };
}

async function writeRecording(to: string, frameCount: number): Promise<void> {
  const frames: object[] = [];
  await mkdir(join(to, 'depth'), { recursive: true });
  await mkdir(join(to, 'color'), { recursive: true });
  for (let i = 0; i < frameCount; i++) {
    const { eye, axes } = cameraAt(i);
    const data = new Uint16Array(WIDTH * HEIGHT);
    for (let p = 0; p < data.length; p++) {
      const [x, y] = [((p % WIDTH) - INTRINSICS.cx) / INTRINSICS.fx, (Math.floor(p / WIDTH) - INTRINSICS.cy) / INTRINSICS.fy];
      const direction = [0, 1, 2].map((k) => (axes[0][k] ?? 0) * x + (axes[1][k] ?? 0) * y + (axes[2][k] ?? 0)) as unknown as Vector;
      // The direction advances 1 m along the camera's axis, so the factor is the depth.
      data[p] = Math.round(meet(eye, direction) * 1000);
    }
    await writeFile(join(to, `depth/${i}.png`), writePng16(data, WIDTH, HEIGHT));
    await writeFile(join(to, `color/${i}.jpg`), `color ${i}`);
    const columns = axes.map((axis) => apply(RECORDED_FROM_ROOM, axis));
    const origin = apply(RECORDED_FROM_ROOM, eye).map((n, k) => n + (SHIFT[k] ?? 0));
    const rows = [0, 1, 2].map((k) => [...columns.map((column) => column[k]), origin[k]]);
    frames.push({ index: i, t: i / 10, color: `color/${i}.jpg`, depth: `depth/${i}.png`, cameraToWorld: [...rows.flat(), 0, 0, 0, 1] });
  }
  const session = {
    description: 'A test room',
    source: 'this test',
    licence: 'none',
    width: WIDTH,
    height: HEIGHT,
    intrinsics: INTRINSICS,
    depth: { unit_m: 0.001, kind: 'z along optical axis' },
    fps: 10,
    frames,
  };
  await writeFile(join(to, 'session.json'), JSON.stringify(session));
}

describe('a tilted recording of a known room', () => {
  let output: string;

  beforeAll(async () => {
    const input = join(folder, 'tilted');
    output = join(folder, 'level');
    await writeRecording(input, 8);
    expect(await convert(input, output)).toMatchObject({ code: 0, said: expect.stringContaining('8 frames') });
  });

  test('is a session that Scrim reads, with pictures and credits', async () => {
    const json: unknown = JSON.parse(await readFile(join(output, 'session.json'), 'utf8'));
    expect(readSessionFile(json).diagnostics).toEqual([]);
    expect(json).toMatchObject({
      title: 'A test room',
      credit: 'this test',
      licence: 'none',
      color: { widthPx: WIDTH, heightPx: HEIGHT, intrinsics: { fxPx: 130, fyPx: 130, cxPx: 80, cyPx: 60 } },
      depth: { metresPerUnit: 0.001, kind: 'z' },
    });
    expect((await readdir(join(output, 'color'))).length).toBe(8);
    expect(await readFile(join(output, 'color/3.jpg'), 'utf8')).toBe('color 3');
  });

  test('stands upright on its floor, the origin below the first camera, which looks along −z', async () => {
    const { file } = await loadSession(output);
    file.frames.forEach(({ worldFromCamera }, i) => {
      const { eye, axes } = cameraAt(i);
      const [x = 0, y = 0, z = 0] = worldFromCamera.slice(12, 15);
      expect(y).toBeCloseTo(eye[1], 2);
      const first = cameraAt(0).eye;
      expect(Math.hypot(x, z)).toBeCloseTo(Math.hypot(eye[0] - first[0], eye[2] - first[2]), 2);
      // The room's up in the camera's own axes: what the tilt had spoilt.
      const up = transformDirection(worldFromCamera, [0, 1, 0]);
      const trueUp = -(axes[1][1] ?? 0);
      expect(toDegrees(Math.abs(Math.acos(up[1]) - Math.acos(trueUp)))).toBeLessThan(0.15);
    });
    const forward = transformDirection(file.frames[0]?.worldFromCamera ?? [], [0, 0, -1]);
    expect(forward[0]).toBeCloseTo(0, 3);
    expect(forward[2]).toBeLessThan(-0.5);
  });

  test('has its floor at y = 0, its table at 72 cm and its walls upright', async () => {
    const points = worldPoints(await loadSession(output), 6);
    const facingUp = points.filter(({ normal }) => normal[1] > 0.98);
    const floor = facingUp.filter(({ point }) => point[1] < 0.3).map(({ point }) => Math.abs(point[1]));
    const table = facingUp.filter(({ point }) => point[1] >= 0.3).map(({ point }) => point[1]);
    expect(floor.length).toBeGreaterThan(200);
    expect(Math.max(...floor)).toBeLessThan(0.01);
    expect(table.length).toBeGreaterThan(100);
    expect(table.reduce((sum, y) => sum + y, 0) / table.length).toBeCloseTo(0.72, 2);
    const walls = points.filter(({ normal }) => Math.abs(normal[1]) < 0.3);
    expect(walls.length).toBeGreaterThan(200);
    const lean = walls.map(({ normal }) => toDegrees(Math.abs(Math.asin(normal[1])))).sort((a, b) => a - b);
    expect(quantile(lean, 0.5)).toBeLessThan(0.6);
  });

  test('agrees with itself from frame to frame', async () => {
    const session = await loadSession(output);
    const differences = reproject(session, 0, 7, 5);
    expect(differences.length).toBeGreaterThan(200);
    expect(quantile(differences, 0.5)).toBeLessThan(0.01);
    expect(quantile(differences, 0.85)).toBeLessThan(0.04);
  });

  test('tells where the floor was seen', async () => {
    const { file } = await loadSession(output);
    const [floor] = file.surfaces ?? [];
    expect(floor).toMatchObject({ id: 'floor', kind: 'plane', orientation: 'horizontal', label: 'floor' });
    expect(floor?.polygonXZ.length).toBeGreaterThanOrEqual(3);
    // Its corners lie on the room's floor: within the walls that the first camera has 4.2 m ahead and 2.7 m to its left.
    for (const [x, z] of floor?.polygonXZ ?? []) expect(Math.hypot(x, z)).toBeLessThan(6);
  });

  test('comes out the same a second time', async () => {
    const again = join(folder, 'again');
    await convert(join(folder, 'tilted'), again);
    expect(await readFile(join(again, 'session.json'), 'utf8')).toBe(await readFile(join(output, 'session.json'), 'utf8'));
  });
});

describe('the raw form, a color image, a depth image and a pose for each frame', () => {
  /** The same recording as `writeRecording` writes, in the form of 7-Scenes. */
  async function writeFrames(to: string, frameCount: number, unitsOf: (units: Uint16Array) => void = () => {}): Promise<void> {
    const source = `${to}-source`;
    await writeRecording(source, frameCount);
    await mkdir(to, { recursive: true });
    const { frames } = JSON.parse(await readFile(join(source, 'session.json'), 'utf8')) as { frames: { cameraToWorld: number[] }[] };
    for (const [i, { cameraToWorld }] of frames.entries()) {
      const id = join(to, `frame-${String(i).padStart(6, '0')}`);
      const rows = [0, 1, 2, 3].map((row) => cameraToWorld.slice(row * 4, row * 4 + 4).join('\t '));
      await writeFile(`${id}.pose.txt`, `${rows.join('\n')}\n`);
      const { meters } = readPng16(await readFile(join(source, `depth/${i}.png`)), 0.001);
      const units = Uint16Array.from(meters, (m) => Math.round(m * 1000));
      unitsOf(units);
      await writeFile(`${id}.depth.png`, writePng16(units, WIDTH, HEIGHT));
      await writeFile(`${id}.color.png`, writePng16(new Uint16Array(WIDTH * HEIGHT), WIDTH, HEIGHT));
    }
  }

  const CAMERA = '130 0 79.5\n0 130 59.5\n0 0 1\n';

  test('becomes the same session as the same recording in the other form', async () => {
    const input = join(folder, 'frames');
    await writeFrames(input, 8);
    await writeFile(join(input, 'camera-intrinsics.txt'), CAMERA);
    const output = join(folder, 'from-frames');
    expect(await convert(input, output, '--fps', '10')).toMatchObject({ code: 0, said: expect.stringContaining('8 frames') });
    const { file } = await loadSession(output);
    const { file: other } = await loadSession(join(folder, 'level'));
    expect(readSessionFile(file).diagnostics).toEqual([]);
    expect(file.color).toEqual(other.color);
    expect(file.depth).toEqual(other.depth);
    expect(file.frames.map(({ timeS, worldFromCamera }) => ({ timeS, worldFromCamera }))).toEqual(
      other.frames.map(({ timeS, worldFromCamera }) => ({ timeS, worldFromCamera })),
    );
  });

  test('has no depth where the sensor wrote 65535', async () => {
    const input = join(folder, 'gaps');
    await writeFrames(input, 3, (units) => units.fill(65535, 0, WIDTH * 10));
    const output = join(folder, 'from-gaps');
    expect(await convert(input, output, '--intrinsics', '130,130,79.5,59.5')).toMatchObject({ code: 0 });
    const { meters } = readPng16(await readFile(join(output, 'frame-000001.depth.png')), 0.001);
    expect(meters.slice(0, WIDTH * 10).every((m) => m === 0)).toBe(true);
    const { meters: before } = readPng16(await readFile(join(input, 'frame-000001.depth.png')), 0.001);
    expect([...meters.slice(WIDTH * 10)]).toEqual([...before.slice(WIDTH * 10)]);
    expect(Math.max(...meters)).toBeLessThan(20);
  });

  test('leaves frames out whose pose was lost, and warns where the floor rests on few points', async () => {
    const input = join(folder, 'lost');
    // All but the middle of the image is unknown, so that little of the floor is left.
    await writeFrames(input, 2, (units) => {
      for (let i = 0; i < units.length; i++) if (Math.abs((i % WIDTH) - WIDTH / 2) > 12) units[i] = 0;
    });
    await writeFile(join(input, 'frame-000001.pose.txt'), Array(16).fill('nan').join(' '));
    const { code, said } = await convert(input, join(folder, 'from-lost'), '--intrinsics', '130,130,79.5,59.5');
    expect(code).toBe(0);
    expect(said).toContain('frames without a pose are left out: 1, the first is frame-000001');
    expect(said).toMatch(/Warning: the floor rests on \d+ points/);
  });

  test('is refused in words where something is missing', async () => {
    const input = join(folder, 'incomplete');
    await writeFrames(input, 1);
    const said = async (...options: string[]) => (await convert(input, `${input}-out`, ...options)).said;
    expect(await said()).toContain('there is no camera-intrinsics.txt. Give the camera with --intrinsics');
    expect(await said('--intrinsics', '130,130')).toContain('npm run convert-session');
    await rm(join(input, 'frame-000000.depth.png'));
    expect(await said('--intrinsics', '130,130,79.5,59.5')).toContain('frame-000000.depth.png is missing');
    await writeFile(join(input, 'frame-000000.pose.txt'), '1 0 0');
    expect(await said('--intrinsics', '130,130,79.5,59.5')).toContain('frame-000000.pose.txt has to hold 16 numbers, but holds 3');
    expect(existsSync(join(`${input}-out`, 'session.json'))).toBe(false);
  });
});

describe('what cannot be converted is refused in words', () => {
  async function complaint(change: (session: Record<string, unknown>) => void): Promise<string> {
    const input = await mkdtemp(join(folder, 'broken-'));
    await writeRecording(input, 1);
    const session = JSON.parse(await readFile(join(input, 'session.json'), 'utf8')) as Record<string, unknown>;
    change(session);
    await writeFile(join(input, 'session.json'), JSON.stringify(session));
    const output = `${input}-out`;
    const { code, said } = await convert(input, output);
    expect(code).toBe(1);
    expect(existsSync(join(output, 'session.json'))).toBe(false);
    return said;
  }

  test('depth along the ray', async () => {
    expect(await complaint((s) => Object.assign(s, { depth: { unit_m: 0.001, kind: 'range' } }))).toMatch(/depth along the camera's axis/);
  });

  test('a pose that is none', async () => {
    expect(await complaint((s) => Object.assign((s.frames as object[])[0] ?? {}, { cameraToWorld: [1, 2, 3] }))).toMatch(
      /cameraToWorld.*frame 0.*16 numbers/,
    );
  });

  test('a picture outside the folder', async () => {
    expect(await complaint((s) => Object.assign((s.frames as object[])[0] ?? {}, { color: '../../secret.jpg' }))).toMatch(
      /inside the folder/,
    );
  });

  test('a folder with something in it', async () => {
    expect(await convert(join(folder, 'tilted'), join(folder, 'tilted'))).toMatchObject({
      code: 1,
      said: expect.stringMatching(/not empty/),
    });
  });
});

// --- Real input: kept outside the repository ---------------------------------------------------------------------------------

describeWithData('the recorded living room', 'sessions/icl-livingroom', (recording) => {
  let output: string;

  beforeAll(async () => {
    output = join(folder, 'icl');
    expect(await convert(recording, output)).toMatchObject({ code: 0 });
  });

  test('stands on its floor, and its walls are upright', async () => {
    const points = worldPoints(await loadSession(output, 6), 8);
    const ys = points.map(({ point }) => point[1]).sort((a, b) => a - b);
    // Nothing but noise and reflections below the floor.
    expect(quantile(ys, 0.005)).toBeGreaterThan(-0.03);
    const floor = points
      .filter(({ point, normal }) => normal[1] > 0.97 && point[1] < 0.12)
      .map(({ point }) => Math.abs(point[1]))
      .sort((a, b) => a - b);
    expect(floor.length).toBeGreaterThan(1000);
    expect(quantile(floor, 0.5)).toBeLessThan(0.012);
    expect(quantile(floor, 0.95)).toBeLessThan(0.03);
    const walls = points.filter(({ normal }) => Math.abs(normal[1]) < 0.25);
    const mean = (axis: (n: Vector) => number): number =>
      toDegrees(
        Math.abs(
          Math.asin(
            dominantLean(
              walls.map(({ normal }) => normal),
              axis,
            ),
          ),
        ),
      );
    expect(mean((n) => n[2])).toBeLessThan(1.5);
  });

  test('agrees with itself from frame to frame', async () => {
    const session = await loadSession(output, 5);
    for (const [a, b] of [
      [0, 1],
      [4, 6],
      [9, 11],
    ] as const) {
      const differences = reproject(session, a, b, 7);
      expect(differences.length).toBeGreaterThan(300);
      expect(quantile(differences, 0.5)).toBeLessThan(0.02);
      expect(quantile(differences, 0.8)).toBeLessThan(0.05);
    }
  });
});

/** Mean of the normals' y in the largest bundle of normals that face along ± the given axis of most of them. */
function dominantLean(normals: readonly Vector[], axis: (n: Vector) => number): number {
  const bundle = normals.filter((n) => axis(n) > 0.9);
  const sum = bundle.reduce<Vector>((s, n) => [s[0] + n[0], s[1] + n[1], s[2] + n[2]], [0, 0, 0]);
  return scale(sum, 1 / Math.sqrt(dot(sum, sum)))[1];
}
