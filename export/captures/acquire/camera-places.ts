type Vector = readonly [number, number, number];

/** Where the cameras of an acquisition stand. Lengths in meters, in world space. */
export interface CameraPlaces {
  /** `grid`: all look the same way. `inside-out`: on a sphere, looking away from its center. `outside-in`: on a sphere, looking at its center. */
  readonly shape: 'grid' | 'inside-out' | 'outside-in';
  /** Number of cameras along x, y and z (`grid`), or their number as the first entry. */
  readonly counts: Vector;
  readonly centerM: Vector;
  /** Size of the grid, or diameters of the sphere, along x, y and z. */
  readonly extentM: Vector;
  /** Direction of a grid and of 360° photographs, about y, counterclockwise from above; 0 looks along −z. */
  readonly yawRad: number;
  /** The part of the sphere that has cameras: elevations above its center, from -π/2 to π/2. */
  readonly elevationRad: readonly [least: number, most: number];
}

/**
 * The poses of the cameras: column-major 4×4, rigid, y up, looking along −z. Those of a sphere lie on a Fibonacci lattice, which spreads any
 * number of them evenly (González, “Measurement of areas on a sphere using Fibonacci and latitude–longitude lattices”, 2010); on an
 * ellipsoid, its points are stretched.
 *
 * @param around Whether the photographs show all directions: then all cameras are level and have the same yaw.
 */
export function cameraPoses(places: CameraPlaces, around: boolean): readonly (readonly number[])[] {
  const { shape, yawRad } = places;
  const level: Vector = [Math.sin(yawRad), 0, Math.cos(yawRad)];
  if (shape === 'grid') return gridPoints(places).map((point) => poseOf(point, level));
  return spherePoints(places).map((towards) => {
    const point = onEllipsoid(places, towards);
    if (around) return poseOf(point, level);
    const out = unit(subtract(point, places.centerM));
    return poseOf(point, shape === 'outside-in' ? out : [-out[0], -out[1], -out[2]]);
  });
}

function gridPoints({ counts, centerM, extentM }: CameraPlaces): Vector[] {
  const along = (axis: 0 | 1 | 2, i: number): number =>
    centerM[axis] + (counts[axis] === 1 ? 0 : extentM[axis] * (i / (counts[axis] - 1) - 0.5));
  const points: Vector[] = [];
  for (let k = 0; k < counts[2]; k++)
    for (let j = 0; j < counts[1]; j++) for (let i = 0; i < counts[0]; i++) points.push([along(0, i), along(1, j), along(2, k)]);
  return points;
}

const GOLDEN_ANGLE_RAD = Math.PI * (3 - Math.sqrt(5));

function spherePoints({ counts: [count], elevationRad: [least, most] }: CameraPlaces): Vector[] {
  const [bottom, top] = [Math.sin(least), Math.sin(most)];
  return Array.from({ length: count }, (_, i) => {
    const y = top + (bottom - top) * ((i + 0.5) / count);
    const radius = Math.sqrt(Math.max(0, 1 - y * y));
    const azimuth = i * GOLDEN_ANGLE_RAD;
    return [radius * Math.sin(azimuth), y, radius * Math.cos(azimuth)];
  });
}

function onEllipsoid({ centerM, extentM }: CameraPlaces, towards: Vector): Vector {
  return [0, 1, 2].map((axis) => (centerM[axis] ?? 0) + ((towards[axis] ?? 0) * (extentM[axis] ?? 0)) / 2) as unknown as Vector;
}

/** The pose at a point whose z axis is `back`. Straight up or down, the top of the photograph is towards −z. */
function poseOf(point: Vector, back: Vector): readonly number[] {
  const isVertical = Math.abs(back[1]) > 1 - 1e-9;
  const right = unit(cross(isVertical ? [0, 0, -Math.sign(back[1])] : [0, 1, 0], back));
  const up = cross(back, right);
  return [...right, 0, ...up, 0, ...back, 0, ...point, 1];
}

function subtract(a: Vector, b: Vector): Vector {
  return [a[0] - b[0], a[1] - b[1], a[2] - b[2]];
}

function cross(a: Vector, b: Vector): Vector {
  return [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]];
}

function unit(a: Vector): Vector {
  const length = Math.hypot(...a);
  return [a[0] / length, a[1] / length, a[2] / length];
}
