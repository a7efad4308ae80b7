import { join } from 'node:path';
import { expect, test } from '@jest/globals';
import { srgbFromLinear } from '../../nodes/kit/color-math.ts';
import { gainOfContrast, primaryContrast } from '../../nodes/kit/panorama/clipped-light.ts';
import type { FoundLamp, FoundLamps } from '../../nodes/kit/panorama/found-lamps.ts';
import { mergeExposures } from '../../nodes/kit/panorama/merge-exposures.ts';
import { createRowReader, type PanoramaPixels, runWhole } from '../../nodes/kit/panorama/pixels.ts';
import { findBySolidAngle } from '../../nodes/kit/panorama/solid-angle-method.ts';
import { luminanceOf, sphereGridOf } from '../../nodes/kit/panorama/sphere-grid.ts';
import type { LightEstimate } from '../../nodes/kit/session.ts';
import { decodePanorama } from '../support/decode-panorama.ts';
import { describeWithData } from '../support/shared-data.ts';

/** Default of “Share of white”. */
const SHARE = 0.5;
const LAMPS = { lamps: 3, clippedShare: SHARE };

/** The light of all lamps: luminance of irradiance. */
function lightOf(lamps: readonly Pick<FoundLamp, 'irradiance'>[]): number {
  return lamps.reduce((sum, { irradiance }) => sum + luminanceOf(...irradiance), 0);
}

/** What a device that looks at the same place reports: the strongest lamp, and everything else as harmonics. */
function estimateOf(panorama: PanoramaPixels): LightEstimate {
  const grid = runWhole(sphereGridOf(panorama));
  const [strongest] = runWhole(findBySolidAngle(panorama, { lamps: 1, clippedShare: 0 })).lamps;
  if (!strongest) throw new Error('The panorama has a lamp.');
  const sphericalHarmonics = new Float32Array(27);
  for (let i = 0; i < grid.luminance.length; i++) {
    for (let c = 0; c < 3; c++) {
      const flux = (grid.radiance[i * 3 + c] ?? 0) * (grid.pixelSr[Math.floor(i / grid.widthPx)] ?? 0);
      sphericalHarmonics[c] = (sphericalHarmonics[c] ?? 0) + flux * 0.282095;
    }
  }
  for (let c = 0; c < 3; c++) sphericalHarmonics[c] = (sphericalHarmonics[c] ?? 0) - (strongest.irradiance[c] ?? 0) * 0.282095;
  return {
    sphericalHarmonics,
    primaryDirectionWorld: Float32Array.from(strongest.towards),
    primaryIntensity: Float32Array.from(strongest.irradiance),
  };
}

/** The lamps of a clipped panorama, brightened as far as an estimate says. */
function estimated({ lamps, clipped }: FoundLamps, estimate: LightEstimate): FoundLamp[] {
  const contrast = primaryContrast(estimate);
  const [strongest] = lamps;
  if (!clipped || !strongest || contrast === null) throw new Error('White is clipped, and the estimate has light.');
  const white = luminanceOf(...(strongest.clippedIrradiance ?? [0, 0, 0]));
  const gain = gainOfContrast(clipped, { clipped: white, other: luminanceOf(...strongest.irradiance) - clipped.gain * white }, contrast);
  const more = gain - clipped.gain;
  return lamps.map((lamp) => {
    const [red, green, blue] = lamp.irradiance;
    const [r = 0, g = 0, b = 0] = lamp.clippedIrradiance ?? [];
    return { ...lamp, irradiance: [red + more * r, green + more * g, blue + more * b] };
  });
}

/** A photo of the same place, a number of stops darker than the JPEG file, with 8 bits. */
function darkerShot(whole: PanoramaPixels, exposure: number, stops: number): PanoramaPixels {
  const { widthPx, heightPx } = whole;
  const rows = createRowReader(whole);
  const row = new Float32Array(widthPx * 3);
  const data = new Uint8Array(widthPx * heightPx * 3);
  for (let y = 0; y < heightPx; y++) {
    rows.read(y, row);
    for (let i = 0; i < row.length; i++) {
      data[y * row.length + i] = Math.round(255 * srgbFromLinear(Math.min(1, (row[i] ?? 0) * exposure * 2 ** -stops)));
    }
  }
  return { widthPx, heightPx, channels: 3, data };
}

describeWithData('lamps that are white in the file', 'panoramas', (folder) => {
  test.each([
    ['royal_esplanade_1k.hdr', 'royal_esplanade_ldr.jpg'],
    ['blender_interior.exr', 'interior_ldr.jpg'],
  ])('%s: the lamps of %s have its light within a factor of 2', async (radiance, display) => {
    const [whole, clipped] = await Promise.all([radiance, display].map((file) => decodePanorama(join(folder, file))));
    if (!whole || !clipped) throw new Error('Both were read.');
    const [wholeGrid, clippedGrid] = [runWhole(sphereGridOf(whole)), runWhole(sphereGridOf(clipped))];
    // The exposure of the JPEG file, from what is neither dark nor clipped.
    const ratios = [...clippedGrid.luminance].flatMap((l, i) => (l > 0.05 && l < 0.5 ? [l / (wholeGrid.luminance[i] ?? 0)] : []));
    const exposure = ratios.sort((a, b) => a - b)[ratios.length >> 1] ?? 0;
    const truth = exposure * lightOf(runWhole(findBySolidAngle(whole, LAMPS)).lamps);
    const found = runWhole(findBySolidAngle(clipped, LAMPS));
    const shots = [clipped, ...[5.5, 11].map((stops) => darkerShot(whole, exposure, stops))];
    const merged = runWhole(mergeExposures(shots, 0));
    const light = {
      asItLooks: lightOf(runWhole(findBySolidAngle(clipped, { ...LAMPS, clippedShare: 0 })).lamps) / truth,
      exposures: lightOf(runWhole(findBySolidAngle(merged, LAMPS)).lamps) / truth,
      estimate: lightOf(estimated(found, estimateOf(whole))) / truth,
      share: lightOf(found.lamps) / truth,
    };
    console.info(
      [display, ...Object.values(light).map((ratio) => ratio.toFixed(2)), merged.stops.map((one) => one.toFixed(2))].join(' | '),
    );
    for (const ratio of [light.estimate, light.share]) expect([ratio, ratio > 0.5 && ratio < 2]).toEqual([ratio, true]);
    // Shots of the lamps themselves leave nothing to guess.
    expect(light.exposures).toBeGreaterThan(0.85);
    expect(light.exposures).toBeLessThan(1.15);
    // The file alone is what all this is for.
    expect(light.asItLooks).toBeLessThan(0.5);
  });
});
