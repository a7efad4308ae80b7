import type { CaptureMesh } from '../../../nodes/kit/capture.ts';
import type { DepthMesh } from './depth-mesh.ts';
import type { DepthRays } from './depth-rays.ts';

/** The points of a depth mesh in the axes of its camera, which looks along −z with y up. */
export function pointsOfDepthMesh({ places, depths, indices }: Omit<DepthMesh, 'tolerance'>, rays: DepthRays): CaptureMesh {
  const { across, ahead, level, down, heightPx } = rays;
  const positions = new Float32Array(3 * depths.length);
  depths.forEach((depth, i) => {
    const column = ((places[2 * i] ?? 0) - 1) / 2;
    const y = places[2 * i + 1] ?? 0;
    if (y === 0 || y === 2 * heightPx) {
      positions[3 * i + 1] = y === 0 ? depth : -depth;
      return;
    }
    const row = (y - 1) / 2;
    const outward = (level[row] ?? 0) * depth;
    positions[3 * i] = (across[column] ?? 0) * outward;
    positions[3 * i + 1] = -(down[row] ?? 0) * depth;
    positions[3 * i + 2] = -(ahead[column] ?? 0) * outward;
  });
  return { positions, indices: Uint32Array.from(indices) };
}
