import type { SurfacePoint } from './depth-image.ts';
import { add, cross, dot, normalize, scale, subtract, type Vector } from './vector.ts';

/** The floor: points p with dot(normal, p) = offset; the normal points up. */
export interface Floor {
  readonly normal: Vector;
  readonly offset: number;
  /** Points on the floor. */
  readonly points: readonly Vector[];
}

/** Cosine of the largest tilt at which people hold a camera for long. */
const MAX_TILT = Math.cos((40 * Math.PI) / 180);
/** Cosine of the largest angle between normals of one plane, which are computed from depth in whole millimeters. */
const SAME_DIRECTION = Math.cos((6 * Math.PI) / 180);
const CANDIDATES = 400;
const BIN_M = 0.02;
/** A level is the floor if it has this fraction of the points of the largest level. */
const FLOOR_SHARE = 0.12;
const NEAR_PLANE_M = 0.025;

/**
 * Finds the floor among surface points of all frames:
 * 1. The up direction: the one that most surfaces face, among those within `MAX_TILT` of `upGuess`. Floor, tables and seats face it.
 * Normals of random points are tried.
 * 2. The lowest level that has enough points with this normal.
 * 3. A plane through the points of that level, by least squares, fitted three times to the points near it.
 *
 * @param upGuess Mean up vector of the cameras.
 * @param random Uniform in [0, 1).
 * @returns Null if no surface faces up.
 */
export function findFloor(surface: readonly SurfacePoint[], upGuess: Vector, random: () => number): Floor | null {
  const upright = surface.filter(({ normal }) => dot(normal, upGuess) > MAX_TILT);
  const up = dominantDirection(upright, random);
  if (!up) return null;
  const level = upright.filter(({ normal }) => dot(normal, up) > SAME_DIRECTION).map(({ point }) => point);
  const height = lowestLevel(level.map((point) => dot(point, up)));
  if (height === null) return null;
  let floor: Floor = { normal: up, offset: height, points: [] };
  for (let pass = 0; pass < 3; pass++) {
    const { normal, offset } = floor;
    const points = level.filter((point) => Math.abs(dot(point, normal) - offset) < NEAR_PLANE_M);
    if (points.length < 3) return null;
    floor = fitPlane(points, normal);
  }
  return floor;
}

/** Mean of the largest cluster of normals; null without points. */
function dominantDirection(points: readonly SurfacePoint[], random: () => number): Vector | null {
  let best: Vector | null = null;
  let most = 0;
  for (let i = 0; i < CANDIDATES; i++) {
    const candidate = points[Math.floor(random() * points.length)]?.normal;
    if (!candidate) return null;
    const count = points.reduce((sum, { normal }) => sum + (dot(normal, candidate) > SAME_DIRECTION ? 1 : 0), 0);
    if (count <= most) continue;
    most = count;
    best = candidate;
  }
  if (!best) return null;
  const bundle = points.filter(({ normal }) => best && dot(normal, best) > SAME_DIRECTION);
  return normalize(bundle.reduce<Vector>((sum, { normal }) => add(sum, normal), [0, 0, 0]));
}

function lowestLevel(heights: readonly number[]): number | null {
  const bins = new Map<number, number>();
  for (const height of heights) {
    const bin = Math.round(height / BIN_M);
    bins.set(bin, (bins.get(bin) ?? 0) + 1);
  }
  // Sums three bins, so that a level between two bins is not split.
  const around = (bin: number): number => (bins.get(bin - 1) ?? 0) + (bins.get(bin) ?? 0) + (bins.get(bin + 1) ?? 0);
  const levels = [...bins.keys()].sort((a, b) => a - b);
  const most = Math.max(0, ...levels.map(around));
  const enough = levels.filter((bin) => around(bin) >= FLOOR_SHARE * most);
  const [lowest] = enough;
  if (lowest === undefined) return null;
  // Chooses the fullest of the lowest bins, because the lowest may be the edge of the next one.
  const nearby = enough.filter((bin) => bin <= lowest + 3);
  return nearby.reduce((a, b) => (around(b) > around(a) ? b : a)) * BIN_M;
}

/** Least-squares fit of heights over the plane perpendicular to `up`. Valid if the floor is nearly perpendicular to it. */
function fitPlane(points: readonly Vector[], up: Vector): Floor {
  const across = normalize(cross(up, Math.abs(up[0]) < 0.9 ? [1, 0, 0] : [0, 0, 1]));
  const along = cross(up, across);
  const center = scale(
    points.reduce((sum, point) => add(sum, point), [0, 0, 0] as Vector),
    1 / points.length,
  );
  let [uu, uv, vv, uh, vh] = [0, 0, 0, 0, 0];
  for (const point of points) {
    const off = subtract(point, center);
    const [u, v, h] = [dot(off, across), dot(off, along), dot(off, up)];
    uu += u * u;
    uv += u * v;
    vv += v * v;
    uh += u * h;
    vh += v * h;
  }
  const determinant = uu * vv - uv * uv || 1;
  const slopeU = (uh * vv - vh * uv) / determinant;
  const slopeV = (vh * uu - uh * uv) / determinant;
  const normal = normalize(subtract(subtract(up, scale(across, slopeU)), scale(along, slopeV)));
  return { normal, offset: dot(center, normal), points };
}
