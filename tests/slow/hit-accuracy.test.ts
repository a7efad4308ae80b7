import { execFile } from 'node:child_process';
import process from 'node:process';
import { promisify } from 'node:util';
import { describe, expect, test } from '@jest/globals';
import type { HitScores, Score } from '../support/hit-scores.ts';
import { describeWithData } from '../support/shared-data.ts';

const run = promisify(execFile);

async function scoresOf(place: string): Promise<HitScores> {
  return JSON.parse((await run(process.execPath, ['tools/run.mjs', '../tests/support/hit-scores.ts', place])).stdout) as HitScores;
}

/** What the issue of hit tests asks for. */
function expectAccuracy(score: Score): void {
  expect(score.medianCm).toBeLessThanOrEqual(1);
  expect(score.p95Cm).toBeLessThanOrEqual(4);
  expect(score.normalMedianDeg).toBeLessThanOrEqual(5);
  expect(score.normalP95Deg).toBeLessThanOrEqual(15);
  expect(score.missed).toBeLessThanOrEqual(0.02);
  expect(score.wrong).toBeLessThanOrEqual(0.02);
}

/** Voxels of 5 cm tell a surface to half a voxel, and the mean points in them much better. */
function expectVoxelAccuracy({ voxels, smooth }: HitScores): void {
  expect(voxels.medianCm).toBeLessThanOrEqual(2);
  expect(voxels.flatP95Cm).toBeLessThanOrEqual(6);
  expect(smooth.medianCm).toBeLessThanOrEqual(1);
  expect(smooth.flatP95Cm).toBeLessThanOrEqual(4);
  expect([voxels.normalMedianDeg, smooth.normalMedianDeg].every((deg) => deg <= 5)).toBe(true);
  expect(smooth.normalP95Deg).toBeLessThanOrEqual(15);
  for (const { missed } of [voxels, smooth]) expect(missed).toBeLessThanOrEqual(0.03);
  // Along the borders of things, which are up to half a voxel wider than the things themselves.
  for (const { wrong } of [voxels, smooth]) expect(wrong).toBeLessThanOrEqual(0.1);
}

describe('hit tests on room depth of 160 × 120 samples', () => {
  test.each(['living_room', 'office_small'])('with the noise of a sensor, and on the voxels that it fills, in %s', async (name) => {
    const scores = await scoresOf(name);
    expectAccuracy(scores.depth);
    expectVoxelAccuracy(scores);
  });
});

describeWithData('hit tests on a recorded room', 'sessions/icl-livingroom', (folder) => {
  test('answer by every second frame what the frame after it shows, also by the voxels of a physics room', async () => {
    const scores = await scoresOf(folder);
    expectAccuracy(scores.depth);
    expectVoxelAccuracy(scores);
  });
});
