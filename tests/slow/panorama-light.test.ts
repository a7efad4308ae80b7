import { readdirSync } from 'node:fs';
import { join } from 'node:path';
import { expect, test } from '@jest/globals';
import { fillLamps } from '../../nodes/kit/panorama/fill-lamps.ts';
import type { FoundLamps } from '../../nodes/kit/panorama/found-lamps.ts';
import { findBySolidAngle } from '../../nodes/kit/panorama/solid-angle-method.ts';
import { luminanceOf, type SphereGrid, sphereGridOf } from '../../nodes/kit/panorama/sphere-grid.ts';
import { decodePanorama, runWhole } from '../support/decode-panorama.ts';
import { harmonicsError, lightError } from '../support/panorama-measure.ts';
import { describeWithData } from '../support/shared-data.ts';

/** The grid on which light is integrated; the lamps are found at full size. */
const MEASURED_WIDTH_PX = 128;

describeWithData('lamps and rest of a panorama', 'panoramas', (folder) => {
  const files = readdirSync(folder).filter((name) => /\.(hdr|exr|jpg|png)$/.test(name));

  test.each(files)('%s: light as the whole panorama gives it, better than spherical harmonics', async (file) => {
    const pixels = await decodePanorama(join(folder, file));
    const grid = runWhole(sphereGridOf(pixels));
    const small = reduced(grid, grid.luminance);
    const harmonics = harmonicsError(small);
    for (const lamps of [1, 2, 3]) {
      const found = runWhole(findBySolidAngle(pixels, { lamps, clippedShare: 0 }));
      expect(found.lamps.length).toBeGreaterThan(0);
      const { normals, shadow } = lightError(small, found, reduced(grid, restOf(grid, found)).luminance);
      expect([file, lamps, normals < 0.03 && normals < harmonics.normals, shadow < 0.06 && shadow < harmonics.shadow]).toEqual([
        file,
        lamps,
        true,
        true,
      ]);
    }
  });

  test.each([
    ['royal_esplanade_1k.hdr', 'royal_esplanade_ldr.jpg'],
    ['blender_interior.exr', 'interior_ldr.jpg'],
  ])('%s: the clipped lamps of %s have its light within a factor of 2', async (radiance, display) => {
    const [whole, clipped] = await Promise.all([radiance, display].map((file) => decodePanorama(join(folder, file))));
    if (!whole || !clipped) throw new Error('Both were read.');
    const [wholeGrid, clippedGrid] = [runWhole(sphereGridOf(whole)), runWhole(sphereGridOf(clipped))];
    // The exposure of the JPEG file, from what is neither dark nor clipped.
    const ratios = [...clippedGrid.luminance].flatMap((l, i) => (l > 0.05 && l < 0.5 ? [l / (wholeGrid.luminance[i] ?? 0)] : []));
    const exposure = ratios.sort((a, b) => a - b)[ratios.length >> 1] ?? 0;
    const light = (found: FoundLamps): number => found.lamps.reduce((sum, { irradiance }) => sum + luminanceOf(...irradiance), 0);
    const ratio =
      light(runWhole(findBySolidAngle(clipped, { lamps: 3, clippedShare: 0.5 }))) /
      (exposure * light(runWhole(findBySolidAngle(whole, { lamps: 3, clippedShare: 0.5 }))));
    expect(ratio).toBeGreaterThan(0.5);
    expect(ratio).toBeLessThan(2);
  });
});

/** Luminance of the panorama with its lamps filled. */
function restOf(grid: SphereGrid, { runs }: FoundLamps): Float32Array {
  const { widthPx, heightPx } = grid;
  const radiance = grid.radiance.slice();
  const indexOf = (x: number, y: number, channel: number): number => (y * widthPx + x) * 3 + channel;
  const set = (x: number, y: number, channel: number, value: number): void => {
    radiance[indexOf(x, y, channel)] = value;
  };
  fillLamps({ widthPx, heightPx, get: (x, y, channel) => radiance[indexOf(x, y, channel)] ?? 0, set }, runs, grid);
  return grid.luminance.map((_, i) => luminanceOf(radiance[i * 3] ?? 0, radiance[i * 3 + 1] ?? 0, radiance[i * 3 + 2] ?? 0));
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
