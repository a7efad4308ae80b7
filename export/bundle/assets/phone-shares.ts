import { CAPTURE_LIMITS, type CaptureDocument } from '../../../nodes/kit/capture.ts';
import { type CaptureSize, captureNeed, captureSize } from '../../../nodes/kit/capture-size.ts';
import { memoryShares, PHONE_GPU_BYTES } from '../../../nodes/kit/phone-memory.ts';
import { type SplatSize, splatNeed, splatSize } from '../../../nodes/kit/splats/splat-size.ts';
import type { ProgramAsset } from '../../program/program.ts';

/** A place that a page draws, and what its file has. */
export interface Place {
  readonly asset: ProgramAsset;
  /** The document of a capture, as the page has it. */
  readonly capture: CaptureDocument | null;
  readonly splats?: Pick<SplatSize, 'count' | 'degree'>;
}

/**
 * The memory of each capture and of all splats of a page on phones and headsets, bytes. Assets of the same file that are loaded once count
 * once. Other assets have none.
 */
export function phoneShares<P extends Place>(places: readonly P[]): ReadonlyMap<P, number> {
  const limited = places.filter(({ capture, splats }) => capture !== null || splats !== undefined);
  const keys = [...new Set(limited.map(keyOf))];
  const needs = keys.map((key) => {
    const place = limited.find((one) => keyOf(one) === key);
    return place ? needOf(place) : 0;
  });
  const shares = memoryShares(needs, PHONE_GPU_BYTES);
  return new Map(limited.map((place) => [place, shares[keys.indexOf(keyOf(place))] ?? 0]));
}

/** As pages share loaded files. */
function keyOf({ asset: { path, depthMeshes } }: Place): string {
  return `${path} ${depthMeshes === true}`;
}

function needOf({ asset, capture, splats }: Place): number {
  if (capture) return captureNeed(capture, drawnWith(asset));
  return splats ? splatNeed(splats.count, splats.degree) : 0;
}

function drawnWith({ depthMeshes }: ProgramAsset) {
  return { maxSidePx: CAPTURE_LIMITS.sidePx, depthMeshes: depthMeshes === true };
}

/** The size of a capture on phones and headsets; null for other assets. */
export function sizeOfCapture({ asset, capture }: Place, mostBytes: number | undefined): CaptureSize | null {
  return capture && captureSize(capture, { ...drawnWith(asset), mostBytes });
}

/** The size of splats on phones and headsets; null for other assets. */
export function sizeOfSplats({ splats }: Place, mostBytes: number | undefined): SplatSize | null {
  return splats ? splatSize(splats.count, splats.degree, mostBytes) : null;
}
