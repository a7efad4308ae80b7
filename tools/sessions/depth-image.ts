import { decode, encode } from 'fast-png';
import type { Intrinsics } from '../../export/runtime/sessions/session-format.ts';
import { cross, dot, normalize, subtract, type Vector } from './vector.ts';

/** Depth of a frame: meters along the optical axis, rows from the top, 0 for unknown. */
export interface DepthImage {
  readonly widthPx: number;
  readonly heightPx: number;
  readonly meters: Float32Array;
}

/**
 * Decodes a depth image; `metresPerUnit` is the depth of one unit in meters.
 *
 * @throws Error if the PNG is not a 16-bit image with one channel
 */
export function decodeDepthPng(png: Uint8Array, metresPerUnit: number): DepthImage {
  const { width, height, data, depth, channels } = decode(png);
  if (depth !== 16 || channels !== 1) throw new Error(`a depth picture has one channel of 16 bits; this one has ${channels} of ${depth}`);
  return {
    widthPx: width,
    heightPx: height,
    meters: Float32Array.from(data, (unit) => (unit === INVALID_UNIT ? 0 : unit * metresPerUnit)),
  };
}

/** Value of unknown depth in some drivers (7-Scenes, Kinect). Sessions use 0. */
const INVALID_UNIT = 65535;

/** Replaces unknown depth by 0; null if there is none to replace. */
export function withoutInvalid(png: Uint8Array): Uint8Array | null {
  const { width, height, data } = decode(png);
  if (!data.includes(INVALID_UNIT)) return null;
  const units = Uint16Array.from(data, (unit) => (unit === INVALID_UNIT ? 0 : unit));
  return encode({ width, height, data: units, depth: 16, channels: 1 });
}

/** A point on a surface in camera space (looking along −z, y up). */
export interface SurfacePoint {
  readonly point: Vector;
  /** Unit normal toward the camera. */
  readonly normal: Vector;
}

/**
 * Distance in the image to the neighbors that determine a normal, as a fraction of the width: large compared with depth steps of a
 * millimeter.
 */
const REACH = 1 / 130;
/** Relative deviation of 1 / depth above which a pixel counts as an edge. On a plane, 1 / depth changes linearly between pixels. */
const MAX_BEND = 0.01;

/** Points with normals on a grid of every `stridePx` pixels, except at edges and unknown depth. */
export function surfacePoints(depth: DepthImage, intrinsics: Intrinsics, stridePx: number): SurfacePoint[] {
  const out: SurfacePoint[] = [];
  const reachPx = Math.max(2, Math.round(depth.widthPx * REACH));
  for (let row = reachPx; row < depth.heightPx - reachPx; row += stridePx) {
    for (let column = reachPx; column < depth.widthPx - reachPx; column += stridePx) {
      const found = surfaceAt(depth, intrinsics, column, row, reachPx);
      if (found) out.push(found);
    }
  }
  return out;
}

function surfaceAt(depth: DepthImage, intrinsics: Intrinsics, column: number, row: number, reachPx: number): SurfacePoint | null {
  const at = (c: number, r: number): number => depth.meters[r * depth.widthPx + c] ?? 0;
  const center = at(column, row);
  if (center <= 0) return null;
  const neighbors = [
    [column + reachPx, row],
    [column - reachPx, row],
    [column, row - reachPx],
    [column, row + reachPx],
  ] as const;
  const [toRight, toLeft, toAbove, toBelow] = neighbors.map(([c, r]) => center / at(c, r)) as [number, number, number, number];
  // Infinite if a neighbor is unknown.
  if (!(Math.abs(toRight + toLeft - 2) < MAX_BEND && Math.abs(toAbove + toBelow - 2) < MAX_BEND)) return null;
  const [right, left, above, below] = neighbors.map(([c, r]) => backProject(intrinsics, c, r, at(c, r))) as [
    Vector,
    Vector,
    Vector,
    Vector,
  ];
  const point = backProject(intrinsics, column, row, center);
  const normal = normalize(cross(subtract(right, left), subtract(above, below)));
  return dot(normal, point) < 0 ? { point, normal } : { point, normal: [-normal[0], -normal[1], -normal[2]] };
}

/** The point in camera space that a pixel’s center shows. */
export function backProject({ fxPx, fyPx, cxPx, cyPx }: Intrinsics, column: number, row: number, distanceM: number): Vector {
  return [((column + 0.5 - cxPx) / fxPx) * distanceM, -((row + 0.5 - cyPx) / fyPx) * distanceM, -distanceM];
}

/** Projects a point in camera space to pixels; (0.5, 0.5) is the center of the top left pixel. */
export function project({ fxPx, fyPx, cxPx, cyPx }: Intrinsics, [x, y, z]: Vector): readonly [number, number] {
  return [cxPx - (fxPx * x) / z, cyPx + (fyPx * y) / z];
}
