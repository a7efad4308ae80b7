import type { CaptureMesh } from '../../nodes/kit/capture.ts';

/** A mesh as a binary PLY file. */
export function meshAsPly({ positions, indices }: CaptureMesh): Uint8Array {
  const head = plyHead(
    positions.length / 3,
    ['x', 'y', 'z'].map((name) => `property float ${name}`),
    [`element face ${indices.length / 3}`, 'property list uchar int vertex_indices'],
  );
  const bytes = new Uint8Array(head.length + 4 * positions.length + (FACE_BYTES * indices.length) / 3);
  bytes.set(head);
  const view = new DataView(bytes.buffer, head.length);
  for (const [i, value] of positions.entries()) view.setFloat32(4 * i, value, true);
  const start = 4 * positions.length;
  for (let i = 0; i < indices.length; i++) {
    const face = start + FACE_BYTES * Math.floor(i / 3);
    view.setUint8(face, 3);
    view.setInt32(face + 1 + 4 * (i % 3), indices[i] ?? 0, true);
  }
  return bytes;
}

const FACE_BYTES = 13;

/** The header of a little-endian PLY file. */
export function plyHead(vertices: number, properties: readonly string[], more: readonly string[] = []): Uint8Array {
  const lines = ['ply', 'format binary_little_endian 1.0', `element vertex ${vertices}`, ...properties, ...more, 'end_header', ''];
  return new TextEncoder().encode(lines.join('\n'));
}
