import { CAPTURE_FILE, type CaptureView, readCapture, readCaptureMesh } from '../../nodes/kit/capture.ts';
import { type CaptureDrawing, createCaptureDrawing } from '../../nodes/kit/capture-drawing/capture-drawing.ts';
import { createDepthMeshDrawing } from '../../nodes/kit/capture-drawing/depth-meshes/depth-mesh-drawing.ts';
import type { Method as MeshMethod } from '../../nodes/kit/capture-drawing/shaders.ts';
import { setPassState } from '../../nodes/kit/pass-state.ts';
import { bakeColors } from './assets/capture/bake-colors.ts';
import { loadCapture } from './assets/capture/load-capture.ts';
import { createGlObjects } from './gl/gl-objects.ts';
import { workAtOnce } from './gl/spread-work.ts';
import { readScreen } from './readback.ts';

/** A method of the node Capture. */
type Method = MeshMethod | 'depth-meshes';

/** A pinhole camera in the space of the capture. */
type Pinhole = Pick<CaptureView, 'widthPx' | 'heightPx' | 'fxPx' | 'fyPx' | 'cxPx' | 'cyPx' | 'worldFromCamera'>;

/** Draws a capture without one of its photographs, to measure how well the others show it. */
export interface Rephotographer {
  readonly views: readonly CaptureView[];
  /** The pixels of a photograph: RGBA, 8 bits, rows from the top, without color conversion. */
  photo(index: number): Promise<Uint8ClampedArray>;
  /** Leaves out a photograph until the next call, also in the colors of the mesh. */
  leaveOut(index: number): void;
  /** Draws what a camera sees: RGBA, 8 bits, rows from the top; alpha is 0 where nothing is. The canvas takes its size. */
  draw(method: Method, camera: Pinhole): Uint8Array<ArrayBuffer>;
}

/**
 * Loads a capture for measuring.
 *
 * @param gl A context without antialiasing, which is used for nothing else.
 * @param load Reads a file, by its path in the folder of the capture.
 * @param methods Those that are drawn.
 * @param blended Number of photographs per pixel (lumigraph).
 * @throws CaptureError
 */
export async function createRephotographer(
  gl: WebGL2RenderingContext,
  load: (path: string) => Promise<ArrayBuffer>,
  methods: readonly Method[],
  blended: number,
): Promise<Rephotographer> {
  const bytes = await load(CAPTURE_FILE);
  const { views, mesh: meshFile } = readCapture(new TextDecoder().decode(bytes));
  const capture = await loadCapture(createGlObjects(gl), bytes, CAPTURE_FILE, load, methods.includes('depth-meshes'));
  const mesh = readCaptureMesh(meshFile, await load(meshFile.file));
  const drawingOf = (method: Method): CaptureDrawing =>
    method === 'depth-meshes' ? createDepthMeshDrawing(gl, capture) : createCaptureDrawing(gl, capture, method, blended);
  const drawings = new Map(methods.map((method) => [method, drawingOf(method)]));
  let excluded = -1;
  let colors: WebGLBuffer | null = null;
  return {
    views,
    photo: async (index) => {
      const view = views[index];
      if (!view) throw new Error(`There is no view ${index}.`);
      return pixelsOf(await load(view.file), view);
    },
    leaveOut: (index) => {
      const baked = workAtOnce(bakeColors(gl, capture, mesh, index));
      const before = colors;
      colors = gl.createBuffer();
      gl.bindVertexArray(capture.vertexArray);
      gl.bindBuffer(gl.ARRAY_BUFFER, colors);
      gl.bufferData(gl.ARRAY_BUFFER, baked, gl.STATIC_DRAW);
      gl.vertexAttribPointer(1, 4, gl.UNSIGNED_BYTE, true, 0, 0);
      gl.bindVertexArray(null);
      gl.deleteBuffer(before);
      excluded = index;
    },
    draw: (method, camera) => {
      const { widthPx, heightPx, worldFromCamera: m } = camera;
      if (gl.canvas.width !== widthPx || gl.canvas.height !== heightPx) Object.assign(gl.canvas, { width: widthPx, height: heightPx });
      if (gl.drawingBufferWidth !== widthPx || gl.drawingBufferHeight !== heightPx) {
        throw new Error(`This computer cannot draw images of ${widthPx} × ${heightPx}.`);
      }
      setPassState(gl, null, null, 0, 0, widthPx, heightPx);
      gl.depthMask(true);
      gl.clearColor(0, 0, 0, 0);
      gl.clear(gl.COLOR_BUFFER_BIT | gl.DEPTH_BUFFER_BIT);
      const eye = Float32Array.from(m.slice(12, 15));
      const forward = Float32Array.from(m.slice(8, 11), (x) => -x);
      const target = { framebuffer: null, viewport: { x: 0, y: 0, widthPx, heightPx } };
      drawings.get(method)?.draw(clipFromCapture(camera), eye, forward, target, excluded);
      return readScreen(gl).pixels;
    },
  };
}

async function pixelsOf(bytes: ArrayBuffer, { widthPx, heightPx }: CaptureView): Promise<Uint8ClampedArray> {
  const bitmap = await createImageBitmap(new Blob([bytes]), { colorSpaceConversion: 'none' });
  const context = new OffscreenCanvas(widthPx, heightPx).getContext('2d');
  context?.drawImage(bitmap, 0, 0);
  bitmap.close();
  return context?.getImageData(0, 0, widthPx, heightPx).data ?? new Uint8ClampedArray();
}

const NEAR_M = 0.01;
const FAR_M = 1000;

/** The projection of a photograph’s camera times its inverse pose; column-major 4×4. */
function clipFromCapture({ widthPx, heightPx, fxPx, fyPx, cxPx, cyPx, worldFromCamera: m }: Pinhole): Float32Array {
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
