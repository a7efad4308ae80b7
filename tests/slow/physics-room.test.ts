import { execFile } from 'node:child_process';
import { mkdtemp, rm } from 'node:fs/promises';
import { tmpdir } from 'node:os';
import { dirname, join, resolve } from 'node:path';
import process from 'node:process';
import { promisify } from 'node:util';
import { afterAll, beforeAll, describe, expect, test } from '@jest/globals';
import type { Rain, RealRoom } from '../support/physics/real-room.ts';
import { describeWithData } from '../support/shared-data.ts';

const run = promisify(execFile);
const LEAST_EQUAL = 0.99;

async function playIn(folder: string, rains: readonly Rain[]): Promise<RealRoom> {
  const args = ['tools/run.mjs', '../tests/support/physics/real-room.ts', folder, JSON.stringify(rains)];
  return JSON.parse((await run(process.execPath, args)).stdout) as RealRoom;
}

describe('in the studio', () => {
  test('the grid has the occupancy of a ray traversal', async () => {
    const { rays } = await playIn(resolve(import.meta.dirname, '../../examples/sessions/studio'), []);
    expect(rays.count).toBeGreaterThan(1000);
    expect(rays.equal).toBeGreaterThan(LEAST_EQUAL);
  });
});

/**
 * With how many balls of 100 are still where they came to rest after a minute. The noise of the sensor moves the smooth surface below some
 * of those on the rim of a seat, which roll on and rest again.
 */
const RAINS = [
  ['voxels', { isSmooth: false, isNoisy: false, seconds: 60, nearM: 0.06 }, 95],
  ['a smooth surface', { isSmooth: true, isNoisy: false, seconds: 60, nearM: 0.02 }, 95],
  ['voxels of a noisy sensor', { isSmooth: false, isNoisy: true, seconds: 60, nearM: 0.06 }, 95],
  ['a smooth surface of a noisy sensor', { isSmooth: true, isNoisy: true, seconds: 60, nearM: 0.02 }, 94],
] as const;

describeWithData('in a recorded living room', 'sessions/icl-livingroom/session.json', (path) => {
  let folder = '';
  let played: RealRoom;
  beforeAll(async () => {
    folder = await mkdtemp(join(tmpdir(), 'scrim-room-'));
    await run(process.execPath, ['tools/run.mjs', 'sessions/convert-session.ts', dirname(path), folder]);
    played = await playIn(
      folder,
      RAINS.map(([, each]) => each),
    );
  });
  afterAll(() => rm(folder, { recursive: true, force: true }));

  test('the grid has the occupancy of a ray traversal', () => {
    expect(played.rays.count).toBeGreaterThan(2000);
    expect(played.rays.equal).toBeGreaterThan(LEAST_EQUAL);
  });

  test.each(RAINS.map(([name, , least], i) => ({ name, least, i })))(
    'of 100 balls that rain, nearly all rest on $name and none falls through while the last frame is held',
    ({ least, i }) => {
      expect(played.rained[i]?.throughCount).toBe(0);
      expect(played.rained[i]?.restedCount).toBeGreaterThanOrEqual(95);
      expect(played.rained[i]?.keptCount).toBeGreaterThanOrEqual(least);
      // Those that left roll over the border of what was seen.
      expect(played.rained[i]?.lostCount).toBeLessThan(15);
    },
  );
});
