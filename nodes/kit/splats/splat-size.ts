import { SPLATS_PER_ROW, type Splats, splatGpuBytes } from './splats.ts';

/** How much of some splats is on the GPU. */
export interface SplatSize {
  readonly count: number;
  /** Degree of the harmonics. */
  readonly degree: Splats['degree'];
  readonly gpuBytes: number;
}

/** From all harmonics to none. */
const DEGREES = [3, 2, 1, 0] as const;

/**
 * How much of some splats has room on the GPU: with less memory first fewer degrees of their harmonics, then fewer splats.
 *
 * @param mostBytes What they may take. Default: no limit.
 *
 * @example
 * const { count, degree } = splatSize(2_000_000, 3, 64e6); // 1.8 million splats without harmonics
 */
export function splatSize(count: number, degree: Splats['degree'], mostBytes = Infinity): SplatSize {
  const fitting = DEGREES.find((each) => each <= degree && splatNeed(count, each) <= mostBytes);
  if (fitting !== undefined) return { count, degree: fitting, gpuBytes: splatGpuBytes(count, fitting) };
  const fittingRows = Math.max(1, Math.floor(mostBytes / splatGpuBytes(SPLATS_PER_ROW, 0)));
  const kept = Math.min(count, fittingRows * SPLATS_PER_ROW);
  return { count: kept, degree: 0, gpuBytes: splatGpuBytes(kept, 0) };
}

/**
 * The least limit at which all of some splats have room, bytes. Textures have whole rows.
 *
 * @example
 * const needs = splatNeed(500_000, 3);
 */
export function splatNeed(count: number, degree: Splats['degree']): number {
  return splatGpuBytes(Math.ceil(count / SPLATS_PER_ROW) * SPLATS_PER_ROW, degree);
}
