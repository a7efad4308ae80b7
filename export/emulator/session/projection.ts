/** Horizontal shift of a headset's projection, relative to the view's width: each eye sees further to its own side. */
const OUTWARD_SHIFT = 0.06;

/**
 * Perspective projection of an eye.
 *
 * @param aspect Width over height of the eye's viewport.
 * @returns `clipFromView`, column-major 4×4.
 */
export function projectEye(name: 'none' | 'left' | 'right', fovYRad: number, aspect: number, nearM: number, farM: number): Float32Array {
  const halfHeight = Math.tan(fovYRad / 2);
  const halfWidth = halfHeight * aspect;
  const shift = name === 'none' ? 0 : (name === 'left' ? -1 : 1) * OUTWARD_SHIFT * 2 * halfWidth;
  const depth = nearM - farM;
  return new Float32Array([
    1 / halfWidth,
    0,
    0,
    0,
    0,
    1 / halfHeight,
    0,
    0,
    shift / halfWidth,
    0,
    (nearM + farM) / depth,
    -1,
    0,
    0,
    (2 * nearM * farM) / depth,
    0,
  ]);
}
