import { lstat } from 'node:fs/promises';
import { join } from 'node:path';
import { type DepthAnswers, type DepthScale, metersOf } from '../../export/captures/depth/depth-scale.ts';
import type { ScaleSource } from '../../export/captures/report/scale-source.ts';
import type { Axis } from '../../export/captures/upright.ts';
import type { CaptureMesh } from '../../nodes/kit/capture.ts';
import { readDepthScale } from './capture-depths.ts';
import { type KnownSize, type MeasuredSize, measureCapture } from './measure-capture.ts';
import { type FoundCapture, PANORAMA_FORM } from './read-capture-folder.ts';
import { USUAL_DISTANCE_M } from './reconstruct/guessed-unit.ts';

/** What an import says about the scale and the depth of a folder. */
export interface ScaleJob {
  /** Folder with photographs, cameras and mesh. */
  readonly folder: string;
  /** Meters per unit of the reconstruction, if `known` does not give it. */
  readonly metersPerUnit: number;
  /** Where `metersPerUnit` is from. Absent: the units of the files are taken as meters. */
  readonly unitFrom?: 'given' | 'guess';
  readonly known: KnownSize;
  /** What depth meshes are made from, and what the depth files have. */
  readonly depth: DepthAnswers & {
    /** Null: depth files where they are, else the mesh. */
    readonly from: 'files' | 'mesh' | 'none' | null;
  };
}

/** The scale of a reconstruction, where it is from, and what its depth files mean. */
export interface CaptureScale extends MeasuredSize {
  readonly scale: ScaleSource;
  /** Null without depth files. */
  readonly depth: DepthScale | null;
}

/** What an acquisition of Scrim writes beside its photographs, whose cameras are in meters. */
const ACQUISITION_FILE = 'acquisition.json';
/** Depth that differs by less from the surface confirms that units are meters. */
const SAME_FACTOR = 1.05;

/**
 * Finds the scale: from what was measured or given, else from the files.
 *
 * @param depths Paths of depth files in the order of the views.
 * @param mesh In units of the reconstruction; null if there is none.
 * @throws CaptureError
 */
export async function scaleOfCapture(
  { known, metersPerUnit: given, unitFrom, depth: answers, folder }: ScaleJob,
  { views, source }: FoundCapture,
  depths: readonly (string | null)[],
  mesh: CaptureMesh | null,
  up: Axis,
): Promise<CaptureScale> {
  const measure = (metersPerUnit: number): MeasuredSize => measureCapture(known, views, mesh, up, metersPerUnit);
  const measured = measure(given);
  const asked = askedScale(known, unitFrom);
  const depth = depths.some((path) => path !== null)
    ? await readDepthScale(views, depths, mesh, answers, measured.metersPerUnit, asked?.from === 'guessed')
    : null;
  const isMetric = depth !== null && metersOf(depth.unit) !== null;
  if (asked?.from === 'guessed' && isMetric && depth.timesSurface !== null) {
    return { ...measure(depth.metersPerUnit), scale: { from: 'depth' }, depth };
  }
  if (asked) return { ...measured, scale: asked, depth };
  if (await isThere(join(folder, ACQUISITION_FILE))) return { ...measured, scale: { from: 'file', file: ACQUISITION_FILE }, depth };
  const fits = depth?.timesSurface != null && Math.abs(Math.log(depth.timesSurface)) < Math.log(SAME_FACTOR);
  // All that is known of a single 360° photograph is its depth.
  const isMeasured = isMetric && (fits || (source.form === PANORAMA_FORM && mesh === null));
  return { ...measured, scale: { from: isMeasured ? 'depth' : 'assumed' }, depth };
}

function askedScale({ distance, floor, cameraHeightM }: KnownSize, unitFrom: ScaleJob['unitFrom']): ScaleSource | null {
  if (distance) return { from: 'distance', photo: distance.from.photo, meters: distance.meters };
  if (floor && cameraHeightM !== null) return { from: 'camera-height', photo: floor.photo, meters: cameraHeightM };
  if (unitFrom === 'given') return { from: 'given' };
  return unitFrom === 'guess' ? { from: 'guessed', meters: USUAL_DISTANCE_M } : null;
}

function isThere(path: string): Promise<boolean> {
  return lstat(path).then(
    () => true,
    () => false,
  );
}
