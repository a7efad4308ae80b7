import type { Pinhole } from '../../../nodes/kit/capture.ts';
import { type DepthMap, isKnown } from './depth-map.ts';
import { panoramaRays, pinholeRays } from './depth-rays.ts';

/** A point seen from above, meters: to the right of the camera, and ahead of it. */
export type DepthPoint = readonly [rightM: number, aheadM: number];

/** The camera of a depth map; `isAround`: of a 360° photograph. */
export type PlanCamera = Omit<Pinhole, 'projection'> & { readonly isAround: boolean };

/** The rows around the middle that a plan shows, as a share of all: walls are lines then. */
const ROWS = 0.2;

/**
 * What the middle rows of a depth map show, from above. With the wrong kind of depth, walls are bent.
 *
 * @param map Depths along the axis of the camera, or of 360° photographs along the ray.
 * @param scale Meters per unit of the map.
 */
export function depthPoints2d(map: DepthMap, { isAround, ...camera }: PlanCamera, scale: number): readonly DepthPoint[] {
  const { widthPx, heightPx } = map;
  const rays = isAround ? panoramaRays(widthPx, heightPx) : pinholeRays(camera);
  const points: DepthPoint[] = [];
  const first = Math.floor((heightPx * (1 - ROWS)) / 2);
  for (let row = first; row < heightPx - first; row++) {
    for (let column = 0; column < widthPx; column++) {
      const depth = map.values[row * widthPx + column] ?? 0;
      if (!isKnown(depth)) continue;
      const level = (rays.level[row] ?? 0) * depth * scale;
      points.push([(rays.across[column] ?? 0) * level, (rays.ahead[column] ?? 0) * level]);
    }
  }
  return points;
}
