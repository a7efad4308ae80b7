/** 3 × 3, column-major: an image that is aligned with the view. */
export const IDENTITY: Float32Array = Float32Array.of(1, 0, 0, 0, 1, 0, 0, 0, 1);
