import { CAPTURE_LIMITS } from '../../nodes/kit/capture.ts';

/** A 360° photograph may be larger by this factor, because it shows more. */
const AROUND = 2.5;

/** The longest side of a packed photograph in pixels, if that of photographs with a perspective is `maxSidePx`. */
export function packedSidePx(maxSidePx: number, isAround: boolean): number {
  return isAround ? Math.min(AROUND * maxSidePx, CAPTURE_LIMITS.sidePx) : maxSidePx;
}
