import { CaptureError, type Pinhole, poseFault } from '../../nodes/kit/capture.ts';
import type { Lens } from './lens.ts';
import { project, unproject } from './lens.ts';

/** A photograph with its camera, as the files of a reconstruction describe it. */
export interface SourceView {
  /** Path of the photograph relative to the folder of photographs. */
  readonly name: string;
  /** The camera model by its name, such as `SIMPLE_RADIAL`. */
  readonly model: string;
  /** Null: the file does not say the size, which the photograph has. */
  readonly lens: (widthPx: number, heightPx: number) => Lens;
  /** Size of the photograph for which the lens is known; null if the file does not say it. */
  readonly sizePx: readonly [number, number] | null;
  /** Column-major 4×4; the camera has y up and looks along −z. In the units and axes of the file. */
  readonly worldFromCamera: readonly number[];
  /** Path of the depth map relative to the folder; null if the file does not name it. */
  readonly depthName: string | null;
  /** Where points of the reconstruction were seen: column, row, x, y and z of the point, for each. */
  readonly observations: Float64Array;
}

/** Views of a reconstruction. */
export interface SourceCapture {
  /** What the files are, for people, such as `COLMAP (text)`. */
  readonly form: string;
  readonly views: readonly SourceView[];
  readonly pointCount: number;
}

/**
 * The pose of a camera from COLMAP's camera-from-world rotation and translation, with OpenCV's camera axes.
 *
 * @param q Quaternion, w first.
 * @throws CaptureError if it is none.
 */
export function poseOfColmap(q: readonly number[], t: readonly number[], name: string): readonly number[] {
  const length = Math.hypot(...q);
  if (![...q, ...t].every(Number.isFinite)) throw new CaptureError(`the pose of ${name} is not finite`);
  if (Math.abs(length - 1) > 0.01) throw new CaptureError(`the rotation of ${name} is not a unit quaternion`);
  const [w = 0, x = 0, y = 0, z = 0] = q.map((c) => c / length);
  const [tx = 0, ty = 0, tz = 0] = t;
  // The rows of camera-from-world are the camera's axes in the world.
  const right = [1 - 2 * (y * y + z * z), 2 * (x * y - w * z), 2 * (x * z + w * y)] as const;
  const down = [2 * (x * y + w * z), 1 - 2 * (x * x + z * z), 2 * (y * z - w * x)] as const;
  const forward = [2 * (x * z - w * y), 2 * (y * z + w * x), 1 - 2 * (x * x + y * y)] as const;
  const center = [0, 1, 2].map((i) => -((right[i] ?? 0) * tx + (down[i] ?? 0) * ty + (forward[i] ?? 0) * tz));
  return [...right, 0, ...down.map(negate), 0, ...forward.map(negate), 0, ...center, 1];
}

function negate(x: number): number {
  return -x;
}

/** @throws CaptureError for poses that are not rigid. */
export function checkPose(pose: readonly number[], name: string): void {
  const fault = poseFault(pose);
  if (fault === null) return;
  const remedy = fault === 'mirrored' ? 'Export the cameras without mirroring an axis' : 'Export the cameras without scale';
  throw new CaptureError(`the pose of ${name} is ${fault}. ${remedy}`);
}

/** Mean distance in pixels between where points were seen and where the camera projects them. Null without points in front of it. */
export function reprojectionErrorPx(view: SourceView, lens: Lens): number | null {
  if (lens.projection === 'equirectangular') return null;
  const place = new Float64Array(2);
  let sum = 0;
  let count = 0;
  eachPointAhead(view, (column, row, x, y) => {
    project(lens, x, y, place);
    sum += Math.hypot((place[0] ?? 0) - column, (place[1] ?? 0) - row);
    count++;
  });
  return count === 0 ? null : sum / count;
}

/**
 * Calls `visit` for each point in front of a camera, with the column and row where it was seen, and its direction: right and down over its
 * depth, and the depth.
 */
export function eachPointAhead(
  { worldFromCamera: m, observations }: SourceView,
  visit: (column: number, row: number, x: number, y: number, depth: number) => void,
): void {
  for (let i = 0; i + 4 < observations.length; i += 5) {
    const [column = 0, row = 0, x = 0, y = 0, z = 0] = observations.subarray(i, i + 5);
    const d = [x - (m[12] ?? 0), y - (m[13] ?? 0), z - (m[14] ?? 0)];
    const along = (axis: number): number => d.reduce((total, value, c) => total + value * (m[4 * axis + c] ?? 0), 0);
    const depth = -along(2);
    if (depth > 0) visit(column, row, along(0) / depth, -along(1) / depth, depth);
  }
}

/**
 * Where points were seen and where the camera projects them, in a photograph whose distortion was removed.
 *
 * @param lens The lens of the photograph in which the points were seen.
 * @param pinhole The camera of the photograph without distortion.
 * @param most The number of points above which some are left out, evenly.
 * @returns Column and row of both, in pixels of `pinhole` with two decimals, for each point.
 */
export function reprojectedPlaces(view: SourceView, lens: Lens, pinhole: Pinhole, most: number): readonly number[] {
  if (lens.projection === 'equirectangular') return [];
  const places: number[] = [];
  const seen = new Float64Array(2);
  const step = Math.max(1, Math.ceil(view.observations.length / 5 / most));
  let index = 0;
  eachPointAhead(view, (column, row, x, y) => {
    if (index++ % step !== 0) return;
    unproject(lens, column, row, seen);
    const [seenX = Number.NaN, seenY = Number.NaN] = seen;
    const pair = [seenX, seenY, x, y].map((at, i) => (i % 2 === 0 ? at * pinhole.fxPx + pinhole.cxPx : at * pinhole.fyPx + pinhole.cyPx));
    if (pair.every(Number.isFinite)) places.push(...pair.map((at) => Math.round(100 * at) / 100));
  });
  return places;
}
