/**
 * Width of a curve or a gradient (`nodes/kit/curve.ts`, `gradient.ts`) as a texture: one row of heights in the red channel, or of
 * premultiplied colors, the first at 0 and the last at 1. It has as many texels as a layer has levels, so that each unblended color has its
 * own height.
 */
export const TABLE_WIDTH_PX = 256;

/** Maximum number of sound samples that are kept, which is also the maximum width of a waveform. A power of two. */
export const SOUND_WINDOW = 4096;

/** Maximum width that a shader can request: a spectrum needs twice as many samples. */
export const MAX_SOUND_COUNT = SOUND_WINDOW / 2;

/** Left and right. */
export const MAX_CHANNELS = 2;
