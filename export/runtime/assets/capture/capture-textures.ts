import type { CaptureDocument, CaptureMesh, CaptureView } from '../../../../nodes/kit/capture.ts';
import { type CaptureAsset, type CaptureDepthMeshes, PHOTO_MISSING, PHOTO_WHOLE } from '../../../../nodes/kit/capture-asset.ts';
import type { CaptureSize } from '../../../../nodes/kit/capture-size.ts';
import type { GlObjects } from '../../gl/gl-objects.ts';
import { prepareUpload } from '../../gl/upload.ts';
import { bakeColors } from './bake-colors.ts';
import { drawDepths } from './draw-depths.ts';
import { drawPanoramaDepths } from './draw-panorama-depths.ts';

/** A capture on the GPU whose mesh and photographs are set one by one. */
export interface CaptureTextures {
  /** Valid from the first `setMesh` on. */
  readonly asset: CaptureAsset;
  /** Sets or replaces the mesh, and draws its depth maps. */
  setMesh(mesh: CaptureMesh): void;
  /**
   * Sets or replaces a photograph. Its mip levels are made by `finish`.
   *
   * @param form `PHOTO_REDUCED` or `PHOTO_WHOLE`.
   */
  setPhoto(view: number, photo: Blob, form: number): Promise<void>;
  setDepthMeshes(meshes: CaptureDepthMeshes): void;
  /** Computes the colors of the mesh from the photographs that are there. */
  bake(): void;
  /** Makes the mip levels of all photographs, which are drawn with them from then on. */
  finish(): void;
  dispose(): void;
}

/** Allocates the textures of a capture: photographs, depth maps, cameras. */
export function createCaptureTextures(
  objects: GlObjects,
  { views }: CaptureDocument,
  { photoPx, depthPx }: Pick<CaptureSize, 'photoPx' | 'depthPx'>,
): CaptureTextures {
  const { gl } = objects;
  const [widthPx, heightPx] = photoPx;
  const photos = objects.createTexture();
  const depths = objects.createTexture();
  const cameras = objects.createTexture();
  const vertexArray = objects.createVertexArray();
  const buffers = { positions: objects.createBuffer(), colors: objects.createBuffer(), indices: objects.createBuffer() };
  let isDisposed = false;
  const asset = {
    vertexArray,
    buffers,
    indexCount: 0,
    mesh: null as CaptureMesh | null,
    photos,
    depths,
    cameras,
    viewCount: views.length,
    version: 0,
    panoramas: new Set(views.flatMap(({ projection }, i) => (projection === undefined ? [] : [i]))),
    positions: Float32Array.from(views.flatMap(({ worldFromCamera: m }) => m.slice(12, 15))),
    directions: Float32Array.from(views.flatMap(({ worldFromCamera: m, projection }) => m.slice(8, 11).map((x) => (projection ? 0 : -x)))),
    loaded: new Uint8Array(views.length).fill(PHOTO_MISSING),
    wantedView: -1,
    farM: 0,
    radiusM: 0,
    depthMeshes: null as CaptureDepthMeshes | null,
  };
  allocateArray(gl, photos, gl.RGBA8, photoPx, views.length, 1 + Math.floor(Math.log2(Math.max(widthPx, heightPx))));
  // Pinhole photographs have no weight at their edges.
  if (asset.panoramas.size > 0) gl.texParameteri(gl.TEXTURE_2D_ARRAY, gl.TEXTURE_WRAP_S, gl.REPEAT);
  for (const name of [gl.TEXTURE_MIN_FILTER, gl.TEXTURE_MAG_FILTER]) gl.texParameteri(gl.TEXTURE_2D_ARRAY, name, gl.LINEAR);
  allocateArray(gl, depths, gl.DEPTH_COMPONENT24, depthPx, views.length, 1);
  for (const name of [gl.TEXTURE_MIN_FILTER, gl.TEXTURE_MAG_FILTER]) gl.texParameteri(gl.TEXTURE_2D_ARRAY, name, gl.NEAREST);
  gl.bindTexture(gl.TEXTURE_2D, cameras);
  gl.texStorage2D(gl.TEXTURE_2D, 1, gl.RGBA32F, 4, views.length);
  for (const name of [gl.TEXTURE_MIN_FILTER, gl.TEXTURE_MAG_FILTER]) gl.texParameteri(gl.TEXTURE_2D, name, gl.NEAREST);

  const setCamera = (view: CaptureView, row: number): void => {
    gl.activeTexture(gl.TEXTURE0);
    gl.bindTexture(gl.TEXTURE_2D, cameras);
    prepareUpload(gl, 4);
    const texels = Float32Array.from(cameraTexels(view, asset.loaded[row] !== PHOTO_MISSING));
    gl.texSubImage2D(gl.TEXTURE_2D, 0, 0, row, 4, 1, gl.RGBA, gl.FLOAT, texels);
  };
  views.forEach(setCamera);
  const setAttribute = (place: number, buffer: WebGLBuffer, data: ArrayBufferView): void => {
    gl.bindBuffer(gl.ARRAY_BUFFER, buffer);
    gl.bufferData(gl.ARRAY_BUFFER, data, gl.STATIC_DRAW);
    gl.enableVertexAttribArray(place);
    if (place === 0) gl.vertexAttribPointer(0, 3, gl.FLOAT, false, 0, 0);
    else gl.vertexAttribPointer(1, 4, gl.UNSIGNED_BYTE, true, 0, 0);
  };
  return {
    asset,
    setMesh: (next) => {
      Object.assign(asset, extentOf(next, views), { indexCount: next.indices.length, mesh: next });
      asset.version++;
      gl.bindVertexArray(vertexArray);
      setAttribute(0, buffers.positions, next.positions);
      setAttribute(1, buffers.colors, new Uint8Array((4 * next.positions.length) / 3));
      gl.bindBuffer(gl.ELEMENT_ARRAY_BUFFER, buffers.indices);
      gl.bufferData(gl.ELEMENT_ARRAY_BUFFER, next.indices, gl.STATIC_DRAW);
      drawDepths(objects, asset, depthPx);
      if (asset.panoramas.size > 0) drawPanoramaDepths(objects, asset, depthPx);
      gl.bindVertexArray(null);
    },
    setPhoto: async (index, photo, form) => {
      const bitmap = await createImageBitmap(photo, {
        premultiplyAlpha: 'none',
        colorSpaceConversion: 'none',
        imageOrientation: 'flipY',
        resizeWidth: widthPx,
        resizeHeight: heightPx,
        resizeQuality: 'high',
      });
      if (!isDisposed) {
        gl.activeTexture(gl.TEXTURE0);
        gl.bindTexture(gl.TEXTURE_2D_ARRAY, photos);
        prepareUpload(gl, 4);
        gl.texSubImage3D(gl.TEXTURE_2D_ARRAY, 0, 0, 0, index, widthPx, heightPx, 1, gl.RGBA, gl.UNSIGNED_BYTE, bitmap);
        asset.loaded[index] = form;
        asset.version++;
        const view = views[index];
        if (view) setCamera(view, index);
      }
      bitmap.close();
    },
    setDepthMeshes: (meshes) => {
      asset.depthMeshes = meshes;
      asset.version++;
    },
    bake: () => {
      if (!asset.mesh) return;
      const baked = bakeColors(gl, asset, asset.mesh);
      gl.bindVertexArray(vertexArray);
      setAttribute(1, buffers.colors, baked);
      asset.version++;
      gl.bindVertexArray(null);
    },
    finish: () => {
      gl.activeTexture(gl.TEXTURE0);
      gl.bindTexture(gl.TEXTURE_2D_ARRAY, photos);
      gl.generateMipmap(gl.TEXTURE_2D_ARRAY);
      gl.texParameteri(gl.TEXTURE_2D_ARRAY, gl.TEXTURE_MIN_FILTER, gl.LINEAR_MIPMAP_LINEAR);
      asset.loaded.fill(PHOTO_WHOLE);
      asset.version++;
    },
    dispose: () => {
      if (isDisposed) return;
      isDisposed = true;
      for (const texture of [photos, depths, cameras]) objects.deleteTexture(texture);
      objects.deleteVertexArray(vertexArray);
      for (const buffer of Object.values(buffers)) objects.deleteBuffer(buffer);
    },
  };
}

function allocateArray(
  gl: WebGL2RenderingContext,
  texture: WebGLTexture,
  format: GLenum,
  [widthPx, heightPx]: readonly [number, number],
  layers: number,
  levels: number,
): void {
  gl.activeTexture(gl.TEXTURE0);
  gl.bindTexture(gl.TEXTURE_2D_ARRAY, texture);
  gl.texStorage3D(gl.TEXTURE_2D_ARRAY, levels, format, widthPx, heightPx, layers);
  for (const name of [gl.TEXTURE_WRAP_S, gl.TEXTURE_WRAP_T]) gl.texParameteri(gl.TEXTURE_2D_ARRAY, name, gl.CLAMP_TO_EDGE);
}

/** The texels of a view in `CaptureAsset.cameras`. u is to the right, v up. */
function cameraTexels(
  { projection, widthPx, heightPx, fxPx, fyPx, cxPx, cyPx, worldFromCamera: m }: CaptureView,
  isLoaded: boolean,
): number[] {
  const mark = (projection ? 1 : 0) - (isLoaded ? 0 : 2);
  const [cx = 0, cy = 0, cz = 0] = m.slice(12, 15);
  const row = (axis: number, sign: number): number[] => {
    const [x = 0, y = 0, z = 0] = m.slice(4 * axis, 4 * axis + 3);
    return [sign * x, sign * y, sign * z, -sign * (x * cx + y * cy + z * cz)];
  };
  const [right, up, forward] = [row(0, 1), row(1, 1), row(2, -1)];
  if (projection) return [...right, ...up, ...forward, cx, cy, cz, mark];
  const mix = (a: readonly number[], fa: number, b: readonly number[], fb: number) => a.map((x, i) => x * fa + (b[i] ?? 0) * fb);
  return [
    ...mix(right, fxPx / widthPx, forward, cxPx / widthPx),
    ...mix(up, fyPx / heightPx, forward, 1 - cyPx / heightPx),
    ...forward,
    ...[cx, cy, cz, mark],
  ];
}

function extentOf({ positions }: CaptureMesh, views: readonly CaptureView[]): { readonly farM: number; readonly radiusM: number } {
  const least = [0, 1, 2].map((axis) => positions[axis] ?? 0);
  const most = [...least];
  for (let i = 0; i < positions.length; i++) {
    const x = positions[i] ?? 0;
    if (x < (least[i % 3] ?? x)) least[i % 3] = x;
    if (x > (most[i % 3] ?? x)) most[i % 3] = x;
  }
  const toCorner = views.map(({ worldFromCamera: m }) =>
    Math.hypot(...[0, 1, 2].map((i) => Math.max((m[12 + i] ?? 0) - (least[i] ?? 0), (most[i] ?? 0) - (m[12 + i] ?? 0)))),
  );
  return { farM: 1.01 * Math.max(...toCorner), radiusM: Math.hypot(...most.map((x, i) => x - (least[i] ?? 0))) / 2 };
}
