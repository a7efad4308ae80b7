/** 3 × 3, column by column: a picture that lies on the view as it is. */
export const IDENTITY: Float32Array = Float32Array.of(1, 0, 0, 0, 1, 0, 0, 0, 1);
