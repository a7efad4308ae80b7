import {
  type CaptureDocument,
  CaptureError,
  type CaptureMesh,
  type CaptureSize,
  type CaptureView,
  captureSize,
  readCapture,
  readCaptureMesh,
} from '../../../../nodes/kit/capture.ts';
import type { CaptureAsset } from '../../../../nodes/kit/capture-asset.ts';
import type { GlObjects } from '../../gl/gl-objects.ts';
import { prepareUpload } from '../../gl/upload.ts';
import { bakeColors } from './bake-colors.ts';
import { drawDepths } from './draw-depths.ts';

export interface LoadedCapture extends CaptureAsset {
  dispose(): void;
}

/**
 * Loads a capture: its photographs, the depth maps of its mesh from each camera, and the color of each vertex.
 *
 * @param bytes `capture.json`.
 * @param path Its path, to which the other files are relative.
 * @throws CaptureError if a file is invalid.
 */
export async function loadCapture(
  objects: GlObjects,
  bytes: ArrayBuffer,
  path: string,
  load: (path: string) => Promise<ArrayBuffer>,
): Promise<LoadedCapture> {
  const document = readCapture(new TextDecoder().decode(bytes));
  const { gl, limits } = objects;
  const { views } = document;
  const layers = gl.getParameter(gl.MAX_ARRAY_TEXTURE_LAYERS) as number;
  if (views.length > layers) throw new CaptureError(`it has ${views.length} views, but the graphics of this device hold ${layers}`);
  const folder = path.slice(0, path.lastIndexOf('/') + 1);
  const mesh = readCaptureMesh(document.mesh, await load(folder + document.mesh.file));
  const size = captureSize(document, limits.maxTextureSizePx);
  const [widthPx, heightPx] = size.photoPx;
  const photos = objects.createTexture();
  const disposals = [() => objects.deleteTexture(photos)];
  const dispose = () => {
    for (const release of disposals.splice(0)) release();
  };
  try {
    allocateArray(gl, photos, gl.RGBA8, size.photoPx, views.length, 1 + Math.floor(Math.log2(Math.max(widthPx, heightPx))));
    for (const [layer, { file }] of views.entries()) {
      const bitmap = await createImageBitmap(new Blob([await load(folder + file)]), {
        premultiplyAlpha: 'none',
        colorSpaceConversion: 'none',
        imageOrientation: 'flipY',
        resizeWidth: widthPx,
        resizeHeight: heightPx,
        resizeQuality: 'high',
      });
      gl.activeTexture(gl.TEXTURE0);
      gl.bindTexture(gl.TEXTURE_2D_ARRAY, photos);
      prepareUpload(gl, 4);
      gl.texSubImage3D(gl.TEXTURE_2D_ARRAY, 0, 0, 0, layer, widthPx, heightPx, 1, gl.RGBA, gl.UNSIGNED_BYTE, bitmap);
      bitmap.close();
    }
    gl.activeTexture(gl.TEXTURE0);
    gl.bindTexture(gl.TEXTURE_2D_ARRAY, photos);
    gl.generateMipmap(gl.TEXTURE_2D_ARRAY);
    gl.texParameteri(gl.TEXTURE_2D_ARRAY, gl.TEXTURE_MIN_FILTER, gl.LINEAR_MIPMAP_LINEAR);
    gl.texParameteri(gl.TEXTURE_2D_ARRAY, gl.TEXTURE_MAG_FILTER, gl.LINEAR);
    return { ...prepare(objects, document, mesh, photos, size.depthPx, disposals), dispose };
  } catch (error) {
    dispose();
    throw error;
  }
}

function prepare(
  objects: GlObjects,
  { views }: CaptureDocument,
  mesh: CaptureMesh,
  photos: WebGLTexture,
  depthPx: CaptureSize['depthPx'],
  disposals: (() => void)[],
): CaptureAsset {
  const { gl } = objects;
  const { farM, radiusM } = extentOf(mesh, views);
  const cameras = objects.createTexture();
  disposals.push(() => objects.deleteTexture(cameras));
  gl.bindTexture(gl.TEXTURE_2D, cameras);
  gl.texStorage2D(gl.TEXTURE_2D, 1, gl.RGBA32F, 4, views.length);
  for (const name of [gl.TEXTURE_MIN_FILTER, gl.TEXTURE_MAG_FILTER]) gl.texParameteri(gl.TEXTURE_2D, name, gl.NEAREST);
  prepareUpload(gl, 4);
  gl.texSubImage2D(gl.TEXTURE_2D, 0, 0, 0, 4, views.length, gl.RGBA, gl.FLOAT, Float32Array.from(views.flatMap(cameraTexels)));

  const vertexArray = objects.createVertexArray();
  const positions = gl.createBuffer();
  const indices = gl.createBuffer();
  const colors = gl.createBuffer();
  disposals.push(() => {
    objects.deleteVertexArray(vertexArray);
    for (const buffer of [positions, indices, colors]) gl.deleteBuffer(buffer);
  });
  gl.bindVertexArray(vertexArray);
  gl.bindBuffer(gl.ARRAY_BUFFER, positions);
  gl.bufferData(gl.ARRAY_BUFFER, mesh.positions, gl.STATIC_DRAW);
  gl.enableVertexAttribArray(0);
  gl.vertexAttribPointer(0, 3, gl.FLOAT, false, 0, 0);
  gl.bindBuffer(gl.ELEMENT_ARRAY_BUFFER, indices);
  gl.bufferData(gl.ELEMENT_ARRAY_BUFFER, mesh.indices, gl.STATIC_DRAW);

  const depths = objects.createTexture();
  disposals.push(() => objects.deleteTexture(depths));
  allocateArray(gl, depths, gl.DEPTH_COMPONENT24, depthPx, views.length, 1);
  for (const name of [gl.TEXTURE_MIN_FILTER, gl.TEXTURE_MAG_FILTER]) gl.texParameteri(gl.TEXTURE_2D_ARRAY, name, gl.NEAREST);
  const drawn = {
    vertexArray,
    indexCount: mesh.indices.length,
    photos,
    depths,
    cameras,
    viewCount: views.length,
    positions: Float32Array.from(views.flatMap(({ worldFromCamera: m }) => m.slice(12, 15))),
    directions: Float32Array.from(views.flatMap(({ worldFromCamera: m }) => m.slice(8, 11).map((x) => -x))),
    farM,
    radiusM,
  };
  drawDepths(objects, drawn, depthPx);
  const baked = bakeColors(gl, drawn, mesh);
  gl.bindVertexArray(vertexArray);
  gl.bindBuffer(gl.ARRAY_BUFFER, colors);
  gl.bufferData(gl.ARRAY_BUFFER, baked, gl.STATIC_DRAW);
  gl.enableVertexAttribArray(1);
  gl.vertexAttribPointer(1, 4, gl.UNSIGNED_BYTE, true, 0, 0);
  gl.bindVertexArray(null);
  return drawn;
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

/** The rows that give u z, v z and z of a point, then the position of the camera. u is to the right, v up. */
function cameraTexels({ widthPx, heightPx, fxPx, fyPx, cxPx, cyPx, worldFromCamera: m }: CaptureView): number[] {
  const [cx = 0, cy = 0, cz = 0] = m.slice(12, 15);
  const row = (axis: number, sign: number): number[] => {
    const [x = 0, y = 0, z = 0] = m.slice(4 * axis, 4 * axis + 3);
    return [sign * x, sign * y, sign * z, -sign * (x * cx + y * cy + z * cz)];
  };
  const [right, up, forward] = [row(0, 1), row(1, 1), row(2, -1)];
  const mix = (a: readonly number[], fa: number, b: readonly number[], fb: number) => a.map((x, i) => x * fa + (b[i] ?? 0) * fb);
  return [
    ...mix(right, fxPx / widthPx, forward, cxPx / widthPx),
    ...mix(up, fyPx / heightPx, forward, 1 - cyPx / heightPx),
    ...forward,
    ...[cx, cy, cz, 1],
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
