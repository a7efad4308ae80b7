import type { Pinhole } from '../../../nodes/kit/capture.ts';

/**
 * The directions of the pixels of a camera: (`across[column] * level[row]`, `down[row]`, `ahead[column] * level[row]`), which is x to the
 * right, y down and z forward. A direction times the depth of its pixel is the point: along a pinhole camera's axis, z is 1; around a 360°
 * camera the direction is a unit vector.
 */
export interface DepthRays {
  readonly widthPx: number;
  readonly heightPx: number;
  readonly across: Float64Array;
  readonly ahead: Float64Array;
  readonly level: Float64Array;
  readonly down: Float64Array;
  /** Whether the last column is beside the first. */
  readonly wraps: boolean;
}

/** The directions of the pixel centers of a camera. */
export function raysOf(camera: Pinhole): DepthRays {
  return camera.projection === undefined ? pinholeRays(camera) : panoramaRays(camera.widthPx, camera.heightPx);
}

/** The directions of the pixel centers of a pinhole camera. */
export function pinholeRays({ widthPx, heightPx, fxPx, fyPx, cxPx, cyPx }: Pinhole): DepthRays {
  return {
    widthPx,
    heightPx,
    across: Float64Array.from({ length: widthPx }, (_, column) => (column + 0.5 - cxPx) / fxPx),
    ahead: new Float64Array(widthPx).fill(1),
    level: new Float64Array(heightPx).fill(1),
    down: Float64Array.from({ length: heightPx }, (_, row) => (row + 0.5 - cyPx) / fyPx),
    wraps: false,
  };
}

/** The directions of the pixel centers of an equirectangular photograph, whose center is straight ahead. */
export function panoramaRays(widthPx: number, heightPx: number): DepthRays {
  const longitude = (column: number): number => ((column + 0.5) / widthPx - 0.5) * 2 * Math.PI;
  const latitude = (row: number): number => (0.5 - (row + 0.5) / heightPx) * Math.PI;
  return {
    widthPx,
    heightPx,
    across: Float64Array.from({ length: widthPx }, (_, column) => Math.sin(longitude(column))),
    ahead: Float64Array.from({ length: widthPx }, (_, column) => Math.cos(longitude(column))),
    level: Float64Array.from({ length: heightPx }, (_, row) => Math.cos(latitude(row))),
    down: Float64Array.from({ length: heightPx }, (_, row) => -Math.sin(latitude(row))),
    wraps: true,
  };
}
