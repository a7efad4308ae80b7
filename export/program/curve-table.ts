/**
 * Width of a curve (`nodes/kit/curve.ts`) as a texture: one row of heights in the red channel, the first at 0 and the last at 1. It has as
 * many texels as a layer has levels, so that each unblended color has its own height.
 */
export const CURVE_WIDTH_PX = 256;
