import type { DepthFrame } from '../../../nodes/kit/physics.ts';
import { createVoxelGrid } from '../../../nodes/physics/world/voxel-grid.ts';

/** The space around the camera that a dense grid covers, meters. */
const SIZE_M = [6.4, 3.2, 6.4] as const;

export interface MeasuredGrid {
  update(frame: DepthFrame): void;
  /** Voxels that the last update has read or written. */
  readonly touched: number;
}

/** The grid of the physics room. */
export function createSparseGrid(edgeM: number, speed: number): MeasuredGrid {
  return createVoxelGrid({ edgeM, threshold: 0.5, speed, farM: 5 });
}

/** Equation 1 of the mixed-reality paper as it stands: V' = V · (1 − U) + U · H of every voxel of a box, in each depth frame. */
export function createDenseGrid(edgeM: number, speed: number): MeasuredGrid {
  const [nx, ny, nz] = SIZE_M.map((m) => Math.round(m / edgeM)) as [number, number, number];
  const weights = new Float32Array(nx * ny * nz);
  const hits = new Uint8Array(nx * ny * nz);
  return {
    update: ({ meters, widthPx, heightPx, worldFromDepth: m, rayFromTexel: r }) => {
      const at = (list: ArrayLike<number>, i: number) => list[i] ?? 0;
      hits.fill(0);
      for (let j = 0; j < heightPx; j++) {
        for (let i = 0; i < widthPx; i++) {
          const d = meters[j * widthPx + i] ?? 0;
          if (d <= 0) continue;
          const x = (at(r, 0) * i + at(r, 2)) * d;
          const y = (at(r, 4) * j + at(r, 5)) * d;
          const vx = Math.floor((at(m, 0) * x + at(m, 4) * y - at(m, 8) * d + at(m, 12) + SIZE_M[0] / 2) / edgeM);
          const vy = Math.floor((at(m, 1) * x + at(m, 5) * y - at(m, 9) * d + at(m, 13)) / edgeM);
          const vz = Math.floor((at(m, 2) * x + at(m, 6) * y - at(m, 10) * d + at(m, 14) + SIZE_M[2] / 2) / edgeM);
          if (vx >= 0 && vy >= 0 && vz >= 0 && vx < nx && vy < ny && vz < nz) hits[(vz * ny + vy) * nx + vx] = 1;
        }
      }
      for (let i = 0; i < weights.length; i++) weights[i] = (weights[i] ?? 0) * (1 - speed) + speed * (hits[i] ?? 0);
    },
    get touched() {
      return weights.length;
    },
  };
}

/** What a camera in the middle of a room of 6 × 2.6 × 6 m sees, turned about the vertical. */
export function roomFrame(widthPx: number, heightPx: number, turnRad: number): DepthFrame {
  const tan = Math.tan(Math.PI / 6);
  const texel = (2 * tan) / widthPx;
  const rayFromTexel = [texel, 0, -tan + texel / 2, 0, texel, (-tan * heightPx) / widthPx + texel / 2];
  const [s, c] = [Math.sin(turnRad), Math.cos(turnRad)];
  const eyeM = 1.5;
  const meters = Float32Array.from({ length: widthPx * heightPx }, (_, n) => {
    const x = (rayFromTexel[0] ?? 0) * (n % widthPx) + (rayFromTexel[2] ?? 0);
    const y = (rayFromTexel[4] ?? 0) * Math.floor(n / widthPx) + (rayFromTexel[5] ?? 0);
    const [dx, dz] = [c * x - s, -s * x - c];
    return Math.min(3 / Math.abs(dx), 3 / Math.abs(dz), y < 0 ? eyeM / -y : (2.6 - eyeM) / y);
  });
  // Column-major: turned about y, at the height of the eyes.
  const worldFromDepth = [c, 0, -s, 0, 0, 1, 0, 0, s, 0, c, 0, 0, eyeM, 0, 1];
  return { meters, widthPx, heightPx, worldFromDepth, rayFromTexel, deltaS: 1 / 30 };
}
