import type { SourceView } from '../../../export/captures/source-view.ts';
import type { CaptureView } from '../../../nodes/kit/capture.ts';

/** What a room or an object is mostly away from who photographs it. */
const USUAL_DISTANCE_M = 2;

/** Meters per unit of a reconstruction without scale, so that the points that a photograph shows are 2 m away in the median. 1 without points. */
export function guessedUnit(views: readonly SourceView[]): number {
  const distances = views.flatMap(({ observations, worldFromCamera }) => {
    const found: number[] = [];
    for (let i = 0; i + 4 < observations.length; i += 5) {
      found.push(Math.hypot(...[0, 1, 2].map((axis) => (observations[i + 2 + axis] ?? 0) - (worldFromCamera[12 + axis] ?? 0))));
    }
    return found;
  });
  const median = distances.sort((a, b) => a - b)[distances.length >> 1] ?? 0;
  return median > 0 ? Number((USUAL_DISTANCE_M / median).toPrecision(4)) : 1;
}

/** The camera in the middle of all: from there, a visitor sees what a photograph shows. Position in meters; the angle about y of where it looks. */
export function firstEye(views: readonly CaptureView[]): { readonly positionM: number[]; readonly yawRad: number } | null {
  const centers = views.map(({ worldFromCamera }) => worldFromCamera.slice(12, 15));
  const mean = [0, 1, 2].map((axis) => centers.reduce((sum, center) => sum + (center[axis] ?? 0), 0) / centers.length);
  const away = (center: readonly number[]): number => Math.hypot(...center.map((value, axis) => value - (mean[axis] ?? 0)));
  let best: CaptureView | null = null;
  for (const view of views) {
    if (best === null || away(view.worldFromCamera.slice(12, 15)) < away(best.worldFromCamera.slice(12, 15))) best = view;
  }
  if (best === null) return null;
  const m = best.worldFromCamera;
  // The camera looks along −z: its third column points backwards.
  return { positionM: m.slice(12, 15), yawRad: Math.atan2(m[8] ?? 0, m[10] ?? 1) };
}
