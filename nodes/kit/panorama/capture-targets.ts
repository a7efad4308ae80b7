import { projectDirection, type ShotPoint, type ShotPose } from './shot.ts';

/** Unit vector in world space. */
export type Direction = readonly [x: number, y: number, z: number];

/**
 * The rows of targets: the elevation in degrees, and how many targets are evenly spaced around at that elevation. Together there are 34, as
 * in the ARPAS paper.
 */
const ROWS: readonly (readonly [elevationDeg: number, count: number])[] = [
  [0, 10],
  [36, 8],
  [-36, 8],
  [68, 3],
  [-68, 3],
  [90, 1],
  [-90, 1],
];
/** How exactly visitors aim: a photo may be off its target by this angle, so the edges of its planned image cannot be relied on. */
export const AIM_RAD = (4 * Math.PI) / 180;
/** The number of directions that are tested for holes; they are about 3° apart. */
const SAMPLES = 4096;
/** Holes of up to this fraction of the sphere need no further photos: they are filled from their surroundings. */
const HOLES_LEFT = 0.002;
/** The most targets. A narrow lens would need hundreds of photos, which no one takes. */
export const MOST_TARGETS = 96;

/**
 * The directions of the photos: 34, and more where a lens leaves holes between them.
 *
 * @param clipFromView Projection of the camera, column-major 4×4.
 *
 * @example
 * for (const target of captureTargets(view.clipFromView)) addMarker(target);
 */
export function captureTargets(clipFromView: Float32Array): Direction[] {
  const lens = narrowed(clipFromView);
  const targets = ROWS.flatMap(([elevationDeg, count]) =>
    Array.from({ length: count }, (_, i) => directionOf((i / count) * 2 * Math.PI, (elevationDeg / 180) * Math.PI)),
  );
  const planned = targets.map((target) => ({ clipFromView: lens, worldFromView: uprightPose(target) }));
  return [...targets, ...targetsForHoles(planned, lens, MOST_TARGETS - targets.length)];
}

/**
 * Finds further targets for the directions that no photo shows: as few as possible, first the one that shows most of them.
 *
 * @example
 * targetsForHoles([], view.clipFromView, 6); // six directions that show as much as possible
 */
export function targetsForHoles(shots: readonly ShotPose[], clipFromView: Float32Array, most: number): Direction[] {
  const samples = sphereSamples(SAMPLES);
  let open = samples.filter((sample) => !shots.some((shot) => shows(shot, sample)));
  const added: Direction[] = [];
  while (open.length > SAMPLES * HOLES_LEFT && added.length < most) {
    let best: { readonly target: Direction; readonly left: Direction[] } | null = null;
    // Every direction of a hole may be the center of a photo; 60 of them are enough to choose from.
    for (let i = 0; i < open.length; i += Math.ceil(open.length / 60)) {
      const target = open[i] as Direction;
      const shot = { clipFromView, worldFromView: uprightPose(target) };
      const left = open.filter((sample) => !shows(shot, sample));
      if (best === null || left.length < best.left.length) best = { target, left };
    }
    if (best === null || best.left.length === open.length) break;
    added.push(best.target);
    open = best.left;
  }
  return added;
}

/** How much of the sphere the photos show, as fractions of its solid angle. */
export interface Coverage {
  /** The fraction that one photo or more show. */
  readonly seenPart: number;
  /** The fraction that two photos or more show. */
  readonly overlapPart: number;
}

/**
 * Measures how much of the sphere photos show.
 *
 * @example
 * if (coverageOf(shots).seenPart > 0.99) finish();
 */
export function coverageOf(shots: readonly ShotPose[]): Coverage {
  let seen = 0;
  let twice = 0;
  for (const sample of sphereSamples(SAMPLES)) {
    let count = 0;
    for (const shot of shots) if (shows(shot, sample)) count++;
    if (count > 0) seen++;
    if (count > 1) twice++;
  }
  return { seenPart: seen / SAMPLES, overlapPart: twice / SAMPLES };
}

/**
 * Evenly spaced directions, which stand for equal solid angles: a Fibonacci spiral (González 2010, “Measurement of areas on a sphere”).
 *
 * @example
 * sphereSamples(4096).length; // 4096 unit vectors
 */
export function sphereSamples(count: number): Direction[] {
  const golden = Math.PI * (3 - Math.sqrt(5));
  return Array.from({ length: count }, (_, i) => {
    const y = 1 - (2 * (i + 0.5)) / count;
    const radius = Math.sqrt(1 - y * y);
    return [radius * Math.cos(golden * i), y, radius * Math.sin(golden * i)];
  });
}

/**
 * The pose of a camera that looks in a direction and is held upright. Column-major 4×4.
 *
 * @example
 * uprightPose([0, 0, -1]); // the identity
 */
export function uprightPose([x, y, z]: Direction): Float32Array {
  const level = Math.hypot(x, z);
  // Straight up or down there is no upright: the upper edge is that of a camera that turned there from −z.
  const [rightX, rightZ] = level < 1e-4 ? [1, 0] : [-z / level, x / level];
  // up = back × right, with back = −forward.
  const up = [-y * rightZ, x * rightZ - z * rightX, y * rightX];
  return new Float32Array([rightX, 0, rightZ, 0, ...up, 0, -x, -y, -z, 0, 0, 0, 0, 1]);
}

/**
 * The direction with a heading and an elevation.
 *
 * @param headingRad Angle to the right of −z.
 */
function directionOf(headingRad: number, elevationRad: number): Direction {
  const level = Math.cos(elevationRad);
  return [Math.sin(headingRad) * level, Math.sin(elevationRad), -Math.cos(headingRad) * level];
}

const scratchPoint: ShotPoint = { x: 0, y: 0 };

function shows(shot: ShotPose, [x, y, z]: Direction): boolean {
  return projectDirection(scratchPoint, shot, x, y, z);
}

/** Returns the projection of a lens whose field of view is smaller by `AIM_RAD` at each edge. */
function narrowed(clipFromView: Float32Array): Float32Array {
  const lens = clipFromView.slice();
  for (const i of [0, 5]) {
    const half = Math.atan(1 / (lens[i] ?? 1));
    lens[i] = 1 / Math.tan(Math.max(half - AIM_RAD, half / 2));
  }
  return lens;
}
