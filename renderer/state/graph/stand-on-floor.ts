import type { ModelBounds } from '../../../export/gltf/model-bounds.ts';
import { POSITION_PARAM, SCALE_PARAM } from '../../../nodes/kit/pose-params.ts';
import type { FloorPoint } from './floor-point.ts';

/** Params of `objects/transform`. */
export interface Standing {
  readonly positionM: readonly [number, number, number];
  readonly scale: number;
}

/** A model of another size was probably not made in meters, or is too large or too small to be seen whole. */
const USUAL_M = { least: 0.1, most: 1 };
/** A smaller model becomes at most as large. */
const ENLARGED_M = 0.5;
const STEPS = [5, 2, 1] as const;

/** Where a model has its lowest point on the floor and its middle over a point of it, and how large it is, so that it is seen. */
export function standOnFloor([x, z]: FloorPoint, bounds: ModelBounds | null): Standing {
  if (bounds === null) return { positionM: [rounded(x), 0, rounded(z)], scale: 1 };
  const { min, max } = bounds;
  const scale = visibleScale(greatestSize(bounds));
  const middle = (axis: 0 | 2) => (scale * (min[axis] + max[axis])) / 2;
  return { positionM: [rounded(x - middle(0)), rounded(-scale * min[1]), rounded(z - middle(2))], scale };
}

/** Distance between models that are put side by side, and the assumed size of one whose bounds are not known. */
const GAP_M = 0.1;
const UNKNOWN_M = 0.5;

/**
 * The points of the floor at which `standOnFloor` puts models side by side, in the order given: their boxes do not overlap in x and z. The row
 * has its middle at the given point.
 *
 * @param along Unit vector in x and z along which the row goes.
 */
export function rowOnFloor(
  [x, z]: FloorPoint,
  [alongX, alongZ]: readonly [number, number],
  models: readonly (ModelBounds | null)[],
): readonly FloorPoint[] {
  const sizes = models.map(sizeOnFloor);
  // Boxes along the axes are apart as soon as they are apart in one of them.
  const apart = (a: Size, b: Size) => Math.min(((a.x + b.x) / 2 + GAP_M) / Math.abs(alongX), ((a.z + b.z) / 2 + GAP_M) / Math.abs(alongZ));
  const places: number[] = [];
  for (const [i, size] of sizes.entries())
    places.push(Math.max(0, ...sizes.slice(0, i).map((other, j) => (places[j] ?? 0) + apart(other, size))));
  const center = (places.at(-1) ?? 0) / 2;
  return places.map((place) => [x + alongX * (place - center), z + alongZ * (place - center)]);
}

interface Size {
  readonly x: number;
  readonly z: number;
}

/** The size at which `standOnFloor` shows a model, in meters. */
function sizeOnFloor(bounds: ModelBounds | null): Size {
  if (bounds === null) return { x: UNKNOWN_M, z: UNKNOWN_M };
  const scale = visibleScale(greatestSize(bounds));
  return { x: scale * (bounds.max[0] - bounds.min[0]), z: scale * (bounds.max[2] - bounds.min[2]) };
}

function greatestSize({ min, max }: ModelBounds): number {
  return Math.max(max[0] - min[0], max[1] - min[1], max[2] - min[2]);
}

/** A round scale that gives something of this size one that is seen; 1 for usual sizes. */
export function visibleScale(sizeM: number): number {
  if (sizeM === 0 || (sizeM >= USUAL_M.least && sizeM <= USUAL_M.most)) return 1;
  return sizeM > USUAL_M.most ? roundDown(USUAL_M.most / sizeM) : Math.min(roundDown(ENLARGED_M / sizeM), SCALE_PARAM.max);
}

/** The largest of 1, 2, 5, 10, 20 … and of 0.5, 0.2, 0.1 … that is no greater. */
function roundDown(value: number): number {
  const power = 10 ** Math.floor(Math.log10(value));
  return Number(((STEPS.find((step) => step * power <= value) ?? 1) * power).toPrecision(1));
}

/** In millimeters, within the range of the param. */
function rounded(meters: number): number {
  return Number(Math.min(POSITION_PARAM.max[0], Math.max(POSITION_PARAM.min[0], meters)).toFixed(3)) + 0;
}
