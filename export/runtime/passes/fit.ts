import type { PassSampler } from '../../program/program.ts';

/** Valid until the next call; uniforms are copied when they are set. */
const scratchUv = new Float32Array(9);

/**
 * Column-major 3×3: texture UV from view UV of a picture laid onto a view. `uv` is the picture's own, texture UV from picture
 * UV. `contain` leaves [0, 1] beside the picture.
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
  const picture = widthPx / heightPx;
  const view = viewWidthPx / viewHeightPx;
  if (!(picture > 0) || !(view > 0) || !Number.isFinite(picture / view)) return uv;
  // Cover cuts the longer side of the picture off; contain adds to the shorter one. Picture UV = 0.5 + scale * (view UV - 0.5).
  const alongX = picture > view === (fit === 'cover');
  const scaleX = alongX ? view / picture : 1;
  const scaleY = alongX ? 1 : picture / view;
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
