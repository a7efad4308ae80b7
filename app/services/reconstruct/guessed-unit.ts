import type { SourceView } from '../../../export/captures/source-view.ts';

/** What a room or an object is mostly away from who photographs it. */
export const USUAL_DISTANCE_M = 2;

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
