import { type CaptureDepthMeshFile, CaptureError, type CaptureView } from '../../../../nodes/kit/capture.ts';
import type { CaptureDepthMeshes } from '../../../../nodes/kit/capture-asset.ts';
import type { GlObjects } from '../../gl/gl-objects.ts';

const VERTEX_BYTES = 8;

export interface LoadedDepthMeshes extends CaptureDepthMeshes {
  /** Bytes on the GPU. */
  readonly gpuBytes: number;
  dispose(): void;
}

/**
 * Loads the depth meshes of all views into one vertex array, a file at a time.
 *
 * @param load Loads a file by its name in the document.
 * @throws CaptureError if there are none, or one is invalid.
 */
export async function loadDepthMeshes(
  objects: GlObjects,
  views: readonly CaptureView[],
  load: (file: string) => Promise<ArrayBuffer>,
): Promise<LoadedDepthMeshes> {
  const { gl } = objects;
  const files = views.map(({ depthMesh }) => depthMesh ?? null);
  if (files.every((file) => file === null)) {
    throw new CaptureError('it has no depth meshes. Import it again, with depth files or from its mesh');
  }
  const total = (count: (file: CaptureDepthMeshFile) => number): number => files.reduce((sum, file) => sum + (file ? count(file) : 0), 0);
  const vertexBytes = VERTEX_BYTES * total(({ vertexCount }) => vertexCount);
  const indexBytes = 12 * total(({ triangleCount }) => triangleCount);
  const vertexArray = objects.createVertexArray();
  const [vertices, indices] = [gl.createBuffer(), gl.createBuffer()];
  const dispose = (): void => {
    objects.deleteVertexArray(vertexArray);
    gl.deleteBuffer(vertices);
    gl.deleteBuffer(indices);
  };
  try {
    gl.bindVertexArray(vertexArray);
    gl.bindBuffer(gl.ARRAY_BUFFER, vertices);
    gl.bufferData(gl.ARRAY_BUFFER, vertexBytes, gl.STATIC_DRAW);
    gl.bindBuffer(gl.ELEMENT_ARRAY_BUFFER, indices);
    gl.bufferData(gl.ELEMENT_ARRAY_BUFFER, indexBytes, gl.STATIC_DRAW);
    for (const place of [0, 1]) gl.enableVertexAttribArray(place);
    gl.vertexAttribIPointer(0, 2, gl.UNSIGNED_SHORT, VERTEX_BYTES, 0);
    gl.vertexAttribPointer(1, 1, gl.FLOAT, false, VERTEX_BYTES, 4);
    gl.bindVertexArray(null);
    const drawn: CaptureDepthMeshes['views'][number][] = [];
    let firstVertex = 0;
    let firstIndex = 0;
    for (const file of files) {
      if (file === null) {
        drawn.push(null);
        continue;
      }
      const mesh = readDepthMesh(file, await load(file.file), firstVertex);
      gl.bindVertexArray(vertexArray);
      gl.bindBuffer(gl.ARRAY_BUFFER, vertices);
      gl.bufferSubData(gl.ARRAY_BUFFER, VERTEX_BYTES * firstVertex, mesh.vertices);
      gl.bufferSubData(gl.ELEMENT_ARRAY_BUFFER, 4 * firstIndex, mesh.indices);
      gl.bindVertexArray(null);
      drawn.push({ widthPx: file.widthPx, heightPx: file.heightPx, firstIndex, indexCount: mesh.indices.length });
      firstVertex += file.vertexCount;
      firstIndex += mesh.indices.length;
    }
    return { vertexArray, views: drawn, gpuBytes: vertexBytes + indexBytes, dispose };
  } catch (error) {
    dispose();
    throw error;
  }
}

/** Checks the bytes of a depth mesh, and adds `firstVertex` to its indices. */
function readDepthMesh(
  { file, vertexCount, triangleCount, widthPx, heightPx }: CaptureDepthMeshFile,
  bytes: ArrayBuffer,
  firstVertex: number,
) {
  const vertexBytes = VERTEX_BYTES * vertexCount;
  if (bytes.byteLength !== vertexBytes + 12 * triangleCount) {
    throw new CaptureError(`${file} has ${bytes.byteLength} bytes instead of ${vertexBytes + 12 * triangleCount}`);
  }
  const places = new Uint16Array(bytes, 0, 4 * vertexCount);
  const depths = new Float32Array(bytes, 0, 2 * vertexCount);
  for (let i = 0; i < vertexCount; i++) {
    const depth = depths[2 * i + 1] ?? 0;
    if (!(depth > 0 && Number.isFinite(depth))) throw new CaptureError(`a depth in ${file} is not above 0`);
    if ((places[4 * i] ?? 0) > 2 * widthPx || (places[4 * i + 1] ?? 0) > 2 * heightPx) {
      throw new CaptureError(`a vertex of ${file} is outside its map`);
    }
  }
  const indices = new Uint32Array(bytes, vertexBytes, 3 * triangleCount);
  for (let i = 0; i < indices.length; i++) {
    const index = indices[i] ?? 0;
    if (index >= vertexCount) throw new CaptureError(`a triangle of ${file} has a vertex beyond the ${vertexCount}`);
    indices[i] = index + firstVertex;
  }
  return { vertices: new Uint8Array(bytes, 0, vertexBytes), indices };
}
