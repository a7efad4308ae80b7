import type { Quaternion, Vec3 } from 'cannon-es';

/** Reads position and rotation of a rigid column-major 4×4 (Shepperd, “Quaternion from Rotation Matrix”, 1978). */
export function readPose(m: ArrayLike<number>, position: Vec3, rotation: Quaternion): void {
  position.set(at(m, 12), at(m, 13), at(m, 14));
  const [m00, m10, m20, m01, m11, m21, m02, m12, m22] = [
    at(m, 0),
    at(m, 1),
    at(m, 2),
    at(m, 4),
    at(m, 5),
    at(m, 6),
    at(m, 8),
    at(m, 9),
    at(m, 10),
  ];
  const trace = m00 + m11 + m22;
  if (trace > 0) {
    const s = 0.5 / Math.sqrt(trace + 1);
    rotation.set((m21 - m12) * s, (m02 - m20) * s, (m10 - m01) * s, 0.25 / s);
  } else if (m00 > m11 && m00 > m22) {
    const s = 2 * Math.sqrt(1 + m00 - m11 - m22);
    rotation.set(0.25 * s, (m01 + m10) / s, (m02 + m20) / s, (m21 - m12) / s);
  } else if (m11 > m22) {
    const s = 2 * Math.sqrt(1 + m11 - m00 - m22);
    rotation.set((m01 + m10) / s, 0.25 * s, (m12 + m21) / s, (m02 - m20) / s);
  } else {
    const s = 2 * Math.sqrt(1 + m22 - m00 - m11);
    rotation.set((m02 + m20) / s, (m12 + m21) / s, 0.25 * s, (m10 - m01) / s);
  }
  rotation.normalize();
}

function at(list: ArrayLike<number>, index: number): number {
  return list[index] ?? 0;
}
