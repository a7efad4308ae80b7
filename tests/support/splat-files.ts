import type { SplatPoint } from '../../tools/examples/splats/write-sog.ts';

const C0 = 0.28209479177387814;

/** A splat like a ball, red and nearly opaque, unless said otherwise. */
export function splatAt(x: number, y: number, z: number, more: Partial<SplatPoint> = {}): SplatPoint {
  return { position: [x, y, z], scale: [0.1, 0.1, 0.1], rotation: [0, 0, 0, 1], color: [1, 0, 0], opacity: 0.98, ...more };
}

/** A PLY file as the training of Gaussian splats writes it, with normals. */
export function plyOf(splats: readonly SplatPoint[]): Uint8Array {
  const coefficients = (splats[0]?.harmonics?.length ?? 0) / 3;
  const names = [
    ...['x', 'y', 'z', 'nx', 'ny', 'nz', 'f_dc_0', 'f_dc_1', 'f_dc_2'],
    ...Array.from({ length: 3 * coefficients }, (_, i) => `f_rest_${i}`),
    ...['opacity', 'scale_0', 'scale_1', 'scale_2', 'rot_0', 'rot_1', 'rot_2', 'rot_3'],
  ];
  const rows = splats.flatMap(({ position, scale, rotation: [x, y, z, w], color, opacity, harmonics = [] }) => [
    ...[...position, 0, 0, 0, ...color.map((value) => (value - 0.5) / C0)],
    ...Array.from({ length: 3 * coefficients }, (_, i) => harmonics[3 * (i % coefficients) + Math.floor(i / coefficients)] ?? 0),
    ...[Math.log(opacity / (1 - opacity)), ...scale.map(Math.log), w, x, y, z],
  ]);
  return plyFile(splats.length, names, rows);
}

/** A binary PLY file of 32-bit floats. */
export function plyFile(count: number, names: readonly string[], rows: readonly number[], before = ''): Uint8Array {
  const properties = names.map((name) => `property float ${name}\n`).join('');
  const header = new TextEncoder().encode(
    `ply\nformat binary_little_endian 1.0\nelement vertex ${count}\n${properties}${before}end_header\n`,
  );
  const file = new Uint8Array(header.length + 4 * rows.length);
  file.set(header);
  file.set(new Uint8Array(Float32Array.from(rows).buffer), header.length);
  return file;
}

/** Pseudorandom numbers in [0, 1). */
function dice(seed: number): () => number {
  let state = seed;
  return () => {
    state = (Math.imul(state, 1664525) + 1013904223) >>> 0;
    return state / 2 ** 32;
  };
}

/** Splats of all sizes, colors and opacities before an eye at the origin, the same at each call. */
export function splatCloud(count: number, coefficients: number): SplatPoint[] {
  const random = dice(7);
  const between = (low: number, high: number): number => low + (high - low) * random();
  return Array.from({ length: count }, () => ({
    position: [between(-1.6, 1.6), between(-1.2, 1.2), between(-4.5, -1)] as const,
    scale: [between(0.01, 0.25), between(0.01, 0.25), between(0.01, 0.25)] as const,
    rotation: [between(-1, 1), between(-1, 1), between(-1, 1), between(-1, 1)] as const,
    color: [between(0.1, 0.8), between(0.1, 0.8), between(0.1, 0.8)] as const,
    opacity: between(0.05, 0.95),
    harmonics: Array.from({ length: 3 * coefficients }, () => between(-0.2, 0.2)),
  }));
}
