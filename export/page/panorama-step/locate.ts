import { brightRegionsOf } from '../../../nodes/kit/panorama/bright-regions.ts';
import { createHeadingSearch, isCertain } from '../../../nodes/kit/panorama/match-heading.ts';
import { type PanoramaPixels, runWhole } from '../../../nodes/kit/panorama/pixels.ts';
import { type PanoramaShot, setPanoramaPose } from '../../../nodes/kit/panorama/shot.ts';
import { sphereGridOf } from '../../../nodes/kit/panorama/sphere-grid.ts';
import type { ViewFrame } from '../../../nodes/kit/session.ts';

/** Finds the heading of a panorama: by which angle a panorama of an earlier visit is rotated in the world space of this one. */
export interface Locator {
  /**
   * Compares a camera image with the panorama.
   *
   * @returns The heading of the panorama if it is certain, else null.
   */
  look(shot: PanoramaShot): number | null;
  /** Returns the heading of the panorama, provided that the camera points at its brightest lamp; null if the panorama has no lamp. */
  pointedAtLamp(view: ViewFrame): number | null;
}

/** Number of consecutive images that must give the same heading. */
const AGREEING = 2;
const AGREE_RAD = 0.05;

export function createLocator(panorama: PanoramaPixels): Locator {
  const search = createHeadingSearch(panorama);
  let before: number | null = null;
  let agreeing = 0;
  return {
    look: (shot) => {
      const match = search.add(shot);
      if (!isCertain(match)) {
        before = null;
        agreeing = 0;
        return null;
      }
      const agrees = before !== null && Math.abs(Math.sin((match.headingRad - before) / 2)) < AGREE_RAD / 2;
      agreeing = agrees ? agreeing + 1 : 1;
      before = match.headingRad;
      return agreeing >= AGREEING ? match.headingRad : null;
    },
    pointedAtLamp: ({ worldFromView: m }) => {
      const lamp = brightestLongitude(panorama);
      return lamp === null ? null : lamp - Math.atan2(-(m[8] ?? 0), m[10] ?? 0);
    },
  };
}

/** Longitude of the brightest lamp, radians to the right of the panorama's center; null if there is none. */
function brightestLongitude(panorama: PanoramaPixels): number | null {
  const [brightest] = runWhole(brightRegionsOf(runWhole(sphereGridOf(panorama))));
  if (!brightest) return null;
  const [x, , z] = brightest.vector;
  return Math.atan2(x, -z);
}

/** Returns photos of an earlier session in the world space of this one. */
export function turnShots(shots: readonly PanoramaShot[], headingRad: number): PanoramaShot[] {
  const turn = new Float32Array(16);
  setPanoramaPose(turn, headingRad, [0, 0, 0]);
  return shots.map((shot) => {
    const worldFromView = shot.worldFromView.slice();
    for (let column = 0; column < 3; column++) {
      for (let row = 0; row < 3; row++) {
        let sum = 0;
        for (let k = 0; k < 3; k++) sum += (turn[4 * k + row] ?? 0) * (shot.worldFromView[4 * column + k] ?? 0);
        worldFromView[4 * column + row] = sum;
      }
    }
    return { ...shot, worldFromView };
  });
}
