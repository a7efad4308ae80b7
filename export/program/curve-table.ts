/**
 * A curve (`nodes/kit/curve.ts`) as shaders read it: a row of heights, the first at 0 and the last at 1, in the red channel. As many as
 * a layer has levels, so that of colors that nobody has blended each finds its own height.
 */
export const CURVE_WIDTH_PX = 256;
