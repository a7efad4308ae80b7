import type { Resource } from '../../program/program.ts';
import { allocateTexture } from '../gl/allocate-texture.ts';
import type { GlLimits, GlObjects } from '../gl/gl-objects.ts';

export type TargetResource = Extract<Resource, { kind: 'target' }>;

/** Textures and framebuffers of a target with one size, including renderbuffers if it is multisampled. */
export interface TargetBuffer {
  readonly widthPx: number;
  readonly heightPx: number;
  readonly color: WebGLTexture;
  /** Window-space depth; null if the target has none. */
  readonly depth: WebGLTexture | null;
  /** The framebuffer to draw to. */
  readonly framebuffer: WebGLFramebuffer;
  /** Framebuffer with `color` and `depth`; the same as `framebuffer` without multisampling. */
  readonly resolvedFramebuffer: WebGLFramebuffer;
  /** Resolves the multisampled image to the textures; does nothing without multisampling. */
  resolve(): void;
  dispose(): void;
}

/** Creates a transparent buffer. Leaves its framebuffer bound. */
export function createTargetBuffer(objects: GlObjects, resource: TargetResource, widthPx: number, heightPx: number): TargetBuffer {
  const { gl, limits } = objects;
  const format = colorFormat(gl, resource, limits);
  const color = allocateTexture(gl, objects.createTexture(), format.internal, format.filter, widthPx, heightPx);
  const depth =
    resource.depth === 'window' ? allocateTexture(gl, objects.createTexture(), gl.DEPTH_COMPONENT24, gl.NEAREST, widthPx, heightPx) : null;
  const resolvedFramebuffer = objects.createFramebuffer();
  gl.bindFramebuffer(gl.FRAMEBUFFER, resolvedFramebuffer);
  gl.framebufferTexture2D(gl.FRAMEBUFFER, gl.COLOR_ATTACHMENT0, gl.TEXTURE_2D, color, 0);
  if (depth) gl.framebufferTexture2D(gl.FRAMEBUFFER, gl.DEPTH_ATTACHMENT, gl.TEXTURE_2D, depth, 0);

  const samples = Math.min(resource.samples, limits.maxSamples);
  const multisampled = samples > 1 ? createMultisampled(objects, format.internal, depth !== null, samples, widthPx, heightPx) : null;
  const mask = gl.COLOR_BUFFER_BIT | (depth ? gl.DEPTH_BUFFER_BIT : 0);
  return {
    widthPx,
    heightPx,
    color,
    depth,
    framebuffer: multisampled?.framebuffer ?? resolvedFramebuffer,
    resolvedFramebuffer,
    resolve: () => {
      if (!multisampled) return;
      // The scissor test also limits a blit.
      gl.disable(gl.SCISSOR_TEST);
      gl.bindFramebuffer(gl.READ_FRAMEBUFFER, multisampled.framebuffer);
      gl.bindFramebuffer(gl.DRAW_FRAMEBUFFER, resolvedFramebuffer);
      gl.blitFramebuffer(0, 0, widthPx, heightPx, 0, 0, widthPx, heightPx, mask, gl.NEAREST);
    },
    dispose: () => {
      multisampled?.dispose();
      objects.deleteFramebuffer(resolvedFramebuffer);
      objects.deleteTexture(color);
      if (depth) objects.deleteTexture(depth);
    },
  };
}

/**
 * Numbers are stored in 32-bit floats if those can be filtered, else in 16. Without 32-bit float targets, meters are stored in 16 bits (1
 * mm at 1 m); without any float targets, color and depth are clamped. Every WebGL 2 device seen since 2020 renders to 16-bit float.
 */
function colorFormat(gl: WebGL2RenderingContext, resource: TargetResource, limits: GlLimits): { internal: GLenum; filter: GLenum } {
  switch (resource.format) {
    case 'rgba8':
      return { internal: gl.RGBA8, filter: gl.LINEAR };
    case 'rgba16f':
      return { internal: limits.halfFloatTargets ? gl.RGBA16F : gl.RGBA8, filter: gl.LINEAR };
    case 'rgba32f':
      if (limits.floatTargets && limits.floatLinear) return { internal: gl.RGBA32F, filter: gl.LINEAR };
      return { internal: limits.halfFloatTargets ? gl.RGBA16F : gl.RGBA8, filter: gl.LINEAR };
    case 'r32f':
      return { internal: limits.floatTargets ? gl.R32F : limits.halfFloatTargets ? gl.R16F : gl.R8, filter: gl.NEAREST };
  }
}

interface Multisampled {
  readonly framebuffer: WebGLFramebuffer;
  dispose(): void;
}

function createMultisampled(
  objects: GlObjects,
  internal: GLenum,
  withDepth: boolean,
  samples: number,
  widthPx: number,
  heightPx: number,
): Multisampled {
  const { gl } = objects;
  const framebuffer = objects.createFramebuffer();
  gl.bindFramebuffer(gl.FRAMEBUFFER, framebuffer);
  const attach = (attachment: GLenum, format: GLenum): WebGLRenderbuffer => {
    const renderbuffer = objects.createRenderbuffer();
    gl.bindRenderbuffer(gl.RENDERBUFFER, renderbuffer);
    gl.renderbufferStorageMultisample(gl.RENDERBUFFER, samples, format, widthPx, heightPx);
    gl.framebufferRenderbuffer(gl.FRAMEBUFFER, attachment, gl.RENDERBUFFER, renderbuffer);
    return renderbuffer;
  };
  const color = attach(gl.COLOR_ATTACHMENT0, internal);
  const depth = withDepth ? attach(gl.DEPTH_ATTACHMENT, gl.DEPTH_COMPONENT24) : null;
  return {
    framebuffer,
    dispose: () => {
      objects.deleteFramebuffer(framebuffer);
      objects.deleteRenderbuffer(color);
      if (depth) objects.deleteRenderbuffer(depth);
    },
  };
}
