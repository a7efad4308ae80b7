import type { LayerPixels } from '../../kit/layer-pixels.ts';

/** What is measured of a mask. Positions are in the image, from (0, 0) at the bottom left to (1, 1). */
export interface MaskFigures {
  /** Share of the region that the mask covers. */
  area: number;
  readonly center: Float64Array;
  readonly boxMin: Float64Array;
  readonly boxMax: Float64Array;
}

export function createMaskFigures(): MaskFigures {
  return { area: 0, center: Float64Array.of(0.5, 0.5), boxMin: new Float64Array(2), boxMax: new Float64Array(2) };
}

export interface MaskRule {
  /** 0: by brightness; 1: by alpha. */
  readonly source: number;
  /** Least value of a pixel of the mask, from 0 to 1. */
  readonly threshold: number;
  readonly regionMin: ArrayLike<number>;
  readonly regionMax: ArrayLike<number>;
}

/**
 * Measures the pixels whose center is in the region: the zeroth and the first moments of the mask, and its box. A mask without pixels keeps
 * the last center.
 */
export function measureMask(into: MaskFigures, { data, widthPx, heightPx }: LayerPixels, rule: MaskRule): void {
  const { source, threshold, regionMin, regionMax } = rule;
  const firstX = firstIn(regionMin[0], widthPx);
  const firstY = firstIn(regionMin[1], heightPx);
  const endX = firstIn(regionMax[0], widthPx);
  const endY = firstIn(regionMax[1], heightPx);
  // Half a step of 8 bits: the sum of a luma is not exact.
  const least = threshold * 255 - 0.5;
  let count = 0;
  let sumX = 0;
  let sumY = 0;
  let left = widthPx;
  let right = -1;
  let bottom = heightPx;
  let top = -1;
  for (let y = firstY; y < endY; y++) {
    for (let x = firstX; x < endX; x++) {
      const i = (y * widthPx + x) * 4;
      const value = source === 1 ? (data[i + 3] ?? 0) : luma(data, i);
      if (value < least) continue;
      count++;
      sumX += x;
      sumY += y;
      if (x < left) left = x;
      if (x > right) right = x;
      if (y < bottom) bottom = y;
      top = y;
    }
  }
  const { center, boxMin, boxMax } = into;
  const pixels = Math.max(endX - firstX, 0) * Math.max(endY - firstY, 0);
  into.area = pixels === 0 ? 0 : count / pixels;
  boxMin.fill(0);
  boxMax.fill(0);
  if (count === 0) return;
  center[0] = (sumX / count + 0.5) / widthPx;
  center[1] = (sumY / count + 0.5) / heightPx;
  boxMin[0] = left / widthPx;
  boxMin[1] = bottom / heightPx;
  boxMax[0] = (right + 1) / widthPx;
  boxMax[1] = (top + 1) / heightPx;
}

/** Index of the first pixel whose center is at or after a position. */
function firstIn(position: number | undefined, sizePx: number): number {
  return Math.min(Math.max(Math.ceil((position ?? 0) * sizePx - 0.5), 0), sizePx);
}

/** Luma of Rec. 709, from premultiplied color, so black and transparent pixels have 0. */
function luma(data: Readonly<Uint8Array>, i: number): number {
  return 0.2126 * (data[i] ?? 0) + 0.7152 * (data[i + 1] ?? 0) + 0.0722 * (data[i + 2] ?? 0);
}
