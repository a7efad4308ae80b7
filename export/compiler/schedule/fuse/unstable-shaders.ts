/**
 * Shaders of the library that turn noise of half a step of 8 bits in what they read into more than 16 steps. `tests/slow/fusion-pairs.test.ts`
 * finds them; `UPDATE_GOLDENS=1 npm run test:one slow slow/fusion-pairs` writes the list.
 */
export const UNSTABLE_SHADERS: readonly string[] = [
  'filters/posterize.fs',
  'filters/skin-mask.fs',
  'filters/threshold.fs',
  'operators/color-lut.fs',
];
