import { type CaptureDepthMeshFile, CaptureError, type CaptureView } from '../../../../nodes/kit/capture.ts';
import type { CaptureDepthMeshes, CaptureViewMeshes } from '../../../../nodes/kit/capture-asset.ts';
import type { GlObjects } from '../../gl/gl-objects.ts';

const VERTEX_BYTES = 8;

const COLOR_BYTES = 4;

export interface LoadedDepthMeshes extends CaptureDepthMeshes {
  dispose(): void;
}

/**
 * Loads the depth meshes of all views into one vertex array, a file at a time, and what is hidden behind them into another.
 *
 * @param load Loads a file by its name in the document.
 * @throws CaptureError if there are none, or one is invalid.
 */
export async function loadDepthMeshes(
  objects: GlObjects,
  views: readonly CaptureView[],
  load: (file: string) => Promise<ArrayBuffer>,
): Promise<LoadedDepthMeshes> {
  if (views.every(({ depthMesh }) => depthMesh === undefined)) {
    throw new CaptureError('it has no depth meshes. Import it again, with depth files or from its mesh');
  }
  const of = (files: readonly (CaptureDepthMeshFile | undefined)[], colored: boolean) => loadMeshes(objects, files, colored, load);
  const seen = await of(
    views.map(({ depthMesh }) => depthMesh),
    false,
  );
  try {
    const files = views.map(({ hiddenMesh }) => hiddenMesh);
    const hidden = files.some((file) => file !== undefined) ? await of(files, true) : null;
    return {
      vertexArray: seen.vertexArray,
      views: seen.views,
      hidden,
      dispose: () => {
        seen.dispose();
        hidden?.dispose();
      },
    };
  } catch (error) {
    seen.dispose();
    throw error;
  }
}

async function loadMeshes(
  objects: GlObjects,
  files: readonly (CaptureDepthMeshFile | undefined)[],
  colored: boolean,
  load: (file: string) => Promise<ArrayBuffer>,
): Promise<CaptureViewMeshes & { dispose(): void }> {
  const { gl } = objects;
  const total = (count: (file: CaptureDepthMeshFile) => number): number => files.reduce((sum, file) => sum + (file ? count(file) : 0), 0);
  const vertexTotal = total(({ vertexCount }) => vertexCount);
  const vertexArray = objects.createVertexArray();
  const [vertices, indices, colors] = [objects.createBuffer(), objects.createBuffer(), colored ? objects.createBuffer() : null];
  const dispose = (): void => {
    objects.deleteVertexArray(vertexArray);
    for (const buffer of [vertices, indices, colors]) if (buffer) objects.deleteBuffer(buffer);
  };
  const fill = (buffer: WebGLBuffer | null, at: number, data: ArrayBufferView): void => {
    gl.bindBuffer(gl.ARRAY_BUFFER, buffer);
    gl.bufferSubData(gl.ARRAY_BUFFER, at, data);
  };
  try {
    gl.bindVertexArray(vertexArray);
    gl.bindBuffer(gl.ELEMENT_ARRAY_BUFFER, indices);
    gl.bufferData(gl.ELEMENT_ARRAY_BUFFER, 12 * total(({ triangleCount }) => triangleCount), gl.STATIC_DRAW);
    gl.bindBuffer(gl.ARRAY_BUFFER, vertices);
    gl.bufferData(gl.ARRAY_BUFFER, VERTEX_BYTES * vertexTotal, gl.STATIC_DRAW);
    for (const place of colored ? [0, 1, 2] : [0, 1]) gl.enableVertexAttribArray(place);
    gl.vertexAttribIPointer(0, 2, gl.UNSIGNED_SHORT, VERTEX_BYTES, 0);
    gl.vertexAttribPointer(1, 1, gl.FLOAT, false, VERTEX_BYTES, 4);
    if (colored) {
      gl.bindBuffer(gl.ARRAY_BUFFER, colors);
      gl.bufferData(gl.ARRAY_BUFFER, COLOR_BYTES * vertexTotal, gl.STATIC_DRAW);
      gl.vertexAttribPointer(2, 4, gl.UNSIGNED_BYTE, true, 0, 0);
    }
    gl.bindVertexArray(null);
    const drawn: CaptureViewMeshes['views'][number][] = [];
    let firstVertex = 0;
    let firstIndex = 0;
    for (const file of files) {
      if (file === undefined) {
        drawn.push(null);
        continue;
      }
      const mesh = readDepthMesh(file, await load(file.file), firstVertex, colored ? COLOR_BYTES : 0);
      fill(vertices, VERTEX_BYTES * firstVertex, mesh.vertices);
      if (colored) fill(colors, COLOR_BYTES * firstVertex, mesh.colors);
      gl.bindVertexArray(vertexArray);
      gl.bufferSubData(gl.ELEMENT_ARRAY_BUFFER, 4 * firstIndex, mesh.indices);
      gl.bindVertexArray(null);
      drawn.push({ widthPx: file.widthPx, heightPx: file.heightPx, firstIndex, indexCount: mesh.indices.length });
      firstVertex += file.vertexCount;
      firstIndex += mesh.indices.length;
    }
    return { vertexArray, views: drawn, dispose };
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
  colorBytes: number,
) {
  const vertexBytes = VERTEX_BYTES * vertexCount;
  const meshBytes = vertexBytes + 12 * triangleCount;
  const expected = meshBytes + colorBytes * vertexCount;
  if (bytes.byteLength !== expected) throw new CaptureError(`${file} has ${bytes.byteLength} bytes instead of ${expected}`);
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
  return { vertices: new Uint8Array(bytes, 0, vertexBytes), indices, colors: new Uint8Array(bytes, meshBytes) };
}
