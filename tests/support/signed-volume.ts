import type { BufferGeometry } from 'three';

/**
 * The volume of a closed mesh by the divergence theorem: the sum of the tetrahedra from the origin to each triangle. It is positive if
 * faces point outward, and smaller by twice the part of each face that points inward.
 */
export function signedVolumeM3(geometry: BufferGeometry): number {
  const positions = geometry.getAttribute('position');
  const index = geometry.getIndex();
  const count = index?.count ?? positions.count;
  const corner = (i: number) => {
    const vertex = index?.getX(i) ?? i;
    return [positions.getX(vertex), positions.getY(vertex), positions.getZ(vertex)] as const;
  };
  let volume = 0;
  for (let i = 0; i < count; i += 3) {
    const [ax, ay, az] = corner(i);
    const [bx, by, bz] = corner(i + 1);
    const [cx, cy, cz] = corner(i + 2);
    volume += (ax * (by * cz - bz * cy) + ay * (bz * cx - bx * cz) + az * (bx * cy - by * cx)) / 6;
  }
  return volume;
}
