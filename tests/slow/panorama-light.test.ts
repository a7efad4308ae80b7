import { readdirSync } from 'node:fs';
import { join } from 'node:path';
import { expect, test } from '@jest/globals';
import { fillLamps } from '../../nodes/kit/panorama/fill-lamps.ts';
import type { FoundLamps } from '../../nodes/kit/panorama/found-lamps.ts';
import { findByPaper } from '../../nodes/kit/panorama/paper-method.ts';
import { type PanoramaPixels, runWhole } from '../../nodes/kit/panorama/pixels.ts';
import { findBySolidAngle } from '../../nodes/kit/panorama/solid-angle-method.ts';
import { luminanceOf, type SphereGrid, sphereGridOf } from '../../nodes/kit/panorama/sphere-grid.ts';
import { decodePanorama } from '../support/decode-panorama.ts';
import { type LightError, measureOf } from '../support/panorama-measure.ts';
import { describeWithData } from '../support/shared-data.ts';

/** The grid on which light is integrated; the lamps are found at full size. */
const MEASURED_WIDTH_PX = 128;

describeWithData('lamps and rest of a panorama', 'panoramas', (folder) => {
  const files = readdirSync(folder).filter((name) => /\.(hdr|exr|jpg|png)$/.test(name));

  test.each(files)('%s: light as the whole panorama gives it, better than spherical harmonics and the brightest areas', async (file) => {
    const pixels = await decodePanorama(join(folder, file));
    const grid = runWhole(sphereGridOf(pixels));
    const averaged: PanoramaPixels = { widthPx: grid.widthPx, heightPx: grid.heightPx, channels: 3, data: grid.radiance };
    const measure = measureOf(reduced(grid, grid.luminance));
    const harmonics = measure.harmonicsError();
    const paper = runWhole(findByPaper(pixels, { lamps: 3, iterations: 2, intensities: 'ranks' }));
    // Its lamps are given the energy that is missing, because their intensities are relative.
    const byPaper = paper.lamps.length > 0 ? measure.errorOf(paper, reduced(grid, restOf(grid, paper)).luminance, null) : null;
    const errors = [1, 2, 3].map((lamps) => {
      const found = runWhole(findBySolidAngle(averaged, { lamps, clippedShare: 0 }));
      expect(found.lamps.length).toBeGreaterThan(0);
      return measure.errorOf(found, reduced(grid, restOf(grid, found)).luminance);
    });
    console.info([file, ...errors.map(percent), byPaper ? percent(byPaper) : '–', percent(harmonics)].join(' | '));
    for (const { normals, shadow } of errors) {
      expect([normals < 0.03 && normals < harmonics.normals, shadow < 0.06 && shadow < harmonics.shadow]).toEqual([true, true]);
    }
    // The default with as many lamps. Shadows tell less: what is not found stays in the rest, which is exact here.
    if (byPaper) expect(errors[2]?.normals).toBeLessThan(byPaper.normals + 0.005);
  });
});

function percent({ normals, shadow }: LightError): string {
  return `${(100 * normals).toFixed(1)} / ${(100 * shadow).toFixed(1)}`;
}

/** Luminance of the panorama with its lamps filled. */
function restOf(grid: SphereGrid, found: FoundLamps): Float32Array {
  const { widthPx, heightPx } = grid;
  // The paper's method looks at all pixels of a panorama that is larger than the grid.
  const runs = reducedRuns(found, found.widthPx / widthPx);
  const radiance = grid.radiance.slice();
  const indexOf = (x: number, y: number, channel: number): number => (y * widthPx + x) * 3 + channel;
  const set = (x: number, y: number, channel: number, value: number): void => {
    radiance[indexOf(x, y, channel)] = value;
  };
  fillLamps({ widthPx, heightPx, get: (x, y, channel) => radiance[indexOf(x, y, channel)] ?? 0, set }, runs, grid);
  return grid.luminance.map((_, i) => luminanceOf(radiance[i * 3] ?? 0, radiance[i * 3 + 1] ?? 0, radiance[i * 3 + 2] ?? 0));
}

function reducedRuns({ runs }: FoundLamps, step: number): readonly number[] {
  if (step === 1) return runs;
  return runs.map((value, i) => (i % 3 === 2 ? Math.ceil(value / step) : Math.floor(value / step)));
}

/** A grid of fewer pixels with the same energy. */
function reduced(grid: SphereGrid, luminance: Float32Array): SphereGrid {
  const step = Math.max(1, grid.widthPx / MEASURED_WIDTH_PX);
  const [widthPx, heightPx] = [grid.widthPx / step, grid.heightPx / step];
  const pixelSr = new Float64Array(heightPx);
  for (let y = 0; y < grid.heightPx; y++) {
    const row = Math.floor(y / step);
    pixelSr[row] = (pixelSr[row] ?? 0) + (grid.pixelSr[y] ?? 0) * step;
  }
  const sums = new Float32Array(widthPx * heightPx);
  for (let i = 0; i < luminance.length; i++) {
    const [x, y] = [i % grid.widthPx, Math.floor(i / grid.widthPx)];
    const to = Math.floor(y / step) * widthPx + Math.floor(x / step);
    sums[to] = (sums[to] ?? 0) + ((luminance[i] ?? 0) * (grid.pixelSr[y] ?? 0)) / (pixelSr[Math.floor(y / step)] ?? 1);
  }
  return { ...grid, widthPx, heightPx, pixelSr, luminance: sums };
}
