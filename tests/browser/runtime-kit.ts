import type { NodeOperation, PassOperation, Program, Resource, TargetSize } from '../../export/program/program.ts';
import { createPlayer, type Player, type PlayerOptions } from '../../export/runtime/player.ts';
import { createLoopGuard } from '../../export/runtime/program-instance/loop-watch.ts';
import { createSessionInput } from '../../export/runtime/sessions/input/session-input.ts';
import { createSpatial } from '../../export/runtime/spatial/create-spatial.ts';
import type { Diagnostic } from '../../nodes/kit/diagnostics.ts';
import type { NodeModule } from '../../nodes/kit/runtime.ts';
import type { RoomDepthOutput } from '../../nodes/kit/scene-lists.ts';
import type { SessionFrame, ViewFrame } from '../../nodes/kit/session.ts';

/** Hand-written programs and frames for pages that test the player; no compiler, no session. */

export const WIDTH = 64;
export const HEIGHT = 32;

export function createGl(attributes: WebGLContextAttributes = {}): WebGL2RenderingContext {
  const canvas = document.createElement('canvas');
  canvas.width = WIDTH;
  canvas.height = HEIGHT;
  const gl = canvas.getContext('webgl2', { antialias: false, preserveDrawingBuffer: true, ...attributes });
  if (!gl) throw new Error('no WebGL 2');
  return gl;
}

export const VERTEX = `#version 300 es
out vec2 uv;
void main() {
  uv = vec2((gl_VertexID << 1) & 2, gl_VertexID & 2);
  gl_Position = vec4(uv * 2.0 - 1.0, 0.0, 1.0);
}`;

export function fragment(body: string, declarations = ''): string {
  return `#version 300 es
precision highp float;
in vec2 uv;
out vec4 color;
${declarations}
void main() { ${body} }`;
}

export function shader(id: string, body: string, declarations = ''): Program['shaders'][number] {
  return { id, vertex: VERTEX, fragment: fragment(body, declarations) };
}

export const VIEW_SIZE: TargetSize = { base: 'view', width: [{ op: 'width' }], height: [{ op: 'height' }] };

export function target(id: string, more: Partial<Extract<Resource, { kind: 'target' }>> = {}): Resource {
  return { id, kind: 'target', domain: 'view', size: VIEW_SIZE, format: 'rgba8', depth: 'none', samples: 1, lifetime: 'frame', ...more };
}

export function pass(id: string, index: number, targetId: string, more: Partial<PassOperation> = {}): PassOperation {
  const reads = (more.samplers ?? []).flatMap(({ source }) => {
    if (source.kind === 'import') return [];
    return source.kind === 'depth' ? [source.depth.resource] : [source.resource];
  });
  return {
    kind: 'pass',
    id,
    node: id,
    reads,
    writes: targetId === 'screen' ? [] : [targetId],
    view: 'each',
    shader: index,
    target: targetId,
    blend: 'replace',
    samplers: [],
    uniforms: [],
    passIndex: 0,
    ...more,
  };
}

/** The operation of a source node that bears its type's name and fills one resource. */
export function sourceOperation(type: string, output: string, resource: string, more: Partial<NodeOperation> = {}): NodeOperation {
  return {
    kind: 'source',
    id: type,
    node: type,
    type,
    reads: [],
    writes: [resource],
    view: 'once',
    inputs: {},
    multiple: [],
    outputs: { [output]: { kind: 'resource', resource } },
    params: {},
    config: {},
    assets: {},
    ...more,
  };
}

/** In the place of `world/depth`: hands on what the session measured, for programs written by hand, without slots. */
export const MEASURED_DEPTH: NodeModule = {
  create: ({ outputs }) => {
    const { views } = (outputs as unknown as { readonly depth: RoomDepthOutput }).depth;
    return {
      update: (shown) => {
        for (let i = 0; i < views.length; i++) views[i] = (i < shown.viewCount && shown.views[i]?.depth) || null;
      },
      dispose: () => {},
    };
  },
};

export function colorSampler(
  name: string,
  resource: string,
  fit: 'none' | 'cover' | 'contain' | 'stretch' = 'none',
): PassOperation['samplers'][number] {
  return { name, source: { kind: 'color', resource }, fit };
}

export function program(more: Partial<Program>): Program {
  return {
    format: 'scrim-program',
    version: 1,
    title: 'test',
    slots: { numbers: [], texts: [], slots: [], params: {} },
    resources: [],
    operations: [],
    shaders: [],
    assets: [],
    presentation: { mode: 'composed', antialias: false, background: 'world', blend: 'alpha' },
    needs: [],
    tiers: [],
    taps: {},
    ...more,
  };
}

const IDENTITY_4 = () => new Float32Array([1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1]);

/** A symmetric perspective of 90° with near 0.1 m and far 100 m. */
export function perspective(): Float32Array {
  const near = 0.1;
  const far = 100;
  return new Float32Array([1, 0, 0, 0, 0, 1, 0, 0, 0, 0, (far + near) / (near - far), -1, 0, 0, (2 * far * near) / (near - far), 0]);
}

export function view(x: number, y: number, widthPx: number, heightPx: number, more: Partial<ViewFrame> = {}): ViewFrame {
  return {
    eye: 'none',
    clipFromView: perspective(),
    worldFromView: IDENTITY_4(),
    viewFromWorld: IDENTITY_4(),
    nearM: 0.1,
    farM: 100,
    viewport: { x, y, widthPx, heightPx },
    cameraImage: null,
    depth: null,
    ...more,
  };
}

export function frame(
  index: number,
  views: readonly ViewFrame[] = [view(0, 0, WIDTH, HEIGHT)],
  more: Partial<SessionFrame> = {},
): SessionFrame {
  return {
    index,
    timeS: index / 30,
    deltaS: 1 / 30,
    viewCount: views.length,
    views,
    framebuffer: null,
    framebufferWidthPx: WIDTH,
    framebufferHeightPx: HEIGHT,
    light: null,
    jumps: 0,
    input: createSessionInput(),
    ...more,
  };
}

/** A copy of a frame without the objects of the GPU and the browser. */
export function plainFrame(frame: SessionFrame): SessionFrame {
  return structuredClone({
    ...frame,
    framebuffer: null,
    xr: null,
    input: createSessionInput(),
    light: frame.light && { ...frame.light, reflection: null },
    views: frame.views.map((from) => ({ ...from, depth: null, cameraImage: null })),
  });
}

export interface Stand {
  readonly gl: WebGL2RenderingContext;
  readonly player: Player;
  readonly diagnostics: () => readonly Diagnostic[];
}

/** A player over a context of its own, with its first program ready. */
export async function stand(first: Program, options: Partial<PlayerOptions> & { gl?: WebGL2RenderingContext } = {}): Promise<Stand> {
  const gl = options.gl ?? createGl();
  let diagnostics: readonly Diagnostic[] = [];
  const player = createPlayer({
    canvas: gl.canvas as HTMLCanvasElement,
    program: first,
    modules: {},
    createSpatial,
    createScenes: null,
    assets: { load: () => Promise.reject(new Error('there is no such file')) },
    seed: 1,
    createLoopGuard,
    onDiagnostics: (list) => {
      diagnostics = list;
    },
    ...options,
    gl,
  });
  await player.ready;
  return { gl, player, diagnostics: () => diagnostics };
}

/** RGBA of one pixel of the canvas, origin bottom left. */
export function pixel(gl: WebGL2RenderingContext, x: number, y: number): number[] {
  gl.bindFramebuffer(gl.FRAMEBUFFER, null);
  const out = new Uint8Array(4);
  gl.readPixels(x, y, 1, 1, gl.RGBA, gl.UNSIGNED_BYTE, out);
  return [...out];
}

/** A texture of one row per entry from the bottom, RGBA bytes. */
export function texture(gl: WebGL2RenderingContext, widthPx: number, heightPx: number, bytes: readonly number[]): WebGLTexture {
  const made = gl.createTexture();
  gl.bindTexture(gl.TEXTURE_2D, made);
  gl.pixelStorei(gl.UNPACK_FLIP_Y_WEBGL, false);
  gl.texImage2D(gl.TEXTURE_2D, 0, gl.RGBA8, widthPx, heightPx, 0, gl.RGBA, gl.UNSIGNED_BYTE, new Uint8Array(bytes));
  return made;
}

/** Leaves the GL state as badly as another user of the context could. */
export function upset(gl: WebGL2RenderingContext): void {
  gl.enable(gl.SCISSOR_TEST);
  gl.scissor(0, 0, 1, 1);
  gl.enable(gl.DEPTH_TEST);
  gl.depthFunc(gl.NEVER);
  gl.enable(gl.STENCIL_TEST);
  gl.stencilFunc(gl.NEVER, 0, 0xff);
  gl.enable(gl.CULL_FACE);
  gl.cullFace(gl.FRONT_AND_BACK);
  gl.enable(gl.BLEND);
  gl.blendFunc(gl.ZERO, gl.ZERO);
  gl.colorMask(false, true, false, true);
  gl.depthMask(false);
  gl.clearColor(1, 0, 1, 1);
  gl.enable(gl.RASTERIZER_DISCARD);
  gl.enable(gl.SAMPLE_COVERAGE);
  gl.sampleCoverage(0, false);
  gl.enable(gl.POLYGON_OFFSET_FILL);
  gl.pixelStorei(gl.UNPACK_FLIP_Y_WEBGL, true);
  gl.pixelStorei(gl.UNPACK_ALIGNMENT, 8);
  gl.pixelStorei(gl.UNPACK_ROW_LENGTH, 7);
  gl.pixelStorei(gl.UNPACK_SKIP_PIXELS, 3);
  gl.pixelStorei(gl.PACK_ALIGNMENT, 8);
  gl.activeTexture(gl.TEXTURE5);
  gl.useProgram(null);
}
