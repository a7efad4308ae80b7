import { CaptureError } from '../../../nodes/kit/capture.ts';
import { type DepthKind, type DepthMap, isKnown } from './depth-map.ts';

/** The unit of depth files: meters, millimeters, that of the reconstruction, or a number of meters. */
export type DepthUnit = 'm' | 'mm' | 'reconstruction' | number;

/** What the values of depth files mean. `scale` gives units of the reconstruction. */
export interface DepthScale {
  readonly unit: DepthUnit;
  readonly kind: DepthKind;
  readonly scale: number;
}

/** The depth of one photograph as its file has it, and as the mesh has it; both along the axis, in the same pixels. */
export interface DepthSample {
  readonly name: string;
  /** The depths of the file, read as depths along the axis and as distances. */
  readonly file: Readonly<Record<DepthKind, DepthMap>>;
  /** Null without a mesh. */
  readonly mesh: DepthMap | null;
  /** The unit that files of this format have, unless the mesh tells another. */
  readonly usualUnit: DepthUnit;
}

/** What the user says; null: detected. */
export interface DepthAnswers {
  readonly unit: DepthUnit | null;
  readonly kind: DepthKind | null;
}

/** A depth that differs from the mesh by more than this factor has another unit. */
const MOST_FACTOR = 2;
/** Depths that are plausible without a mesh, meters. */
const LEAST_M = 0.02;
const MOST_M = 500;

/**
 * Finds out the unit and the kind of depth files, by the mesh if there is one.
 *
 * @param metersPerUnit Meters per unit of the reconstruction.
 * @throws CaptureError if the unit is implausible.
 */
export function depthScaleOf(samples: readonly DepthSample[], answers: DepthAnswers, metersPerUnit: number): DepthScale {
  const kinds: readonly DepthKind[] = answers.kind === null ? ['z', 'ray'] : [answers.kind];
  const fits = kinds.map((kind) => ({ kind, ...fitOf(samples, kind) }));
  const [best = { kind: 'z' as const, factor: Number.NaN, spread: 0 }] = fits.sort((a, b) => a.spread - b.spread);
  const usual = samples[0]?.usualUnit ?? 'm';
  const scaleOf = (unit: DepthUnit): number => scaleOfUnit(unit, metersPerUnit);
  if (!Number.isFinite(best.factor)) {
    const unit = answers.unit ?? usual;
    checkAlone(samples, unit, scaleOf(unit) * metersPerUnit);
    return { unit, kind: answers.kind ?? 'z', scale: scaleOf(unit) };
  }
  const off = (unit: DepthUnit): number => Math.abs(Math.log(best.factor / scaleOf(unit)));
  const units = [usual, 'm', 'mm', 'reconstruction'] as const;
  const unit = answers.unit ?? units.reduce((nearest, each) => (off(each) < off(nearest) ? each : nearest));
  if (off(unit) > Math.log(MOST_FACTOR)) {
    const times = (scaleOf(unit) / best.factor).toPrecision(2);
    const said = answers.unit === null ? 'in any usual unit' : `with the unit ${wordOf(unit)}`;
    throw new CaptureError(
      `the depth of ${samples[0]?.name} is ${Number(times)} times that of the mesh ${said}. Name another unit with --depth-unit, or import it without depth`,
    );
  }
  return { unit, kind: best.kind, scale: scaleOf(unit) };
}

/** Units of the reconstruction per unit of depth. */
function scaleOfUnit(unit: DepthUnit, metersPerUnit: number): number {
  if (unit === 'reconstruction') return 1;
  const meters = unit === 'm' ? 1 : unit === 'mm' ? 0.001 : unit;
  return meters / metersPerUnit;
}

function wordOf(unit: DepthUnit): string {
  return typeof unit === 'number' ? `${unit} m` : unit === 'reconstruction' ? 'of the reconstruction' : unit;
}

/** The median ratio of mesh and file, and the median distance from it. NaN where they have no pixel in common. */
function fitOf(samples: readonly DepthSample[], kind: DepthKind): { readonly factor: number; readonly spread: number } {
  const logs = samples.flatMap(({ file, mesh }) => {
    const found: number[] = [];
    file[kind].values.forEach((value, i) => {
      const truth = mesh?.values[i] ?? 0;
      if (isKnown(value) && isKnown(truth)) found.push(Math.log(truth / value));
    });
    return found;
  });
  const middle = median(logs);
  return { factor: Math.exp(middle), spread: median(logs.map((log) => Math.abs(log - middle))) };
}

function checkAlone(samples: readonly DepthSample[], unit: DepthUnit, meters: number): void {
  const middle = median(samples.flatMap(({ file }) => [...file.z.values].filter(isKnown))) * meters;
  if (Number.isFinite(middle) && (middle < LEAST_M || middle > MOST_M)) {
    throw new CaptureError(
      `the depth of ${samples[0]?.name} is ${Number(middle.toPrecision(2))} m in the middle, if its unit is ${wordOf(unit)}. Name another unit with --depth-unit`,
    );
  }
}

function median(values: readonly number[]): number {
  const sorted = Float64Array.from(values).sort();
  return sorted[Math.floor(sorted.length / 2)] ?? Number.NaN;
}
