import type { CaptureMesh } from '../../../../nodes/kit/capture.ts';
import type { CaptureAsset } from '../../../../nodes/kit/capture-asset.ts';
import type { GlObjects } from '../../gl/gl-objects.ts';

/** A mesh of a capture on the GPU. */
export type GpuMesh = Pick<CaptureAsset, 'vertexArray' | 'buffers' | 'indexCount'>;

/** Uploads a mesh, which is black until it has colors; null: none. */
export function createGpuMesh(objects: GlObjects, mesh: CaptureMesh | null): GpuMesh {
  const { gl } = objects;
  const vertexArray = objects.createVertexArray();
  const buffers = { positions: objects.createBuffer(), colors: objects.createBuffer(), indices: objects.createBuffer() };
  if (mesh) {
    gl.bindVertexArray(vertexArray);
    gl.bindBuffer(gl.ARRAY_BUFFER, buffers.positions);
    gl.bufferData(gl.ARRAY_BUFFER, mesh.positions, gl.STATIC_DRAW);
    gl.enableVertexAttribArray(0);
    gl.vertexAttribPointer(0, 3, gl.FLOAT, false, 0, 0);
    gl.bindBuffer(gl.ARRAY_BUFFER, buffers.colors);
    gl.bufferData(gl.ARRAY_BUFFER, (4 * mesh.positions.length) / 3, gl.STATIC_DRAW);
    gl.enableVertexAttribArray(1);
    gl.vertexAttribPointer(1, 4, gl.UNSIGNED_BYTE, true, 0, 0);
    gl.bindBuffer(gl.ELEMENT_ARRAY_BUFFER, buffers.indices);
    gl.bufferData(gl.ELEMENT_ARRAY_BUFFER, mesh.indices, gl.STATIC_DRAW);
    gl.bindVertexArray(null);
  }
  return { vertexArray, buffers, indexCount: mesh?.indices.length ?? 0 };
}

/** @param colors RGBA, 8 bits. */
export function setColors(gl: WebGL2RenderingContext, { buffers }: GpuMesh, colors: Uint8Array): void {
  gl.bindBuffer(gl.ARRAY_BUFFER, buffers.colors);
  gl.bufferSubData(gl.ARRAY_BUFFER, 0, colors);
}

export function deleteGpuMesh(objects: GlObjects, { vertexArray, buffers }: GpuMesh): void {
  objects.deleteVertexArray(vertexArray);
  for (const buffer of Object.values(buffers)) objects.deleteBuffer(buffer);
}
