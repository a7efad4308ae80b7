import type { BodyShape, Triple } from '../../kit/physics.ts';
import { addScaled, type Symmetric, symmetric } from './symmetric.ts';

export interface MassProperties {
  readonly massKg: number;
  readonly centerM: Triple;
  /** Inertia tensor about the center of mass, in the axes of the body. */
  readonly inertia: Symmetric;
}

interface Part {
  readonly volume: number;
  readonly center: Triple;
  /** Second moments about the center of the part, for a density of 1. */
  readonly inertia: Symmetric;
}

const NOTHING: MassProperties = { massKg: 0, centerM: [0, 0, 0], inertia: symmetric() };

/**
 * Computes mass, center of mass and inertia of solid shapes of equal density. Parts that overlap count twice. Polyhedra are computed
 * exactly, as sums of tetrahedra (Tonon, “Explicit Exact Formulas for the 3-D Tetrahedron Inertia Tensor”, 2004).
 *
 * @param massKg The total mass; 0: the mass follows from the density.
 */
export function massProperties(shapes: readonly BodyShape[], massKg: number, densityKgPerM3: number): MassProperties {
  const parts = shapes.flatMap((shape) => partOf(shape) ?? []);
  const volume = parts.reduce((sum, part) => sum + part.volume, 0);
  if (!(volume > 0)) return NOTHING;
  const mean = (axis: 0 | 1 | 2) => parts.reduce((sum, part) => sum + part.center[axis] * part.volume, 0) / volume;
  const centerM: Triple = [mean(0), mean(1), mean(2)];
  const total = massKg > 0 ? massKg : volume * densityKgPerM3;
  const inertia = symmetric();
  for (const { volume: v, center, inertia: own } of parts) {
    addScaled(inertia, own, 1);
    const x = center[0] - centerM[0];
    const y = center[1] - centerM[1];
    const z = center[2] - centerM[2];
    const offset = { xx: y * y + z * z, xy: -x * y, xz: -x * z, yy: x * x + z * z, yz: -y * z, zz: x * x + y * y };
    addScaled(inertia, offset, v);
  }
  const scaled = symmetric();
  addScaled(scaled, inertia, total / volume);
  return { massKg: total, centerM, inertia: scaled };
}

function partOf(shape: BodyShape): Part | null {
  switch (shape.kind) {
    case 'sphere': {
      const volume = (4 / 3) * Math.PI * shape.radiusM ** 3;
      const moment = 0.4 * volume * shape.radiusM ** 2;
      return { volume, center: shape.centerM, inertia: symmetric(moment, moment, moment) };
    }
    case 'hull':
      return partOfHull(shape.verticesM, shape.faces);
    case 'plane':
    case 'mesh':
      return null;
  }
}

function partOfHull(vertices: readonly Triple[], faces: readonly (readonly number[])[]): Part | null {
  const first = vertices[0];
  if (!first) return null;
  let volume = 0;
  let sx = 0;
  let sy = 0;
  let sz = 0;
  // Second moments ∫ x² and ∫ x·y about the first vertex, where numbers are small.
  let pxx = 0;
  let pyy = 0;
  let pzz = 0;
  let pxy = 0;
  let pxz = 0;
  let pyz = 0;
  for (const face of faces) {
    const a = vertices[face[0] ?? 0] ?? first;
    for (let i = 1; i + 1 < face.length; i++) {
      const b = vertices[face[i] ?? 0] ?? first;
      const c = vertices[face[i + 1] ?? 0] ?? first;
      const [ax, ay, az] = [a[0] - first[0], a[1] - first[1], a[2] - first[2]];
      const [bx, by, bz] = [b[0] - first[0], b[1] - first[1], b[2] - first[2]];
      const [cx, cy, cz] = [c[0] - first[0], c[1] - first[1], c[2] - first[2]];
      const v = (ax * (by * cz - bz * cy) + ay * (bz * cx - bx * cz) + az * (bx * cy - by * cx)) / 6;
      volume += v;
      sx += (v * (ax + bx + cx)) / 4;
      sy += (v * (ay + by + cy)) / 4;
      sz += (v * (az + bz + cz)) / 4;
      pxx += (v * (ax * ax + bx * bx + cx * cx + ax * bx + ax * cx + bx * cx)) / 10;
      pyy += (v * (ay * ay + by * by + cy * cy + ay * by + ay * cy + by * cy)) / 10;
      pzz += (v * (az * az + bz * bz + cz * cz + az * bz + az * cz + bz * cz)) / 10;
      pxy += (v * (2 * (ax * ay + bx * by + cx * cy) + ax * by + ay * bx + ax * cy + ay * cx + bx * cy + by * cx)) / 20;
      pxz += (v * (2 * (ax * az + bx * bz + cx * cz) + ax * bz + az * bx + ax * cz + az * cx + bx * cz + bz * cx)) / 20;
      pyz += (v * (2 * (ay * az + by * bz + cy * cz) + ay * bz + az * by + ay * cz + az * cy + by * cz + bz * cy)) / 20;
    }
  }
  if (!(volume > 0)) return null;
  const x = sx / volume;
  const y = sy / volume;
  const z = sz / volume;
  const xx = pxx - volume * x * x;
  const yy = pyy - volume * y * y;
  const zz = pzz - volume * z * z;
  return {
    volume,
    center: [x + first[0], y + first[1], z + first[2]],
    inertia: {
      xx: yy + zz,
      xy: -(pxy - volume * x * y),
      xz: -(pxz - volume * x * z),
      yy: xx + zz,
      yz: -(pyz - volume * y * z),
      zz: xx + yy,
    },
  };
}
