import { loadSplats } from '../../export/runtime/assets/splats/load-splats.ts';
import { createGlObjects } from '../../export/runtime/gl/gl-objects.ts';
import type { ParamValue } from '../../nodes/kit/definition.ts';
import { setPassState } from '../../nodes/kit/pass-state.ts';
import type { SessionFrame, ViewFrame } from '../../nodes/kit/session.ts';
import { definition } from '../../nodes/source/splats/definition.ts';
import { create } from '../../nodes/source/splats/runtime.ts';
import { fakeContext } from '../support/node-context.ts';
import { createGl, createLayer, drawView, lookingAt, room, viewOf } from './scenes-kit.ts';

export interface SplatShotOptions {
  /** The file: PLY, SOG or the form of pages. */
  readonly bytes: Uint8Array;
  readonly name: string;
  readonly params?: Readonly<Record<string, ParamValue>>;
  readonly eye?: readonly [number, number, number];
  readonly target?: readonly [number, number, number];
  readonly widthPx?: number;
  readonly heightPx?: number;
  /** Room depth in meters of columns of equal width, from the left. */
  readonly roomM?: readonly number[];
  readonly softnessM?: number;
  /** Part of the framebuffer that the view has. */
  readonly viewport?: { readonly x: number; readonly y: number; readonly widthPx: number; readonly heightPx: number };
}

export interface SplatShot {
  /** Premultiplied RGBA, rows from the bottom. */
  readonly pixels: Uint8Array;
  /** Meters, 0 where there is no depth. */
  readonly depthM: Float32Array;
  readonly count: number;
  readonly findings: readonly string[];
  readonly clipFromView: readonly number[];
  readonly viewFromWorld: readonly number[];
}

/** A browser that starts no workers: the node sorts itself. */
const NO_WORKERS = {
  start: () => {
    throw new Error('No worker.');
  },
};

/** What the node draws of a file. */
export async function draw(options: SplatShotOptions): Promise<SplatShot | { readonly error: string }> {
  const { bytes, name, eye = [0, 0, 0], target = [0, 0, -1], widthPx = 160, heightPx = 120 } = options;
  const gl = createGl(1, 1);
  const objects = createGlObjects(gl);
  const before = JSON.stringify(objects.counts());
  const loaded = await loadSplats(objects, Uint8Array.from(bytes).buffer, name).catch((error: Error) => error);
  if (loaded instanceof Error) return { error: loaded.message };
  const { viewport = { x: 0, y: 0, widthPx, heightPx } } = options;
  const view = viewOf(lookingAt(eye, target, viewport.widthPx / viewport.heightPx), viewport);
  const occlusion = options.roomM && occlusionOf(gl, options.roomM, options.softnessM ?? 0);
  const handle = { kind: 'splats', value: loaded, settled: Promise.resolve(), release: () => {} } as const;
  const { ctx } = fakeContext(definition, {
    params: { file: 'splats', up: 'y', ...options.params },
    services: { gl, assets: { splats: () => handle } as never, workers: NO_WORKERS, occlusion: occlusion ?? null },
  });
  const node = create(ctx);
  const layer = createLayer(gl, widthPx, heightPx);
  layer.clear();
  node.update({ viewCount: 1, views: [view] } as unknown as SessionFrame);
  await node.settle?.();
  setPassState(gl, layer.framebuffer, null, viewport.x, viewport.y, viewport.widthPx, viewport.heightPx);
  node.draw?.(drawView(view, layer.framebuffer));
  const shot = {
    pixels: layer.pixels(),
    depthM: readDepth(gl, layer.depth, widthPx, heightPx, view),
    count: loaded.count,
    findings: loaded.findings.map(({ message }) => message),
    clipFromView: [...view.clipFromView],
    viewFromWorld: [...view.viewFromWorld],
  };
  node.dispose();
  loaded.dispose();
  if (JSON.stringify(objects.counts()) !== before) throw new Error('The splats left GL objects.');
  if (gl.getError() !== gl.NO_ERROR) throw new Error('The context reports an error.');
  gl.getExtension('WEBGL_lose_context')?.loseContext();
  return shot;
}

function occlusionOf(gl: WebGL2RenderingContext, metersOfColumns: readonly number[], softnessM: number) {
  const depth = room(gl, metersOfColumns.length, 1, [...metersOfColumns]);
  const number = (value: number) => ({ value });
  return { roomDepth: { views: [depth] }, params: { softnessM: number(softnessM), biasM: number(0), borderPx: number(0) } };
}

/** The depth buffer in meters. */
function readDepth(gl: WebGL2RenderingContext, depth: WebGLTexture, widthPx: number, heightPx: number, view: ViewFrame): Float32Array {
  const program = gl.createProgram();
  for (const [type, text] of [
    [
      gl.VERTEX_SHADER,
      '#version 300 es\nvoid main() { gl_Position = vec4(vec2(gl_VertexID & 1, gl_VertexID >> 1) * 4.0 - 1.0, 0.0, 1.0); }',
    ],
    [
      gl.FRAGMENT_SHADER,
      '#version 300 es\nprecision highp float;\nuniform highp sampler2D depth;\nout vec4 color;\nvoid main() { color = vec4(texelFetch(depth, ivec2(gl_FragCoord.xy), 0).r); }',
    ],
  ] as const) {
    const shader = gl.createShader(type) as WebGLShader;
    gl.shaderSource(shader, text);
    gl.compileShader(shader);
    gl.attachShader(program, shader);
  }
  gl.linkProgram(program);
  const framebuffer = gl.createFramebuffer();
  const texture = gl.createTexture();
  gl.activeTexture(gl.TEXTURE0);
  gl.bindTexture(gl.TEXTURE_2D, texture);
  gl.texStorage2D(gl.TEXTURE_2D, 1, gl.RGBA32F, widthPx, heightPx);
  setPassState(gl, framebuffer, null, 0, 0, widthPx, heightPx);
  gl.framebufferTexture2D(gl.FRAMEBUFFER, gl.COLOR_ATTACHMENT0, gl.TEXTURE_2D, texture, 0);
  gl.bindTexture(gl.TEXTURE_2D, depth);
  gl.useProgram(program);
  gl.drawArrays(gl.TRIANGLES, 0, 3);
  const values = new Float32Array(4 * widthPx * heightPx);
  gl.readPixels(0, 0, widthPx, heightPx, gl.RGBA, gl.FLOAT, values);
  const [scale = 0, offset = 0] = [view.clipFromView[10], view.clipFromView[14]];
  return Float32Array.from({ length: widthPx * heightPx }, (_, i) => {
    const window = values[4 * i] ?? 1;
    return window === 1 ? 0 : offset / (2 * window - 1 + scale);
  });
}
