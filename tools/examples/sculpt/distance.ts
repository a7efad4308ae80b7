export type Vector = readonly [x: number, y: number, z: number];

/** Signed distance from a surface in meters, negative inside. It may be approximate away from the surface. */
export type Distance = (x: number, y: number, z: number) => number;

/** Distance from an ellipsoid; exact at its surface only. I. Quilez, Ellipsoid SDF. */
export function ellipsoid(center: Vector, radii: Vector): Distance {
  const [cx, cy, cz] = center;
  const [rx, ry, rz] = radii;
  return (x, y, z) => {
    const [dx, dy, dz] = [(x - cx) / rx, (y - cy) / ry, (z - cz) / rz];
    const length = Math.hypot(dx, dy, dz);
    const slope = Math.hypot(dx / rx, dy / ry, dz / rz);
    return slope < 1e-9 ? -Math.min(rx, ry, rz) : (length * (length - 1)) / slope;
  };
}

/** Distance from a limb: a chain of points with radii, between which the radius is linear. */
export function limb(points: readonly (readonly [x: number, y: number, z: number, radius: number])[]): Distance {
  return (x, y, z) => {
    let least = Number.POSITIVE_INFINITY;
    for (let i = 1; i < points.length; i++) {
      const [ax = 0, ay = 0, az = 0, ar = 0] = points[i - 1] ?? [];
      const [bx = 0, by = 0, bz = 0, br = 0] = points[i] ?? [];
      const [ex, ey, ez] = [bx - ax, by - ay, bz - az];
      const along = Math.min(Math.max(((x - ax) * ex + (y - ay) * ey + (z - az) * ez) / (ex * ex + ey * ey + ez * ez), 0), 1);
      least = Math.min(least, Math.hypot(x - ax - along * ex, y - ay - along * ey, z - az - along * ez) - ar - (br - ar) * along);
    }
    return least;
  };
}

/** A union whose seam is rounded over `radiusM`. I. Quilez, Smooth minimum (quadratic polynomial). */
export function blend(radiusM: number, ...parts: readonly Distance[]): Distance {
  return (x, y, z) => parts.reduce((before, part) => smoothMin(before, part(x, y, z), radiusM), 1e3);
}

/** `body` without `hole`; the rim is rounded over `radiusM`. */
export function carve(radiusM: number, body: Distance, hole: Distance): Distance {
  return (x, y, z) => -smoothMin(-body(x, y, z), hole(x, y, z), radiusM);
}

/** Both halves of what is modeled at x > 0. */
export function mirrored(half: Distance): Distance {
  return (x, y, z) => half(Math.abs(x), y, z);
}

/** Rotated about the vertical axis through `pivot`, then about the axis along x; angles in radians. */
export function turned(pivot: Vector, yawRad: number, pitchRad: number, part: Distance): Distance {
  const [cy, sy, cp, sp] = [Math.cos(yawRad), Math.sin(yawRad), Math.cos(pitchRad), Math.sin(pitchRad)];
  const [px, py, pz] = pivot;
  return (x, y, z) => {
    const [dx, dy, dz] = [x - px, y - py, z - pz];
    const [ux, uz] = [cy * dx - sy * dz, sy * dx + cy * dz];
    return part(px + ux, py + cp * dy + sp * uz, pz - sp * dy + cp * uz);
  };
}

function smoothMin(a: number, b: number, radius: number): number {
  const share = Math.max(radius - Math.abs(a - b), 0) / radius;
  return Math.min(a, b) - share * share * radius * 0.25;
}
