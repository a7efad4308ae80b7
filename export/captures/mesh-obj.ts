import { CaptureError, type CaptureMesh } from '../../nodes/kit/capture.ts';
import { createMeshBuilder } from './mesh-builder.ts';
import { linesOf } from './text-lines.ts';

/** Reads the vertices and faces of a Wavefront OBJ file. @throws CaptureError */
export function readObj(bytes: Uint8Array): CaptureMesh {
  const builder = createMeshBuilder();
  let vertices = 0;
  let number = 0;
  for (const line of linesOf(bytes)) {
    number++;
    const [word, ...rest] = line.trim().split(/\s+/);
    if (word === 'v') {
      const [x = Number.NaN, y = Number.NaN, z = Number.NaN] = rest.map(Number);
      builder.vertex(x, y, z);
      vertices++;
    }
    if (word !== 'f') continue;
    // `7/1/2` is vertex 7, counted from 1; a negative number counts back from the last vertex.
    const corners = rest.map((corner) => Number.parseInt(corner, 10)).map((index) => (index < 0 ? vertices + index : index - 1));
    if (!corners.every((corner) => corner >= 0)) throw new CaptureError(`line ${number} of the mesh is not a face`);
    builder.polygon(corners);
  }
  return builder.build();
}
