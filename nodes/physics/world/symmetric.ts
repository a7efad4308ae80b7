import type { Quaternion } from 'cannon-es';

/** A symmetric 3×3 matrix, such as an inertia tensor. */
export interface Symmetric {
  xx: number;
  xy: number;
  xz: number;
  yy: number;
  yz: number;
  zz: number;
}

export function symmetric(xx = 0, yy = 0, zz = 0): Symmetric {
  return { xx, xy: 0, xz: 0, yy, yz: 0, zz };
}

/** Adds `from` times a factor to `to`. */
export function addScaled(to: Symmetric, from: Symmetric, factor: number): void {
  to.xx += from.xx * factor;
  to.xy += from.xy * factor;
  to.xz += from.xz * factor;
  to.yy += from.yy * factor;
  to.yz += from.yz * factor;
  to.zz += from.zz * factor;
}

/** The inverse; zero for a matrix without one. */
export function invert(m: Symmetric): Symmetric {
  const a = m.yy * m.zz - m.yz * m.yz;
  const b = m.xz * m.yz - m.xy * m.zz;
  const c = m.xy * m.yz - m.xz * m.yy;
  const determinant = m.xx * a + m.xy * b + m.xz * c;
  if (!(determinant > 0) || !Number.isFinite(determinant)) return symmetric();
  return {
    xx: a / determinant,
    xy: b / determinant,
    xz: c / determinant,
    yy: (m.xx * m.zz - m.xz * m.xz) / determinant,
    yz: (m.xy * m.xz - m.xx * m.yz) / determinant,
    zz: (m.xx * m.yy - m.xy * m.xy) / determinant,
  };
}

/** Writes R·m·Rᵀ: converts a tensor from the axes of a body to world axes. */
export function rotate(m: Symmetric, { x, y, z, w }: Quaternion, out: Symmetric): void {
  const r00 = 1 - 2 * (y * y + z * z);
  const r01 = 2 * (x * y - z * w);
  const r02 = 2 * (x * z + y * w);
  const r10 = 2 * (x * y + z * w);
  const r11 = 1 - 2 * (x * x + z * z);
  const r12 = 2 * (y * z - x * w);
  const r20 = 2 * (x * z - y * w);
  const r21 = 2 * (y * z + x * w);
  const r22 = 1 - 2 * (x * x + y * y);
  const a0 = r00 * m.xx + r01 * m.xy + r02 * m.xz;
  const a1 = r00 * m.xy + r01 * m.yy + r02 * m.yz;
  const a2 = r00 * m.xz + r01 * m.yz + r02 * m.zz;
  const b0 = r10 * m.xx + r11 * m.xy + r12 * m.xz;
  const b1 = r10 * m.xy + r11 * m.yy + r12 * m.yz;
  const b2 = r10 * m.xz + r11 * m.yz + r12 * m.zz;
  const c0 = r20 * m.xx + r21 * m.xy + r22 * m.xz;
  const c1 = r20 * m.xy + r21 * m.yy + r22 * m.yz;
  const c2 = r20 * m.xz + r21 * m.yz + r22 * m.zz;
  out.xx = a0 * r00 + a1 * r01 + a2 * r02;
  out.xy = a0 * r10 + a1 * r11 + a2 * r12;
  out.xz = a0 * r20 + a1 * r21 + a2 * r22;
  out.yy = b0 * r10 + b1 * r11 + b2 * r12;
  out.yz = b0 * r20 + b1 * r21 + b2 * r22;
  out.zz = c0 * r20 + c1 * r21 + c2 * r22;
}
