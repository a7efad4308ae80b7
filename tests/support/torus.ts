import type { CaptureMesh } from '../../nodes/kit/capture.ts';

/** A torus that lies in the plane of x and z, away from the origin. Radii 1 and 0.4. */
const CENTER = [3, -2, 5] as const;
export const torus = (around: number, across: number): CaptureMesh => {
  const positions: number[] = [];
  const indices: number[] = [];
  for (let i = 0; i < around; i++) {
    for (let j = 0; j < across; j++) {
      const [a, b] = [(2 * Math.PI * i) / around, (2 * Math.PI * j) / across];
      const out = 1 + 0.4 * Math.cos(b);
      positions.push(CENTER[0] + out * Math.cos(a), CENTER[1] + 0.4 * Math.sin(b), CENTER[2] + out * Math.sin(a));
      const at = (di: number, dj: number) => ((i + di) % around) * across + ((j + dj) % across);
      indices.push(at(0, 0), at(0, 1), at(1, 1), at(0, 0), at(1, 1), at(1, 0));
    }
  }
  return { positions: Float32Array.from(positions), indices: Uint32Array.from(indices) };
};

/** How far the vertices of a mesh are from the torus, at most. */
export function farthest({ positions }: CaptureMesh): number {
  let most = 0;
  for (let i = 0; i < positions.length; i += 3) {
    const [x, y, z] = CENTER.map((center, axis) => (positions[i + axis] ?? 0) - center) as [number, number, number];
    most = Math.max(most, Math.abs(Math.hypot(Math.hypot(x, z) - 1, y) - 0.4));
  }
  return most;
}
