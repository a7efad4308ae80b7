import type { DepthFrame } from '../../kit/physics.ts';

/** The greatest distance of the neighboring texels that are compared. */
const MAX_REACH_PX = 8;
/** Neighboring texels whose depth differs by more than this many voxel edges belong to different things. */
const BORDER_EDGES = 4;

/**
 * Writes the normal of the measured surface at a texel, world space, unit, towards the camera: It is computed from neighbors that are about
 * a voxel edge apart, because differences of adjacent texels are noise. Without such neighbors the normal points at the camera.
 */
export function writeNormal(frame: DepthFrame, i: number, j: number, edgeM: number, out: Float64Array): void {
  const { meters, widthPx, heightPx, worldFromDepth: m, rayFromTexel: r } = frame;
  const [r0, r1, r2, r3, r4, r5] = [r[0] ?? 0, r[1] ?? 0, r[2] ?? 0, r[3] ?? 0, r[4] ?? 0, r[5] ?? 0];
  const d = meters[j * widthPx + i] ?? 0;
  const spacingM = d * Math.sqrt(Math.abs(r0 * r4 - r1 * r3));
  const reach = Math.min(Math.max(Math.round((0.6 * edgeM) / spacingM), 1), MAX_REACH_PX);
  const most = BORDER_EDGES * edgeM;
  // Depth of a neighbor; that of the texel itself where the neighbor lies beyond a border, so that one side counts alone.
  const left = i >= reach ? (meters[j * widthPx + i - reach] ?? 0) : 0;
  const right = i + reach < widthPx ? (meters[j * widthPx + i + reach] ?? 0) : 0;
  const down = j >= reach ? (meters[(j - reach) * widthPx + i] ?? 0) : 0;
  const up = j + reach < heightPx ? (meters[(j + reach) * widthPx + i] ?? 0) : 0;
  const isLeft = left > 0 && Math.abs(left - d) < most;
  const isRight = right > 0 && Math.abs(right - d) < most;
  const isDown = down > 0 && Math.abs(down - d) < most;
  const isUp = up > 0 && Math.abs(up - d) < most;
  let nx = -(r0 * i + r1 * j + r2);
  let ny = -(r3 * i + r4 * j + r5);
  let nz = 1;
  const [tx, ty] = [nx, ny];
  if ((isLeft || isRight) && (isDown || isUp)) {
    const i0 = isLeft ? i - reach : i;
    const i1 = isRight ? i + reach : i;
    const d0 = isLeft ? left : d;
    const d1 = isRight ? right : d;
    const j0 = isDown ? j - reach : j;
    const j1 = isUp ? j + reach : j;
    const e0 = isDown ? down : d;
    const e1 = isUp ? up : d;
    const ax = (r0 * i1 + r1 * j + r2) * d1 - (r0 * i0 + r1 * j + r2) * d0;
    const ay = (r3 * i1 + r4 * j + r5) * d1 - (r3 * i0 + r4 * j + r5) * d0;
    const az = d0 - d1;
    const bx = (r0 * i + r1 * j1 + r2) * e1 - (r0 * i + r1 * j0 + r2) * e0;
    const by = (r3 * i + r4 * j1 + r5) * e1 - (r3 * i + r4 * j0 + r5) * e0;
    const bz = e0 - e1;
    const cx = ay * bz - az * by;
    const cy = az * bx - ax * bz;
    const cz = ax * by - ay * bx;
    const sign = cx * tx + cy * ty + cz < 0 ? -1 : 1;
    if (cx * cx + cy * cy + cz * cz > 0) {
      nx = sign * cx;
      ny = sign * cy;
      nz = sign * cz;
    }
  }
  const length = Math.sqrt(nx * nx + ny * ny + nz * nz);
  const [x, y, z] = [nx / length, ny / length, nz / length];
  out[0] = (m[0] ?? 0) * x + (m[4] ?? 0) * y + (m[8] ?? 0) * z;
  out[1] = (m[1] ?? 0) * x + (m[5] ?? 0) * y + (m[9] ?? 0) * z;
  out[2] = (m[2] ?? 0) * x + (m[6] ?? 0) * y + (m[10] ?? 0) * z;
}
