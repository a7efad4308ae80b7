import type { LayerEncoding } from '../../nodes/kit/definition.ts';
import { IDENTITY } from '../../nodes/kit/matrices.ts';
import type { LinkedShader, ResourceId } from '../program/program.ts';
import type { Engine } from './engine.ts';
import { COPY_SAMPLER, COPY_SHADER, COPY_UV, copyShaderFor } from './gl/copy-shader.ts';
import type { GlProgram } from './gl/program-cache.ts';
import { prepareReadback } from './gl/upload.ts';
import type { Inspected } from './inspected.ts';
import { setDecode } from './passes/depth-decode.ts';
import type { PlayState } from './play-state.ts';
import type { LiveResources } from './resources/resources.ts';
import { createTargetBuffer, type TargetResource } from './targets/target-buffer.ts';

/**
 * Pixels of a layer: premultiplied display-referred sRGB, RGBA, rows from the top. Pixels of a scene layer are clamped to what a screen can
 * show.
 */
export interface LayerPixels {
  readonly widthPx: number;
  readonly heightPx: number;
  readonly pixels: Uint8Array<ArrayBuffer>;
}

/** Depth of a layer: positive view-space meters, 0 where there is nothing, rows from the top. */
export interface LayerDepth {
  readonly widthPx: number;
  readonly heightPx: number;
  readonly meters: Float32Array<ArrayBuffer>;
}

/**
 * Decodes a depth texture and writes meters to the red channel. The texture is read through a UV matrix, like the image in `COPY_SHADER`.
 */
export const DEPTH_SHADER: LinkedShader = {
  id: 'scrim:read-depth',
  vertex: COPY_SHADER.vertex,
  fragment: /* glsl */ `#version 300 es
precision highp float;
uniform highp sampler2D depth;
uniform vec4 depth_decode;
uniform mat3 picture_uvFromViewUv;
in vec2 viewUv;
out vec4 meters;
void main() {
  vec3 uv = picture_uvFromViewUv * vec3(viewUv, 1.0);
  float d = texture(depth, uv.xy / uv.z).r;
  float m = depth_decode.w == 0.0 ? d : d < 1.0 ? depth_decode.y / (2.0 * d - 1.0 + depth_decode.x) : 0.0;
  meters = vec4(m, 0.0, 0.0, 1.0);
}
`,
};

/** Reads the context's default framebuffer, within the frame. */
export function readScreen(gl: WebGL2RenderingContext): LayerPixels {
  const { drawingBufferWidth: widthPx, drawingBufferHeight: heightPx } = gl;
  const rows = new Uint8Array(widthPx * heightPx * 4);
  gl.bindFramebuffer(gl.FRAMEBUFFER, null);
  gl.bindBuffer(gl.PIXEL_PACK_BUFFER, null);
  gl.pixelStorei(gl.PACK_ALIGNMENT, 4);
  gl.readPixels(0, 0, widthPx, heightPx, gl.RGBA, gl.UNSIGNED_BYTE, rows);
  const pixels = new Uint8Array(rows.length);
  const rowBytes = widthPx * 4;
  for (let y = 0; y < heightPx; y++) pixels.set(rows.subarray(y * rowBytes, (y + 1) * rowBytes), (heightPx - 1 - y) * rowBytes);
  return { widthPx, heightPx, pixels };
}

/**
 * The current image of a layer; null if it is not viewed or was not drawn. `heightPx` scales it with its aspect ratio. Camera images of
 * WebXR are readable only until the frame's callback ends.
 */
export function readColor(inspected: Inspected | null, viewIndex: number, heightPx?: number): LayerPixels | null {
  if (!inspected?.layer) return null;
  const { engine, resources, layer } = inspected;
  const picture = findImage(engine.state, resources, layer.color, viewIndex);
  if (!picture) return null;
  const scale = heightPx === undefined ? 1 : heightPx / picture.heightPx;
  const width = Math.max(1, Math.round(picture.widthPx * scale));
  const height = Math.max(1, Math.round(picture.heightPx * scale));
  const read = (framebuffer: WebGLFramebuffer): LayerPixels => {
    const pixels = new Uint8Array(width * height * 4);
    readRows(engine.objects.gl, framebuffer, width, height, pixels);
    return { widthPx: width, heightPx: height, pixels };
  };
  // Reads the framebuffer directly if possible, because sampling could round differently.
  if (picture.framebuffer && scale === 1) return read(picture.framebuffer);
  return drawn(engine, copyShaderFor(picture.encoding), 'rgba8', width, height, read, (program) => {
    const { gl } = engine.objects;
    const location = program.uniform(COPY_SAMPLER);
    if (location) engine.drawer.texture(0, location, picture.texture, 'linear');
    gl.uniformMatrix3fv(program.uniform(COPY_UV), false, picture.uvFromViewUv);
  });
}

/**
 * The depth of a layer; null if it has none or was not drawn.
 *
 * @throws Error if the GPU cannot render to 32-bit floats.
 */
export function readDepth(inspected: Inspected | null, viewIndex: number): LayerDepth | null {
  if (!inspected?.layer) return null;
  const { engine, resources, layer } = inspected;
  const { gl, limits } = engine.objects;
  if (!limits.floatTargets) throw new Error('This GPU cannot draw 32-bit floats, so depth cannot be read back.');
  const { depth } = layer;
  const resource = depth ? resources.get(depth.resource) : undefined;
  const buffer = resource?.kind === 'target' ? resource.target.peek(resource.domain === 'view' ? viewIndex : 0) : null;
  const texture = depth?.encoding === 'window' ? buffer?.readDepth() : buffer?.color;
  if (!depth || !buffer || !texture) return null;
  const { widthPx, heightPx } = buffer;
  const read = (framebuffer: WebGLFramebuffer): LayerDepth => {
    // The format RED may not be readable; RGBA float always is.
    const rgba = new Float32Array(widthPx * heightPx * 4);
    readRows(gl, framebuffer, widthPx, heightPx, rgba);
    return { widthPx, heightPx, meters: Float32Array.from({ length: widthPx * heightPx }, (_, i) => rgba[i * 4] ?? 0) };
  };
  return drawn(engine, DEPTH_SHADER, 'r32f', widthPx, heightPx, read, (program) => {
    const location = program.uniform('depth');
    const decode = program.uniform('depth_decode');
    if (location) engine.drawer.texture(0, location, texture, 'nearest');
    if (decode) setDecode(gl, decode, depth.encoding, engine.state.frame.views[viewIndex]?.clipFromView);
    gl.uniformMatrix3fv(program.uniform(COPY_UV), false, IDENTITY);
  });
}

export interface Picture {
  readonly texture: WebGLTexture;
  /** A framebuffer from which the bytes can be read as they are; null if the texture must be drawn to another target first. */
  readonly framebuffer: WebGLFramebuffer | null;
  readonly widthPx: number;
  readonly heightPx: number;
  readonly uvFromViewUv: Float32Array;
  readonly encoding: LayerEncoding;
}

/** The current texture of a layer; null if it was not drawn. */
export function findImage(state: PlayState, resources: LiveResources, id: ResourceId, viewIndex: number): Picture | null {
  const resource = resources.get(id);
  if (resource?.kind === 'target') {
    const buffer = resource.target.peek(resource.domain === 'view' ? viewIndex : 0);
    if (!buffer) return null;
    const { color: texture, widthPx, heightPx, resolvedFramebuffer } = buffer;
    const { format } = resource.target.resource;
    const framebuffer = format === 'rgba8' ? resolvedFramebuffer : null;
    const encoding = format === 'scene16f' ? 'scene' : 'display';
    return { texture, framebuffer, widthPx, heightPx, uvFromViewUv: IDENTITY, encoding };
  }
  if (resource?.kind !== 'external') return null;
  const view = resource.layer.views[resource.domain === 'view' ? viewIndex : 0];
  if (!view?.texture) return null;
  // A layer of the view domain has the size of the view, whatever that of its texture.
  const viewport = resource.domain === 'view' ? state.frame.views[viewIndex]?.viewport : undefined;
  const { widthPx, heightPx } = viewport ?? view;
  return { texture: view.texture, framebuffer: null, widthPx, heightPx, uvFromViewUv: view.uvFromViewUv, encoding: 'display' };
}

/** Draws with a shader to a temporary target, passes its framebuffer to `read`, and returns the result. */
export function drawn<T>(
  engine: Engine,
  shader: LinkedShader,
  format: TargetResource['format'],
  widthPx: number,
  heightPx: number,
  read: (framebuffer: WebGLFramebuffer) => T,
  setUp: (program: GlProgram) => void,
): T {
  const { drawer } = engine;
  const program = engine.tool(shader);
  const buffer = createTargetBuffer(engine.objects, scratchTarget(format), widthPx, heightPx);
  drawer.begin(buffer.framebuffer, 0, 0, widthPx, heightPx, 'replace');
  drawer.use(program);
  setUp(program);
  drawer.draw();
  drawer.end();
  const result = read(buffer.framebuffer);
  buffer.dispose();
  return result;
}

function scratchTarget(format: TargetResource['format']): TargetResource {
  const size = { base: 'view', width: [{ op: 'width' }], height: [{ op: 'height' }] } as const;
  return { id: 'scrim:read', kind: 'target', domain: 'image', size, format, depth: 'none', samples: 1, lifetime: 'frame' };
}

/** Reads RGBA rows, top row first. */
export function readRows<T extends Uint8Array | Float32Array>(
  gl: WebGL2RenderingContext,
  framebuffer: WebGLFramebuffer,
  widthPx: number,
  heightPx: number,
  out: T,
): void {
  prepareReadback(gl);
  gl.bindFramebuffer(gl.FRAMEBUFFER, framebuffer);
  gl.readPixels(0, 0, widthPx, heightPx, gl.RGBA, out instanceof Uint8Array ? gl.UNSIGNED_BYTE : gl.FLOAT, out);
  const stride = widthPx * 4;
  const row = out.slice(0, stride);
  for (let top = 0, bottom = heightPx - 1; top < bottom; top++, bottom--) {
    row.set(out.subarray(top * stride, (top + 1) * stride));
    out.copyWithin(top * stride, bottom * stride, (bottom + 1) * stride);
    out.set(row, bottom * stride);
  }
}
