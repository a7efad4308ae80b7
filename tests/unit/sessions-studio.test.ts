import { readdir, readFile, stat } from 'node:fs/promises';
import { join } from 'node:path';
import { beforeAll, describe, expect, test } from '@jest/globals';
import { readSessionFile } from '../../export/runtime/sessions/recorded/read-session-file.ts';
import { type LoadedSession, loadSession, quantile, reproject, toDegrees, worldPoints } from './sessions-kit.ts';

const FOLDER = 'examples/sessions/studio';

describe('the example session', () => {
  let session: LoadedSession;

  beforeAll(async () => {
    session = await loadSession(FOLDER, 4);
  });

  test('is one that Scrim reads, and small', async () => {
    const json: unknown = JSON.parse(await readFile(join(FOLDER, 'session.json'), 'utf8'));
    expect(readSessionFile(json).diagnostics).toEqual([]);
    const files = (await readdir(FOLDER, { recursive: true, withFileTypes: true })).filter((entry) => entry.isFile());
    const sizes = await Promise.all(files.map(async (file) => (await stat(join(file.parentPath, file.name))).size));
    expect(sizes.reduce((a, b) => a + b, 0)).toBeLessThan(3e6);
  });

  test('has every picture it names, in the sizes that it says', async () => {
    const { file } = await loadSession(FOLDER);
    expect(file.frames.length).toBeGreaterThanOrEqual(24);
    for (const { color, depth } of file.frames) {
      expect(jpegSize(await readFile(join(FOLDER, color)))).toEqual([file.color.widthPx, file.color.heightPx]);
      const png = await readFile(join(FOLDER, depth ?? ''));
      expect([png.readUInt32BE(16), png.readUInt32BE(20), png[24], png[25]]).toEqual([file.depth?.widthPx, file.depth?.heightPx, 16, 0]);
    }
  });

  test('moves smoothly, and ends where it began', async () => {
    const { file } = await loadSession(FOLDER);
    const eyes = file.frames.map(({ worldFromCamera }) => worldFromCamera.slice(12, 15));
    const steps = eyes.map((eye, i) => distance(eye, eyes[(i + 1) % eyes.length] ?? []));
    expect(Math.max(...steps)).toBeLessThan(0.07);
    expect(Math.max(...steps) / Math.min(...steps)).toBeLessThan(5);
  });

  test('stands on its floor, in front of an upright wall', () => {
    const points = worldPoints(session, 4);
    const floor = points.filter(({ point, normal }) => normal[1] > 0.98 && point[1] < 0.05).map(({ point }) => Math.abs(point[1]));
    expect(floor.length).toBeGreaterThan(500);
    expect(
      quantile(
        floor.sort((a, b) => a - b),
        0.98,
      ),
    ).toBeLessThan(0.016);
    const back = points.filter(({ point, normal }) => normal[2] > 0.9 && Math.abs(point[2] + 2.3) < 0.02);
    expect(back.length).toBeGreaterThan(500);
    const lean = back.map(({ normal }) => toDegrees(Math.abs(Math.asin(normal[1])))).sort((a, b) => a - b);
    expect(quantile(lean, 0.5)).toBeLessThan(1);
  });

  test('agrees with itself from frame to frame', () => {
    for (const [a, b] of [
      [0, 1],
      [0, 4],
      [3, 7],
    ] as const) {
      const differences = reproject(session, a, b, 5);
      expect(differences.length).toBeGreaterThan(1000);
      expect(quantile(differences, 0.5)).toBeLessThan(0.008);
      expect(quantile(differences, 0.85)).toBeLessThan(0.05);
    }
  });

  test('knows its light and surfaces', () => {
    const { light, surfaces = [] } = session.file;
    expect(light?.sphericalHarmonics.slice(0, 3).every((c) => c > 0.2)).toBe(true);
    const [x = 0, y = 0, z = 0] = light?.primaryDirectionWorld ?? [];
    expect(Math.hypot(x, y, z)).toBeCloseTo(1, 5);
    // The window is on the left, and the sun is up.
    expect(x).toBeLessThan(-0.5);
    expect(y).toBeGreaterThan(0.3);
    expect(surfaces.map(({ label }) => label)).toEqual(expect.arrayContaining(['floor', 'wall', 'table']));
    expect(surfaces.find(({ label }) => label === 'floor')?.worldFromPlane[13]).toBe(0);
  });
});

function distance(a: readonly number[], b: readonly number[]): number {
  return Math.hypot(...a.map((value, i) => value - (b[i] ?? 0)));
}

/** From the start-of-frame segment. */
function jpegSize(jpeg: Buffer): readonly [number, number] {
  for (let at = 2; at < jpeg.length; at += 2 + jpeg.readUInt16BE(at + 2)) {
    const marker = jpeg[at + 1] ?? 0;
    if (marker >= 0xc0 && marker <= 0xc3) return [jpeg.readUInt16BE(at + 7), jpeg.readUInt16BE(at + 5)];
  }
  throw new Error('This is no JPEG.');
}
