import { CaptureError } from '../../../nodes/kit/capture.ts';
import { type DepthKind, type DepthMap, isKnown } from './depth-map.ts';

/** The unit of depth files: meters, millimeters, that of the reconstruction, or a number of meters. */
export type DepthUnit = 'm' | 'mm' | 'reconstruction' | number;

/** What the values of depth files mean. `scale` gives units of the reconstruction. */
export interface DepthScale {
  readonly unit: DepthUnit;
  readonly kind: DepthKind;
  readonly scale: number;
  /** That of the reconstruction: as it was given, or what the depth says. */
  readonly metersPerUnit: number;
  /** How many times as far the depth is as the surface; null if no surface is known. */
  readonly timesSurface: number | null;
}

/** What depth files are compared with: the mesh of the place, or the points that photographs share. */
export type SurfaceKind = 'mesh' | 'points';

/** The depth of one photograph as its file has it, and as the surface has it; both along the axis, in the same pixels. */
export interface DepthSample {
  readonly name: string;
  /** The depths of the file, read as depths along the axis and as distances. */
  readonly file: Readonly<Record<DepthKind, DepthMap>>;
  /** Depths of the mesh, or of points; null without both. */
  readonly surface: { readonly kind: SurfaceKind; readonly map: DepthMap } | null;
  /** The unit that files of this format have, unless the mesh tells another. */
  readonly usualUnit: DepthUnit;
}

/** What the user says; null: detected. */
export interface DepthAnswers {
  readonly unit: DepthUnit | null;
  readonly kind: DepthKind | null;
}

/** A depth that differs from the surface by more than this factor has another unit. */
const MOST_FACTOR = 2;
/** Units of some sensors and data sets in meters: 0.25 mm, a 5,000th of TUM RGB-D, 0.1 mm, 1 cm. They are less than 2 apart, so they must fit. */
const RARE_UNITS_M = [0.00025, 0.0002, 0.0001, 0.01] as const;
const RARE_FACTOR = 1.1;
/** Pixels that file and surface must share; a few points may lie at edges. */
const LEAST_SHARED = 8;
/** Depths that are plausible without a mesh, meters. */
const LEAST_M = 0.02;
const MOST_M = 500;

/**
 * Finds out the unit and the kind of depth files, by the mesh or the points if there are some.
 *
 * @param metersPerUnit Meters per unit of the reconstruction.
 * @param isGuess Whether that is a guess, which depth in meters corrects.
 * @throws CaptureError if the unit is implausible.
 */
export function depthScaleOf(samples: readonly DepthSample[], answers: DepthAnswers, metersPerUnit: number, isGuess = false): DepthScale {
  const kinds: readonly DepthKind[] = answers.kind === null ? ['z', 'ray'] : [answers.kind];
  const fits = kinds.map((kind) => ({ kind, ...fitOf(samples, kind) }));
  const [best = { kind: 'z' as const, factor: Number.NaN, spread: 0 }] = fits.sort((a, b) => a.spread - b.spread);
  const usual = samples[0]?.usualUnit ?? 'm';
  const scaleOf = (unit: DepthUnit): number => scaleOfUnit(unit, metersPerUnit);
  if (!Number.isFinite(best.factor)) {
    const unit = answers.unit ?? usual;
    checkMiddle(samples, unit, scaleOf(unit) * metersPerUnit);
    return { unit, kind: answers.kind ?? 'z', scale: scaleOf(unit), metersPerUnit, timesSurface: null };
  }
  const meters = metersOf(answers.unit ?? usual);
  if (isGuess && meters !== null) {
    checkMiddle(samples, answers.unit ?? usual, meters);
    const { kind, factor } = best;
    return { unit: answers.unit ?? usual, kind, scale: factor, metersPerUnit: meters / factor, timesSurface: 1 };
  }
  const unit = answers.unit ?? fittingUnit(usual, best.factor, scaleOf);
  const timesSurface = scaleOf(unit) / best.factor;
  if (Math.abs(Math.log(timesSurface)) > Math.log(MOST_FACTOR)) {
    const times = Number(timesSurface.toPrecision(2));
    const said = answers.unit === null ? 'in any usual unit' : `with the unit ${depthUnitWord(unit)}`;
    const surface = surfaceWord(samples);
    throw new CaptureError(
      `the depth of ${samples[0]?.name} is ${times} times that of the ${surface} ${said}. Choose another unit of depth, or import it without depth`,
    );
  }
  return { unit, kind: best.kind, scale: scaleOf(unit), metersPerUnit, timesSurface };
}

function fittingUnit(usual: DepthUnit, factor: number, scaleOf: (unit: DepthUnit) => number): DepthUnit {
  const off = (unit: DepthUnit): number => Math.abs(Math.log(factor / scaleOf(unit)));
  const nearest = (units: readonly DepthUnit[]): DepthUnit => units.reduce((best, each) => (off(each) < off(best) ? each : best));
  const common = nearest([usual, 'm', 'mm', 'reconstruction']);
  if (off(common) <= Math.log(MOST_FACTOR)) return common;
  const rare = nearest(RARE_UNITS_M);
  return off(rare) <= Math.log(RARE_FACTOR) ? rare : common;
}

/** What depth files were compared with, in words. */
export function surfaceWord(samples: readonly Pick<DepthSample, 'surface'>[]): string {
  return samples[0]?.surface?.kind === 'points' ? 'points of the reconstruction' : 'mesh';
}

/** Meters per unit of depth; null for the unit of the reconstruction. */
export function metersOf(unit: DepthUnit): number | null {
  if (unit === 'reconstruction') return null;
  return unit === 'm' ? 1 : unit === 'mm' ? 0.001 : unit;
}

/** Units of the reconstruction per unit of depth. */
function scaleOfUnit(unit: DepthUnit, metersPerUnit: number): number {
  const meters = metersOf(unit);
  return meters === null ? 1 : meters / metersPerUnit;
}

/** A unit of depth in words, after “the unit”. */
export function depthUnitWord(unit: DepthUnit): string {
  return typeof unit === 'number' ? `${unit} m` : unit === 'reconstruction' ? 'of the reconstruction' : unit;
}

/** The median ratio of surface and file, and the median distance from it. NaN where they share too few pixels. */
function fitOf(samples: readonly DepthSample[], kind: DepthKind): { readonly factor: number; readonly spread: number } {
  const logs = samples.flatMap(({ file, surface }) => {
    const found: number[] = [];
    file[kind].values.forEach((value, i) => {
      const truth = surface?.map.values[i] ?? 0;
      if (isKnown(value) && isKnown(truth)) found.push(Math.log(truth / value));
    });
    return found;
  });
  if (logs.length < LEAST_SHARED) return { factor: Number.NaN, spread: 0 };
  const middle = median(logs);
  return { factor: Math.exp(middle), spread: median(logs.map((log) => Math.abs(log - middle))) };
}

function checkMiddle(samples: readonly DepthSample[], unit: DepthUnit, meters: number): void {
  const middle = median(samples.flatMap(({ file }) => [...file.z.values].filter(isKnown))) * meters;
  if (Number.isFinite(middle) && (middle < LEAST_M || middle > MOST_M)) {
    throw new CaptureError(
      `the depth of ${samples[0]?.name} is ${Number(middle.toPrecision(2))} m in the middle, if its unit is ${unit === 'reconstruction' ? 'that ' : ''}${depthUnitWord(unit)}. Choose another unit of depth`,
    );
  }
}

function median(values: readonly number[]): number {
  const sorted = Float64Array.from(values).sort();
  return sorted[Math.floor(sorted.length / 2)] ?? Number.NaN;
}
