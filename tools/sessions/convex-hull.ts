export type Point2 = readonly [x: number, z: number];

/** Convex hull of points, counter-clockwise in (x, z) (Andrew’s monotone chain). */
export function convexHull(points: readonly Point2[]): Point2[] {
  const sorted = [...points].sort((a, b) => a[0] - b[0] || a[1] - b[1]);
  const lower = chain(sorted);
  const upper = chain(sorted.reverse());
  return [...lower.slice(0, -1), ...upper.slice(0, -1)];
}

function chain(points: readonly Point2[]): Point2[] {
  const out: Point2[] = [];
  for (const point of points) {
    for (;;) {
      const [a, b] = [out.at(-2), out.at(-1)];
      if (!a || !b || (b[0] - a[0]) * (point[1] - a[1]) - (b[1] - a[1]) * (point[0] - a[0]) > 0) break;
      out.pop();
    }
    out.push(point);
  }
  return out;
}

/** Removes corners within `toleranceM` of the line between their neighbors. */
export function simplifyPolygon(corners: readonly Point2[], toleranceM: number): Point2[] {
  const kept = [...corners];
  for (let i = 0; i < kept.length && kept.length > 3; ) {
    const [a, b, c] = [kept[(i + kept.length - 1) % kept.length], kept[i], kept[(i + 1) % kept.length]];
    if (a && b && c && distanceToLine(b, a, c) < toleranceM) kept.splice(i, 1);
    else i++;
  }
  return kept;
}

function distanceToLine(p: Point2, a: Point2, b: Point2): number {
  const [dx, dz] = [b[0] - a[0], b[1] - a[1]];
  const length = Math.hypot(dx, dz);
  return length === 0 ? Math.hypot(p[0] - a[0], p[1] - a[1]) : Math.abs(dx * (p[1] - a[1]) - dz * (p[0] - a[0])) / length;
}
