import { chromaErrorMap, compareImages, type ImageQuality } from '../../../export/captures/image-quality.ts';
import { createFetchAssetSource } from '../../../export/runtime/assets/asset-source.ts';
import { bakeColors } from '../../../export/runtime/assets/capture/bake-colors.ts';
import { type LoadedCapture, loadCapture } from '../../../export/runtime/assets/capture/load-capture.ts';
import { createGlObjects } from '../../../export/runtime/gl/gl-objects.ts';
import { CAPTURE_FILE, type CaptureMesh, type CaptureView, readCapture, readCaptureMesh } from '../../../nodes/kit/capture.ts';
import { type CaptureDrawing, createCaptureDrawing } from '../../../nodes/kit/capture-drawing/capture-drawing.ts';
import { createDepthMeshDrawing } from '../../../nodes/kit/capture-drawing/depth-meshes/depth-mesh-drawing.ts';
import type { Method as MeshMethod } from '../../../nodes/kit/capture-drawing/shaders.ts';
import { setPassState } from '../../../nodes/kit/pass-state.ts';
import { photoPixels, pictureUrl } from './photo-pixels.page.ts';

/** A method of the node Capture. */
export type Method = MeshMethod | 'depth-meshes';

/** One photograph, rendered from all others by one method. */
export interface Rephotograph extends ImageQuality {
  readonly method: Method;
  /** Data URLs; null if pictures were not asked for. The error is that of Cb and Cr. */
  readonly picture: string | null;
  readonly error: string | null;
}

interface Opened {
  readonly gl: WebGL2RenderingContext;
  readonly load: (path: string) => Promise<ArrayBuffer>;
  readonly capture: LoadedCapture;
  readonly mesh: CaptureMesh;
  readonly views: readonly CaptureView[];
  readonly drawings: ReadonlyMap<Method, CaptureDrawing>;
}

let opened: Opened | null = null;

/**
 * Loads a capture.
 *
 * @param blended Number of photographs per pixel (lumigraph).
 * @returns The number of its views.
 * @throws CaptureError
 */
export async function open(baseUrl: string, methods: readonly Method[], blended: number): Promise<number> {
  const { load } = createFetchAssetSource(new URL(baseUrl, document.baseURI).href, fetch.bind(globalThis));
  const bytes = await load(CAPTURE_FILE);
  const { views, mesh } = readCapture(new TextDecoder().decode(bytes));
  const canvas = document.createElement('canvas');
  const gl = canvas.getContext('webgl2', { alpha: true, antialias: false, depth: true });
  if (!gl) throw new Error('The browser has no WebGL 2.');
  const capture = await loadCapture(createGlObjects(gl), bytes, CAPTURE_FILE, load, methods.includes('depth-meshes'));
  const drawingOf = (method: Method): CaptureDrawing =>
    method === 'depth-meshes' ? createDepthMeshDrawing(gl, capture) : createCaptureDrawing(gl, capture, method, blended);
  const drawings = new Map(methods.map((method) => [method, drawingOf(method)]));
  opened = { gl, load, capture, mesh: readCaptureMesh(mesh, await load(mesh.file)), views, drawings };
  return views.length;
}

/** Renders the photograph `index` at its own size from all others, which also give the colors of the mesh. Nothing for a 360° photograph. */
export async function rephotograph(index: number, keepsPictures: boolean): Promise<readonly Rephotograph[]> {
  const view = opened?.views[index];
  if (!opened || !view) throw new Error(`There is no view ${index}.`);
  const { gl, capture, mesh, drawings, load } = opened;
  if (view.projection) return [];
  const { widthPx, heightPx, worldFromCamera: m } = view;
  const truth = await photoPixels(await load(view.file), widthPx, heightPx);
  Object.assign(gl.canvas, { width: widthPx, height: heightPx });
  const colors = gl.createBuffer();
  const baked = bakeColors(gl, capture, mesh, index);
  gl.bindVertexArray(capture.vertexArray);
  gl.bindBuffer(gl.ARRAY_BUFFER, colors);
  gl.bufferData(gl.ARRAY_BUFFER, baked, gl.STATIC_DRAW);
  gl.vertexAttribPointer(1, 4, gl.UNSIGNED_BYTE, true, 0, 0);
  const eye = Float32Array.from(m.slice(12, 15));
  const forward = Float32Array.from(m.slice(8, 11), (x) => -x);
  const shots: Rephotograph[] = [];
  for (const [method, drawing] of drawings) {
    setPassState(gl, null, null, 0, 0, widthPx, heightPx);
    gl.depthMask(true);
    gl.clearColor(0, 0, 0, 0);
    gl.clear(gl.COLOR_BUFFER_BIT | gl.DEPTH_BUFFER_BIT);
    drawing.draw(clipFromCapture(view), eye, forward, { framebuffer: null, viewport: { x: 0, y: 0, widthPx, heightPx } }, index);
    const shown = new Uint8ClampedArray(4 * widthPx * heightPx);
    gl.readPixels(0, 0, widthPx, heightPx, gl.RGBA, gl.UNSIGNED_BYTE, shown);
    const pair = { shown, truth, widthPx, heightPx };
    shots.push({
      method,
      ...compareImages(pair),
      picture: keepsPictures ? pictureUrl(shown, widthPx, heightPx) : null,
      error: keepsPictures ? pictureUrl(chromaErrorMap(pair), widthPx, heightPx) : null,
    });
  }
  // Another index bakes other colors, and a deleted buffer of a vertex array stays until it is replaced.
  gl.deleteBuffer(colors);
  return shots;
}

const NEAR_M = 0.01;
const FAR_M = 1000;

/** The projection of a photograph’s camera times its inverse pose; column-major 4×4. */
function clipFromCapture({ widthPx, heightPx, fxPx, fyPx, cxPx, cyPx, worldFromCamera: m }: CaptureView): Float32Array {
  const at = (i: number): number => m[i] ?? 0;
  // Coordinates of a point along the axes of the camera: x, y and the distance in front.
  const row = (axis: number, sign: number): readonly number[] => {
    const [x, y, z] = [sign * at(4 * axis), sign * at(4 * axis + 1), sign * at(4 * axis + 2)];
    return [x, y, z, -(x * at(12) + y * at(13) + z * at(14))];
  };
  const [right, up, ahead] = [row(0, 1), row(1, 1), row(2, -1)];
  const depthScale = (FAR_M + NEAR_M) / (FAR_M - NEAR_M);
  const depthOffset = (-2 * FAR_M * NEAR_M) / (FAR_M - NEAR_M);
  return Float32Array.from({ length: 16 }, (_, i) => {
    const column = Math.floor(i / 4);
    const [x = 0, y = 0, z = 0] = [right[column], up[column], ahead[column]];
    if (i % 4 === 0) return (2 * fxPx * x) / widthPx + ((2 * cxPx) / widthPx - 1) * z;
    if (i % 4 === 1) return (2 * fyPx * y) / heightPx + (1 - (2 * cyPx) / heightPx) * z;
    return i % 4 === 2 ? depthScale * z + (column === 3 ? depthOffset : 0) : z;
  });
}
