import type { PassSampler } from '../../program/program.ts';

/** The result of `fitted`, valid until its next call; uniforms are copied when they are set. */
const scratchUv = new Float32Array(9);

/**
 * Returns the matrix from view UV to texture UV for an image that is fitted to a view, column-major 3×3. `uv` is the matrix from image UV
 * to texture UV. With `contain`, points of the view beside the image are mapped outside of [0, 1].
 */
export function fitted(
  uv: Float32Array,
  fit: PassSampler['fit'],
  widthPx: number,
  heightPx: number,
  viewWidthPx: number,
  viewHeightPx: number,
): Float32Array {
  if (fit === 'none' || fit === 'stretch') return uv;
  const image = widthPx / heightPx;
  const view = viewWidthPx / viewHeightPx;
  if (!(image > 0) || !(view > 0) || !Number.isFinite(image / view)) return uv;
  // `cover` crops the longer side of the image, `contain` extends the shorter one: image UV = 0.5 + scale * (view UV − 0.5).
  const alongX = image > view === (fit === 'cover');
  const scaleX = alongX ? view / image : 1;
  const scaleY = alongX ? 1 : image / view;
  for (let row = 0; row < 3; row++) {
    const a = uv[row] ?? 0;
    const b = uv[row + 3] ?? 0;
    const c = uv[row + 6] ?? 0;
    scratchUv[row] = a * scaleX;
    scratchUv[row + 3] = b * scaleY;
    scratchUv[row + 6] = a * (0.5 - 0.5 * scaleX) + b * (0.5 - 0.5 * scaleY) + c;
  }
  return scratchUv;
}
