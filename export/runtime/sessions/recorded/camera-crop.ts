import { setFrustum } from '../matrix.ts';
import type { Intrinsics } from '../session-format.ts';

/** Part of an image in pixels, y down. */
export interface Crop {
  x0: number;
  y0: number;
  x1: number;
  y1: number;
}

/** Sets `out` to the largest centered part of the image with the aspect ratio of the view. */
export function setCoverCrop(out: Crop, widthPx: number, heightPx: number, viewWidthPx: number, viewHeightPx: number): void {
  const viewAspect = viewWidthPx / viewHeightPx;
  const width = Math.min(widthPx, heightPx * viewAspect);
  const height = Math.min(heightPx, widthPx / viewAspect);
  out.x0 = (widthPx - width) / 2;
  out.x1 = (widthPx + width) / 2;
  out.y0 = (heightPx - height) / 2;
  out.y1 = (heightPx + height) / 2;
}

/** Writes the projection of the crop. It is off-axis, because cropping changes the frustum but not the camera. */
export function setCropProjection(out: Float32Array, crop: Crop, camera: Intrinsics, nearM: number, farM: number): void {
  const { fxPx, fyPx, cxPx, cyPx } = camera;
  setFrustum(out, (crop.x0 - cxPx) / fxPx, (crop.x1 - cxPx) / fxPx, (cyPx - crop.y1) / fyPx, (cyPx - crop.y0) / fyPx, nearM, farM);
}

/**
 * Writes the matrix from view UV to texture UV for an image of another camera, `other`, at the pose of `camera`. The first row of the
 * texture is the top row. View UV → pixel of the crop → ray → pixel of `other`. Column-major 3×3.
 */
export function setUvFromViewUv(
  out: Float32Array,
  crop: Crop,
  camera: Intrinsics,
  other: Intrinsics,
  otherWidthPx: number,
  otherHeightPx: number,
): void {
  const perPixelX = other.fxPx / camera.fxPx / otherWidthPx;
  const perPixelY = other.fyPx / camera.fyPx / otherHeightPx;
  out.fill(0);
  out[0] = (crop.x1 - crop.x0) * perPixelX;
  out[4] = (crop.y0 - crop.y1) * perPixelY;
  out[6] = (crop.x0 - camera.cxPx) * perPixelX + other.cxPx / otherWidthPx;
  out[7] = (crop.y1 - camera.cyPx) * perPixelY + other.cyPx / otherHeightPx;
  out[8] = 1;
}
