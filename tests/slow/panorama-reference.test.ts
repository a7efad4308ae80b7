import { existsSync, readFileSync } from 'node:fs';
import { join } from 'node:path';
import { expect, test } from '@jest/globals';
import { momentsOf } from '../../nodes/kit/panorama/outer-contours.ts';
import { findByPaper } from '../../nodes/kit/panorama/paper-method.ts';
import { runWhole } from '../../nodes/kit/panorama/pixels.ts';
import { decodePanorama } from '../support/decode-panorama.ts';
import { describeWithData } from '../support/shared-data.ts';

interface Reference {
  readonly file: string;
  readonly max: number;
  readonly mean: number;
  readonly thresholdPixels: number;
  readonly afterMedianPixels: number;
  readonly contours: number;
  readonly contoursWithArea: number;
  readonly lights: readonly { area: number; cx: number; cy: number; theta: number; phi: number; points: number }[];
}

const TO_DEG = 180 / Math.PI;

/** What OpenCV 5.0.0 gives for the same steps. */
describeWithData('the lamps of the paper’s method', 'panoramas', (folder) => {
  const { results } = JSON.parse(readFileSync(join(folder, 'arpas_reference.json'), 'utf8')) as { results: readonly Reference[] };

  test.each(results.map((reference) => [reference.file, reference] as const))('%s: as OpenCV has them', async (file, reference) => {
    const path = [join(folder, file), join(folder, 'rgbd360', file)].find(existsSync) ?? file;
    const { steps, lamps } = runWhole(findByPaper(await decodePanorama(path), { lamps: 3, iterations: 1, intensities: 'ranks' }));
    const [step] = steps;
    if (!step) throw new Error('There is no step.');
    // Decoders of JPEG differ by a level here and there.
    const isExact = !file.endsWith('.jpg');
    const isNear = (value: number, expected: number): boolean => Math.abs(value - expected) <= (isExact ? 0 : 0.02 * expected);
    expect([step.max, step.mean]).toEqual([reference.max, expect.closeTo(reference.mean, isExact ? 3 : 1)]);
    const ones = (image: Uint8Array): number => image.reduce((sum, one) => sum + one, 0);
    expect(isNear(ones(step.bright), reference.thresholdPixels)).toBe(true);
    expect(isNear(ones(step.smooth), reference.afterMedianPixels)).toBe(true);
    expect(step.contours.length).toBe(reference.contours);
    expect(step.contours.filter((contour) => momentsOf(contour) !== null)).toHaveLength(reference.contoursWithArea);
    // A refused panorama has no lamps, but the reference lists what the contours would give.
    for (const [i, lamp] of lamps.entries()) {
      const light = reference.lights[i];
      if (!light) throw new Error('OpenCV has fewer.');
      expect([lamp.areaPx, isNear(lamp.areaPx, light.area)]).toEqual([expect.any(Number), true]);
      const within = isExact ? 0.05 : 0.5;
      expect(Math.hypot(lamp.centerPx[0] - light.cx, lamp.centerPx[1] - light.cy)).toBeLessThanOrEqual(within);
      expect(Math.asin(lamp.towards[1]) * TO_DEG).toBeCloseTo(light.phi, isExact ? 1 : 0);
      expect(Math.atan2(lamp.towards[0], -lamp.towards[2]) * TO_DEG).toBeCloseTo(light.theta, isExact ? 1 : 0);
    }
  });

  test('the two conditions refuse what they should, each with its reason', async () => {
    const refused = async (path: string) =>
      runWhole(findByPaper(await decodePanorama(join(folder, path)), { lamps: 3, iterations: 2, intensities: 'ranks' })).none;
    expect(await refused('rgbd360/vr-gallery_color.jpg')).toBe('too-much-above');
    expect(await refused('pmndrs_warehouse.exr')).toBe('lost-in-median');
  });
});
