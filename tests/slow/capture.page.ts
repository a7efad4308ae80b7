import { compareImages } from '../../export/captures/evaluate/image-quality.ts';
import { createFetchAssetSource } from '../../export/runtime/assets/asset-source.ts';
import { type LoadedCapture, loadCapture } from '../../export/runtime/assets/capture/load-capture.ts';
import { createGlObjects } from '../../export/runtime/gl/gl-objects.ts';
import type { AssetService } from '../../nodes/kit/assets.ts';
import type { CaptureDocument, CaptureView } from '../../nodes/kit/capture.ts';
import { linkProgram } from '../../nodes/kit/link-program.ts';
import { setPassState } from '../../nodes/kit/pass-state.ts';
import type { ViewFrame } from '../../nodes/kit/session.ts';
import { definition } from '../../nodes/source/capture/definition.ts';
import { create } from '../../nodes/source/capture/runtime.ts';
import { createGl, createLayer, drawView } from '../browser/scenes-kit.ts';
import { fakeContext } from '../support/node-context.ts';
import { photoPixels, pictureUrl } from '../support/photo-pixels.page.ts';

export type Method = 'plain' | 'nearest' | 'lumigraph' | 'lumigraph per vertex' | 'depth-meshes' | 'nearest without occlusion';

export interface Rephotograph {
  /** PSNR of each method in dB over the pixels that the mesh covers. */
  readonly psnr: Readonly<Record<string, number>>;
  /** The part of the view that the mesh covers. */
  readonly covered: number;
  readonly error: number;
  readonly loadMs: number;
  readonly drawMs: Readonly<Record<string, number>>;
  /** The part of the pixels at which the depth of the layer differs from that of the mesh by more than 2 %. */
  readonly depthDiffers: Readonly<Record<string, number>>;
  /** A PNG of each method as a data URL, if asked. */
  readonly images: Readonly<Record<string, string>>;
}

/** Renders the photograph `index` of a capture from all others, at its own size. */
export async function rephotograph(
  baseUrl: string,
  index: number,
  methods: readonly Method[],
  keepsImages: boolean,
): Promise<Rephotograph> {
  const source = createFetchAssetSource(new URL(baseUrl, location.href).href, (...args: Parameters<typeof fetch>) => fetch(...args));
  const whole = JSON.parse(new TextDecoder().decode(await source.load('capture.json'))) as CaptureDocument;
  const target = whole.views[index];
  if (!target) throw new Error(`There is no view ${index}.`);
  const others = { ...whole, views: whole.views.filter((view) => view !== target) };
  const { widthPx, heightPx } = target;
  const gl = createGl(widthPx, heightPx);
  const objects = createGlObjects(gl);
  const before = objects.counts();
  const start = performance.now();
  const document = new TextEncoder().encode(JSON.stringify(others)).buffer;
  const capture = await loadCapture(objects, document, 'capture.json', source.load, methods.includes('depth-meshes'));
  gl.finish();
  const loadMs = performance.now() - start;
  const truth = await photoPixels(await source.load(target.file), widthPx, heightPx);
  const psnr: Record<string, number> = {};
  const drawMs: Record<string, number> = {};
  const images: Record<string, string> = {};
  const depthDiffers: Record<string, number> = {};
  let plainM: Float32Array | null = null;
  let covered = 0;
  for (const method of methods) {
    const from = performance.now();
    const { pixels: drawn, depthM } = draw(gl, capture, method, target);
    plainM ??= depthM;
    const meshM = plainM;
    depthDiffers[method] = depthM.filter((depth, i) => !(Math.abs(depth / (meshM[i] ?? 0) - 1) <= 0.02)).length / depthM.length;
    drawMs[method] = performance.now() - from;
    ({ psnrDb: psnr[method], covered } = compareImages({ shown: drawn, truth, widthPx, heightPx }));
    if (keepsImages) images[method] = pictureUrl(drawn, widthPx, heightPx);
  }
  if (keepsImages) images.photograph = pictureUrl(truth, widthPx, heightPx);
  capture.dispose();
  if (JSON.stringify(objects.counts()) !== JSON.stringify(before)) throw new Error('The capture left GL objects.');
  const result = { psnr, covered, error: gl.getError(), loadMs, drawMs, depthDiffers, images };
  gl.getExtension('WEBGL_lose_context')?.loseContext();
  return result;
}

/** PSNR in dB of a capture that is drawn as depth meshes against the lumigraph, from one camera. */
export async function compareMethods(baseUrl: string, target: CaptureView): Promise<number> {
  const source = createFetchAssetSource(new URL(baseUrl, location.href).href, (...args: Parameters<typeof fetch>) => fetch(...args));
  const { widthPx, heightPx } = target;
  const gl = createGl(widthPx, heightPx);
  const capture = await loadCapture(createGlObjects(gl), await source.load('capture.json'), 'capture.json', source.load, true);
  const [shown, truth] = [draw(gl, capture, 'depth-meshes', target).pixels, draw(gl, capture, 'lumigraph', target).pixels];
  capture.dispose();
  gl.getExtension('WEBGL_lose_context')?.loseContext();
  return compareImages({ shown, truth, widthPx, heightPx }).psnrDb;
}

/** Draws a capture by one method from the camera of a view, at its size. */
export function draw(gl: WebGL2RenderingContext, capture: LoadedCapture, method: Method, target: CaptureView) {
  const { shaderSource } = gl;
  if (method === 'nearest without occlusion') {
    gl.shaderSource = (shader, text) => shaderSource.call(gl, shader, text.replace('DEPTH_TOLERANCE = 0.02', 'DEPTH_TOLERANCE = 1e9'));
  }
  const handle = { kind: 'capture', value: capture, settled: Promise.resolve(), release: () => {} } as const;
  const service = { capture: () => handle } as Partial<AssetService> as AssetService;
  const params = {
    file: 'place',
    method: method.replace(' without occlusion', '').replace(' per vertex', ''),
    updateFrames: method === 'lumigraph per vertex' ? 1 : 0,
  };
  const node = create(fakeContext(definition, { params, services: { gl, assets: service } }).ctx);
  const layer = createLayer(gl, target.widthPx, target.heightPx);
  layer.clear();
  setPassState(gl, layer.framebuffer, null, 0, 0, target.widthPx, target.heightPx);
  node.draw?.(drawView(viewOfCamera(target), layer.framebuffer));
  gl.shaderSource = shaderSource;
  const pixels = layer.pixels();
  const depthM = layerDepth(gl, layer.depth, target.widthPx, target.heightPx);
  layer.dispose();
  node.dispose();
  return { pixels, depthM };
}

/** The depth of a layer in meters. */
function layerDepth(gl: WebGL2RenderingContext, depth: WebGLTexture, widthPx: number, heightPx: number): Float32Array {
  const program = linkProgram(
    gl,
    `#version 300 es
    void main() { gl_Position = vec4(vec2(gl_VertexID & 1, gl_VertexID >> 1) * 4.0 - 1.0, 0.0, 1.0); }`,
    `#version 300 es
    precision highp float;
    uniform highp sampler2D depth;
    out vec4 window;
    void main() { window = vec4(texelFetch(depth, ivec2(gl_FragCoord.xy), 0).r); }`,
  );
  const copy = gl.createTexture();
  const framebuffer = gl.createFramebuffer();
  gl.activeTexture(gl.TEXTURE0);
  gl.bindTexture(gl.TEXTURE_2D, copy);
  gl.texStorage2D(gl.TEXTURE_2D, 1, gl.RGBA32F, widthPx, heightPx);
  gl.bindFramebuffer(gl.FRAMEBUFFER, framebuffer);
  gl.framebufferTexture2D(gl.FRAMEBUFFER, gl.COLOR_ATTACHMENT0, gl.TEXTURE_2D, copy, 0);
  gl.bindTexture(gl.TEXTURE_2D, depth);
  setPassState(gl, framebuffer, null, 0, 0, widthPx, heightPx);
  gl.useProgram(program);
  gl.drawArrays(gl.TRIANGLES, 0, 3);
  const window = new Float32Array(4 * widthPx * heightPx);
  gl.readPixels(0, 0, widthPx, heightPx, gl.RGBA, gl.FLOAT, window);
  gl.deleteProgram(program);
  gl.deleteFramebuffer(framebuffer);
  gl.deleteTexture(copy);
  return Float32Array.from(
    { length: widthPx * heightPx },
    (_, i) => (2 * NEAR_M * FAR_M) / (FAR_M + NEAR_M - (2 * (window[4 * i] ?? 0) - 1) * (FAR_M - NEAR_M)),
  );
}

const NEAR_M = 0.01;
const FAR_M = 100;

/** The view of a photograph's camera. */
function viewOfCamera({ widthPx, heightPx, fxPx, fyPx, cxPx, cyPx, worldFromCamera: m }: CaptureView): ViewFrame {
  const at = (row: number, column: number): number => m[4 * column + row] ?? 0;
  const inverse = [0, 1, 2, 3].flatMap((column) =>
    [0, 1, 2]
      .map((row) => (column < 3 ? at(column, row) : -[0, 1, 2].reduce((sum, i) => sum + at(i, row) * at(i, 3), 0)))
      .concat(column < 3 ? 0 : 1),
  );
  // prettier: rows of columns
  const clipFromView = [
    ...[(2 * fxPx) / widthPx, 0, 0, 0],
    ...[0, (2 * fyPx) / heightPx, 0, 0],
    ...[1 - (2 * cxPx) / widthPx, (2 * cyPx) / heightPx - 1, -(FAR_M + NEAR_M) / (FAR_M - NEAR_M), -1],
    ...[0, 0, (-2 * FAR_M * NEAR_M) / (FAR_M - NEAR_M), 0],
  ];
  return {
    eye: 'none',
    clipFromView: Float32Array.from(clipFromView),
    worldFromView: Float32Array.from(m),
    viewFromWorld: Float32Array.from(inverse),
    nearM: NEAR_M,
    farM: FAR_M,
    viewport: { x: 0, y: 0, widthPx, heightPx },
    cameraImage: null,
    depth: null,
  };
}
