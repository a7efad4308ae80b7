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
  // Cover cuts the longer side of the picture off; contain adds to the shorter one.
  const alongX = picture > view === (fit === 'cover');
  return alongX ? scaledAboutCentre(uv, view / picture, 1) : scaledAboutCentre(uv, 1, picture / view);
}

/** `uv` after picture UV = 0.5 + scale * (view UV - 0.5). */
function scaledAboutCentre(uv: Float32Array, x: number, y: number): Float32Array {
  const offsetX = 0.5 - 0.5 * x;
  const offsetY = 0.5 - 0.5 * y;
  for (let row = 0; row < 3; row++) {
    const a = uv[row] ?? 0;
    const b = uv[row + 3] ?? 0;
    const c = uv[row + 6] ?? 0;
    scratchUv[row] = a * x;
    scratchUv[row + 3] = b * y;
    scratchUv[row + 6] = a * offsetX + b * offsetY + c;
  }
  return scratchUv;
}
