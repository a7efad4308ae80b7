import { CaptureError } from '../../../nodes/kit/capture.ts';
import { type DepthKind, type DepthMap, isKnown } from './depth-map.ts';
import { type DepthPoint, depthPoints2d, type PlanCamera } from './depth-plan.ts';
import { type DepthAnswers, type DepthSample, type DepthScale, type DepthUnit, depthScaleOf, metersOf } from './depth-scale.ts';

/** A depth map of a few pixels as the host sends it; values of 0 are unknown. */
export interface SentDepth {
  readonly name: string;
  readonly usualUnit: DepthUnit;
  readonly pinhole: PlanCamera;
  readonly values: readonly number[];
  readonly surface: { readonly kind: 'mesh' | 'points'; readonly values: readonly number[] } | null;
}

/** What depth files give with a unit and a kind. */
export interface JudgedDepth {
  /** What was asked, and what was detected where nothing was; null if nothing fits. */
  readonly scale: DepthScale | null;
  /** Why it cannot be imported so; null if it can. */
  readonly problem: string | null;
  /** Distances from the camera along its axis, or of 360° photographs along the ray; NaN if there are none. */
  readonly medianM: number;
  readonly farthestM: number;
  /** The median share by which depth and surface differ, for the kind of `scale`; null without a surface. */
  readonly offSurface: number | null;
  /** What the middle rows of one photograph show, from above. */
  readonly plan: readonly DepthPoint[];
  /** The same of the mesh. */
  readonly surfacePlan: readonly DepthPoint[];
}

/**
 * Judges depth files with a unit and a kind, before the import.
 *
 * @param answers Null: detected.
 * @param isGuess Whether the scale is not known, as before COLMAP has found cameras.
 */
export function judgeDepth(sent: readonly SentDepth[], answers: DepthAnswers, metersPerUnit: number, isGuess: boolean): JudgedDepth {
  const isAround = sent.every(({ pinhole }) => pinhole.isAround);
  const samples = sent.map(sampleOf);
  let scale: DepthScale | null = null;
  let problem: string | null = null;
  try {
    scale = depthScaleOf(samples, isAround ? { ...answers, kind: 'ray' } : answers, metersPerUnit, isGuess);
  } catch (error) {
    if (!(error instanceof CaptureError)) throw error;
    problem = `${error.message.charAt(0).toUpperCase()}${error.message.slice(1)}.`;
  }
  const kind: DepthKind = scale?.kind ?? answers.kind ?? 'z';
  const meters = scale ? scale.scale * scale.metersPerUnit : (metersOf(answers.unit ?? samples[0]?.usualUnit ?? 'm') ?? metersPerUnit);
  const depths = samples.flatMap(({ file }) => [...file[kind].values].filter(isKnown)).sort((a, b) => a - b);
  const shown = samples[samples.length >> 1];
  const pinhole = sent[samples.length >> 1]?.pinhole;
  const planOf = (map: DepthMap | undefined, factor: number) => (map && pinhole ? depthPoints2d(map, pinhole, factor) : []);
  const surface = shown?.surface?.kind === 'mesh' ? shown.surface.map : undefined;
  return {
    scale,
    problem,
    medianM: (depths[depths.length >> 1] ?? Number.NaN) * meters,
    farthestM: (depths.at(-1) ?? Number.NaN) * meters,
    offSurface: scale?.timesSurface == null ? null : offSurface(samples, kind, scale.scale),
    plan: planOf(shown?.file[kind], meters),
    surfacePlan: planOf(surface, scale?.metersPerUnit ?? metersPerUnit),
  };
}

function sampleOf({ name, usualUnit, pinhole, values, surface }: SentDepth): DepthSample {
  const { widthPx, heightPx, fxPx, fyPx, cxPx, cyPx, isAround } = pinhole;
  const mapOf = (depths: readonly number[]): DepthMap => ({ widthPx, heightPx, values: Float32Array.from(depths) });
  const alongAxis = (depth: number, i: number): number => {
    const x = ((i % widthPx) + 0.5 - cxPx) / fxPx;
    const y = (Math.floor(i / widthPx) + 0.5 - cyPx) / fyPx;
    return depth / Math.hypot(x, y, 1);
  };
  const z = mapOf(values);
  return {
    name,
    usualUnit,
    file: { z, ray: isAround ? z : mapOf(values.map(alongAxis)) },
    surface: surface && { kind: surface.kind, map: mapOf(surface.values) },
  };
}

/** The median share, over all pixels that both have. */
function offSurface(samples: readonly DepthSample[], kind: DepthKind, scale: number): number | null {
  const shares = samples.flatMap(({ file, surface }) => {
    const found: number[] = [];
    surface?.map.values.forEach((truth, i) => {
      const depth = (file[kind].values[i] ?? 0) * scale;
      if (isKnown(truth) && isKnown(depth)) found.push(Math.abs(depth / truth - 1));
    });
    return found;
  });
  return shares.sort((a, b) => a - b)[shares.length >> 1] ?? null;
}
