import type { SessionFrame } from './session.ts';

/**
 * Writes the position of the viewer: that of the screen's camera, or the midpoint between the two eyes.
 *
 * @param out Receives three numbers, world space, meters.
 * @returns False without a view; `out` then keeps what it held.
 *
 * @example
 * if (writeViewerPosition(eyeM, frame)) setNoise(point, eyeM, noise);
 */
export function writeViewerPosition(out: Float64Array, { views, viewCount }: SessionFrame): boolean {
  if (viewCount === 0) return false;
  out.fill(0);
  for (let v = 0; v < viewCount; v++) {
    const matrix = views[v]?.worldFromView;
    for (let i = 0; i < 3; i++) out[i] = (out[i] ?? 0) + (matrix?.[12 + i] ?? 0) / viewCount;
  }
  return true;
}
