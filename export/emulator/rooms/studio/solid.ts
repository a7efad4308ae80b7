import { hash } from './noise.ts';

/** Geometry for light baking: the shell of the room, seen from inside, and boxes rotated about the y axis. */
export interface Solid {
  readonly center: Triple;
  readonly half: Triple;
  readonly yawRad: number;
  /** Linear-sRGB. */
  readonly albedo: Triple;
}

export type Triple = readonly [number, number, number];

/** Where a ray hits a solid. */
export interface Meeting {
  distanceM: number;
  /** Index of the solid. */
  solid: number;
  /** Axis and side of the face in the solid's local space: 0 to 5 for −x, +x, −y, +y, −z, +z. */
  face: number;
}

export interface SolidScene {
  readonly solids: readonly Solid[];
  /** Finds the first hit; solids that contain the origin are ignored. */
  cast(ox: number, oy: number, oz: number, dx: number, dy: number, dz: number, out: Meeting): void;
  /** Whether a solid is within `maxM` along the ray. */
  blocked(ox: number, oy: number, oz: number, dx: number, dy: number, dz: number, maxM: number): boolean;
}

/** Numbers per box in the table: center, half size, sine and cosine of the yaw. The table is flat because millions of rays read it. */
const STRIDE = 8;

/**
 * Creates a scene that casts rays against solids.
 *
 * @param solids The first is the shell, a box that is hit from inside and is not rotated.
 */
export function createSolidScene(solids: readonly Solid[]): SolidScene {
  const shell = solids[0];
  if (!shell) throw new Error('The scene has no shell.');
  const table = new Float64Array((solids.length - 1) * STRIDE);
  solids.slice(1).forEach(({ center, half, yawRad }, i) => {
    table.set([...center, ...half, Math.sin(yawRad), Math.cos(yawRad)], i * STRIDE);
  });
  const walk = (ox: number, oy: number, oz: number, dx: number, dy: number, dz: number, maxM: number, out: Meeting | null): boolean => {
    let nearest = maxM;
    let found = false;
    for (let at = 0; at < table.length; at += STRIDE) {
      const px = ox - read(table, at);
      const py = oy - read(table, at + 1);
      const pz = oz - read(table, at + 2);
      const sin = read(table, at + 6);
      const cos = read(table, at + 7);
      const lx = px * cos - pz * sin;
      const lz = px * sin + pz * cos;
      // Division by zero gives infinities, which the comparisons handle.
      const ix = 1 / (dx * cos - dz * sin);
      const iy = 1 / dy;
      const iz = 1 / (dx * sin + dz * cos);
      const hx = read(table, at + 3) * Math.abs(ix);
      const hy = read(table, at + 4) * Math.abs(iy);
      const hz = read(table, at + 5) * Math.abs(iz);
      const nearX = -lx * ix - hx;
      const nearY = -py * iy - hy;
      const nearZ = -lz * iz - hz;
      const enter = Math.max(nearX, nearY, nearZ);
      if (!(enter >= 0 && enter < nearest)) continue;
      if (enter >= Math.min(-lx * ix + hx, -py * iy + hy, -lz * iz + hz)) continue;
      if (!out) return true;
      nearest = enter;
      found = true;
      out.distanceM = enter;
      out.solid = at / STRIDE + 1;
      if (enter === nearX) out.face = ix > 0 ? 0 : 1;
      else if (enter === nearY) out.face = iy > 0 ? 2 : 3;
      else out.face = iz > 0 ? 4 : 5;
    }
    return found;
  };
  return {
    solids,
    cast: (ox, oy, oz, dx, dy, dz, out) => {
      if (!walk(ox, oy, oz, dx, dy, dz, Number.POSITIVE_INFINITY, out)) meetShell(shell, ox, oy, oz, dx, dy, dz, out);
    },
    blocked: (ox, oy, oz, dx, dy, dz, maxM) => walk(ox, oy, oz, dx, dy, dz, maxM, null),
  };
}

function read(table: Float64Array, index: number): number {
  return table[index] as number;
}

function meetShell({ center, half }: Solid, ox: number, oy: number, oz: number, dx: number, dy: number, dz: number, out: Meeting): void {
  const farX = (center[0] + Math.sign(dx) * half[0] - ox) / dx;
  const farY = (center[1] + Math.sign(dy) * half[1] - oy) / dy;
  const farZ = (center[2] + Math.sign(dz) * half[2] - oz) / dz;
  // NaN if the ray is parallel to the wall.
  const [x, y, z] = [farX, farY, farZ].map((far) => (Number.isNaN(far) ? Number.POSITIVE_INFINITY : far)) as [number, number, number];
  out.distanceM = Math.min(x, y, z);
  out.solid = 0;
  if (out.distanceM === x) out.face = dx > 0 ? 1 : 0;
  else if (out.distanceM === y) out.face = dy > 0 ? 3 : 2;
  else out.face = dz > 0 ? 5 : 4;
}

/** Cosine-weighted directions around +z. They are the same for every point, so light changes smoothly. */
export function cosineDirections(count: number): readonly Triple[] {
  return Array.from({ length: count }, (_, i) => {
    const u = (i + 0.5) / count;
    const angle = 2 * Math.PI * ((i * 0.618033988749895 + hash(0, 0, 5)) % 1);
    const radius = Math.sqrt(u);
    return [radius * Math.cos(angle), radius * Math.sin(angle), Math.sqrt(1 - u)] as const;
  });
}
