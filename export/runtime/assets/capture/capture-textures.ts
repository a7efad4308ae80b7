import type { CaptureDocument, CaptureMesh, CaptureView } from '../../../../nodes/kit/capture.ts';
import { type CaptureAsset, type CaptureDepthMeshes, PHOTO_MISSING, PHOTO_WHOLE } from '../../../../nodes/kit/capture-asset.ts';
import type { CaptureSize } from '../../../../nodes/kit/capture-size.ts';
import type { GlObjects } from '../../gl/gl-objects.ts';
import type { PartedWork } from '../../gl/spread-work.ts';
import { prepareUpload } from '../../gl/upload.ts';
import { bakeColors } from './bake-colors.ts';
import { createDepthDrawing, type DepthDrawing, type DrawnMesh } from './draw-depths.ts';
import { createPanoramaDepthDrawing } from './draw-panorama-depths.ts';
import { createGpuMesh, deleteGpuMesh, setColors } from './gpu-mesh.ts';

/** A capture on the GPU whose mesh and photographs are set one by one. */
export interface CaptureTextures {
  /** Valid from the first `setMesh` on. */
  readonly asset: CaptureAsset;
  /**
   * Sets or replaces the mesh. If photographs are there, their depth maps and the colors of the mesh are made first, and the mesh before stays
   * until then.
   */
  setMesh(mesh: CaptureMesh): Promise<void>;
  /**
   * Sets or replaces a photograph, after the depth map of its view. Its mip levels are made by `finish`.
   *
   * @param form `PHOTO_REDUCED` or `PHOTO_WHOLE`.
   */
  setPhoto(view: number, photo: Blob, form: number): Promise<void>;
  setDepthMeshes(meshes: CaptureDepthMeshes): void;
  /** Computes the colors of the mesh from the photographs that are there. */
  bake(): Promise<void>;
  /** Makes the mip levels of all photographs, which are drawn with them from then on. */
  finish(): void;
  dispose(): void;
}

/** Does work with the GPU, at once or between frames; null if it ended early, because the capture was disposed. */
export type DoWork = <T>(work: PartedWork<T>) => Promise<T | null>;

/** Allocates the textures of a capture: photographs, depth maps, cameras. */
export function createCaptureTextures(
  objects: GlObjects,
  { views }: CaptureDocument,
  { photoPx, depthPx }: Pick<CaptureSize, 'photoPx' | 'depthPx'>,
  doWork: DoWork,
): CaptureTextures {
  const { gl } = objects;
  const [widthPx, heightPx] = photoPx;
  const photos = objects.createTexture();
  const depths = objects.createTexture();
  const cameras = objects.createTexture();
  const depthMaps = createDepthMaps(objects, depthPx);
  let isDisposed = false;
  const asset = {
    ...createGpuMesh(objects, null),
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
  /** Whether the depth map of a view is that of the mesh. */
  const isDrawn = new Uint8Array(views.length);
  function* prepareMesh(mesh: CaptureMesh, next: DrawnMesh): PartedWork<Uint8Array<ArrayBuffer> | null> {
    const loaded = [...views.keys()].filter((view) => asset.loaded[view] !== PHOTO_MISSING);
    isDrawn.fill(0);
    for (const view of loaded) {
      yield* depthMaps.draw(next, view);
      isDrawn[view] = 1;
    }
    return loaded.length === 0 ? null : yield* bakeColors(gl, { ...asset, ...next }, mesh);
  }
  return {
    asset,
    setMesh: async (mesh) => {
      const gpuMesh = createGpuMesh(objects, mesh);
      const extent = extentOf(mesh, views);
      const colors = await doWork(prepareMesh(mesh, { ...asset, ...gpuMesh, ...extent }));
      if (isDisposed) {
        deleteGpuMesh(objects, gpuMesh);
        return;
      }
      if (colors) setColors(gl, gpuMesh, colors);
      deleteGpuMesh(objects, asset);
      Object.assign(asset, gpuMesh, extent, { mesh });
      asset.version++;
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
      if (!isDisposed && asset.mesh && isDrawn[index] === 0) {
        await doWork(depthMaps.draw(asset, index));
        isDrawn[index] = 1;
      }
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
    bake: async () => {
      if (!asset.mesh) return;
      const colors = await doWork(bakeColors(gl, asset, asset.mesh));
      if (isDisposed || !colors) return;
      setColors(gl, asset, colors);
      asset.version++;
    },
    finish: () => {
      depthMaps.dispose();
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
      depthMaps.dispose();
      for (const texture of [photos, depths, cameras]) objects.deleteTexture(texture);
      deleteGpuMesh(objects, asset);
    },
  };
}

/** Draws the depth maps of all kinds of cameras. */
function createDepthMaps(objects: GlObjects, depthPx: readonly [number, number]) {
  let pinholes: DepthDrawing | null = null;
  let panoramas: DepthDrawing | null = null;
  return {
    draw: (mesh: DrawnMesh, view: number): PartedWork => {
      const isPanorama = mesh.panoramas.has(view);
      const create = isPanorama ? createPanoramaDepthDrawing : createDepthDrawing;
      const drawing = (isPanorama ? panoramas : pinholes) ?? create(objects, depthPx);
      if (isPanorama) panoramas = drawing;
      else pinholes = drawing;
      return drawing.draw(mesh, view);
    },
    /** It may be drawn again afterwards. */
    dispose: (): void => {
      for (const drawing of [pinholes, panoramas]) drawing?.dispose();
      pinholes = null;
      panoramas = null;
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
