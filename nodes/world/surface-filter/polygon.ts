/** Polygons as alternating x and z, meters, like `DetectedPlane.outlineXZ`. */

/** Twice the area, negative if the corners turn clockwise as seen along -y with x to the right and z down. */
function twiceArea(xz: ArrayLike<number>): number {
  let sum = 0;
  const count = xz.length;
  for (let i = 0; i + 1 < count; i += 2) {
    const j = (i + 2) % count;
    sum += (xz[i] ?? 0) * (xz[j + 1] ?? 0) - (xz[j] ?? 0) * (xz[i + 1] ?? 0);
  }
  return sum;
}

export function areaOf(xz: ArrayLike<number>): number {
  return Math.abs(twiceArea(xz)) / 2;
}

/** Writes the centroid of the area, or the mean of the corners if the area is 0. */
export function writeCentroid(out: Float64Array, xz: ArrayLike<number>): void {
  const twice = twiceArea(xz);
  const count = xz.length;
  let x = 0;
  let z = 0;
  for (let i = 0; i + 1 < count; i += 2) {
    const j = (i + 2) % count;
    const weight = twice === 0 ? 1 : (xz[i] ?? 0) * (xz[j + 1] ?? 0) - (xz[j] ?? 0) * (xz[i + 1] ?? 0);
    x += weight * (twice === 0 ? (xz[i] ?? 0) : (xz[i] ?? 0) + (xz[j] ?? 0));
    z += weight * (twice === 0 ? (xz[i + 1] ?? 0) : (xz[i + 1] ?? 0) + (xz[j + 1] ?? 0));
  }
  const share = twice === 0 ? 2 / count : 1 / (3 * twice);
  out[0] = x * share;
  out[1] = z * share;
}

/** The length of the polygon along a direction of length 1. */
export function extentAlong(xz: ArrayLike<number>, dx: number, dz: number): number {
  let least = Number.POSITIVE_INFINITY;
  let greatest = Number.NEGATIVE_INFINITY;
  for (let i = 0; i + 1 < xz.length; i += 2) {
    const along = (xz[i] ?? 0) * dx + (xz[i + 1] ?? 0) * dz;
    least = Math.min(least, along);
    greatest = Math.max(greatest, along);
  }
  return greatest - least;
}

/**
 * The direction of the smallest rectangle around the polygon, which shares a side with the polygon's convex hull, as an angle from x
 * towards z.
 */
export function sideAngleRad(xz: ArrayLike<number>): number {
  const hull = convexHull(xz);
  let bestRad = 0;
  let bestArea = Number.POSITIVE_INFINITY;
  for (let i = 0; i < hull.length; i += 2) {
    const j = (i + 2) % hull.length;
    const rad = Math.atan2((hull[j + 1] ?? 0) - (hull[i + 1] ?? 0), (hull[j] ?? 0) - (hull[i] ?? 0));
    const area = extentAlong(hull, Math.cos(rad), Math.sin(rad)) * extentAlong(hull, -Math.sin(rad), Math.cos(rad));
    // Of equal ones the first, so that rounding does not turn squares.
    if (area >= bestArea * (1 - 1e-6)) continue;
    bestArea = area;
    bestRad = rad;
  }
  return bestRad;
}

/** The convex hull of points, by Andrew's monotone chain (1979). */
export function convexHull(xz: ArrayLike<number>): Float32Array {
  const points = Array.from({ length: Math.floor(xz.length / 2) }, (_, i): readonly [number, number] => [
    xz[2 * i] ?? 0,
    xz[2 * i + 1] ?? 0,
  ]);
  points.sort((a, b) => a[0] - b[0] || a[1] - b[1]);
  const half = (sorted: readonly (readonly [number, number])[]): (readonly [number, number])[] => {
    const chain: (readonly [number, number])[] = [];
    for (const point of sorted) {
      for (;;) {
        const [a, b] = [chain.at(-2), chain.at(-1)];
        if (!a || !b || (b[0] - a[0]) * (point[1] - a[1]) - (b[1] - a[1]) * (point[0] - a[0]) > 0) break;
        chain.pop();
      }
      chain.push(point);
    }
    chain.pop();
    return chain;
  };
  return Float32Array.from([...half(points), ...half([...points].reverse())].flat());
}

/** The distance from a point in the polygon's plane to the polygon; 0 inside. */
export function distanceTo(xz: ArrayLike<number>, x: number, z: number): number {
  let inside = false;
  let least = Number.POSITIVE_INFINITY;
  const count = xz.length;
  for (let i = 0; i + 1 < count; i += 2) {
    const j = (i + 2) % count;
    const ax = xz[i] ?? 0;
    const az = xz[i + 1] ?? 0;
    const ex = (xz[j] ?? 0) - ax;
    const ez = (xz[j + 1] ?? 0) - az;
    if (az > z !== az + ez > z && x < ax + ((z - az) / ez) * ex) inside = !inside;
    const along = Math.min(Math.max(((x - ax) * ex + (z - az) * ez) / (ex * ex + ez * ez || 1), 0), 1);
    least = Math.min(least, Math.hypot(x - ax - along * ex, z - az - along * ez));
  }
  return inside ? 0 : least;
}
