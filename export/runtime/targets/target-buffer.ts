import type { Resource } from '../../program/program.ts';
import { allocateTexture } from '../gl/allocate-texture.ts';
import type { GlLimits, GlObjects } from '../gl/gl-objects.ts';
import type { Multisampling } from './multisampling.ts';

export type TargetResource = Extract<Resource, { kind: 'target' }>;

/** Textures and framebuffers of a target with one size, including renderbuffers if it is multisampled. */
export interface TargetBuffer {
  readonly widthPx: number;
  readonly heightPx: number;
  readonly color: WebGLTexture;
  /** Whether it has depth. */
  readonly hasDepth: boolean;
  /** The framebuffer to draw to. */
  readonly framebuffer: WebGLFramebuffer;
  /** Framebuffer with `color`; the same as `framebuffer` without multisampling. */
  readonly resolvedFramebuffer: WebGLFramebuffer;
  /** Resolves the multisampled color to its texture; does nothing without multisampling. */
  resolve(): void;
  /**
   * Window-space depth of the nearest covered sample, or null if the target has none. With multisampling, the first call after `resolve`
   * draws the depth, which binds framebuffers; further calls only return it. The samples must not have been drawn over by another target
   * since. Memory for it is allocated at the first call, because few layers need it.
   */
  readDepth(): WebGLTexture | null;
  dispose(): void;
}

/** Creates a transparent buffer. Leaves its framebuffer bound. Without `multisampling` it has one sample; see there for `ownSamples`. */
export function createTargetBuffer(
  objects: GlObjects,
  resource: TargetResource,
  widthPx: number,
  heightPx: number,
  multisampling: Multisampling | null = null,
  ownSamples = false,
): TargetBuffer {
  const { gl, limits } = objects;
  const format = colorFormat(gl, resource, limits);
  const color = allocateTexture(gl, objects.createTexture(), format.internal, format.filter, widthPx, heightPx);
  const hasDepth = resource.depth === 'window';
  const samples = resource.samples > 1 && multisampling ? Math.min(resource.samples, maxSamplesOf(gl, format.internal, limits)) : 1;
  const depth =
    hasDepth && samples <= 1 ? allocateTexture(gl, objects.createTexture(), gl.DEPTH_COMPONENT24, gl.NEAREST, widthPx, heightPx) : null;
  const resolvedFramebuffer = objects.createFramebuffer();
  gl.bindFramebuffer(gl.FRAMEBUFFER, resolvedFramebuffer);
  gl.framebufferTexture2D(gl.FRAMEBUFFER, gl.COLOR_ATTACHMENT0, gl.TEXTURE_2D, color, 0);
  if (depth) gl.framebufferTexture2D(gl.FRAMEBUFFER, gl.DEPTH_ATTACHMENT, gl.TEXTURE_2D, depth, 0);

  const multisampled =
    samples > 1 && multisampling
      ? multisampling.createBuffer({ internal: format.internal, withDepth: hasDepth, samples, widthPx, heightPx }, ownSamples)
      : null;
  return {
    widthPx,
    heightPx,
    color,
    hasDepth,
    framebuffer: multisampled?.framebuffer ?? resolvedFramebuffer,
    resolvedFramebuffer,
    resolve: () => multisampled?.resolve(resolvedFramebuffer),
    readDepth: () => (multisampled ? multisampled.readDepth() : depth),
    dispose: () => {
      multisampled?.dispose();
      objects.deleteFramebuffer(resolvedFramebuffer);
      objects.deleteTexture(color);
      if (depth) objects.deleteTexture(depth);
    },
  };
}

/**
 * The format of a target's color texture on this GPU. `rgba32f` is stored in 32-bit floats if those can be filtered, else in 16-bit floats.
 * Without 32-bit float targets, meters are stored in 16 bits (1 mm at 1 m); without any float targets, color and depth are clamped, and
 * scene layers are too (SCR055). Every WebGL 2 device seen since 2020 renders to 16-bit float.
 */
function colorFormat(gl: WebGL2RenderingContext, resource: TargetResource, limits: GlLimits): { internal: GLenum; filter: GLenum } {
  switch (resource.format) {
    case 'rgba8':
      return { internal: gl.RGBA8, filter: gl.LINEAR };
    case 'scene16f':
      // Linear colors in 8 bits would show bands; the GPU converts those of an sRGB texture.
      return { internal: limits.halfFloatTargets ? gl.RGBA16F : gl.SRGB8_ALPHA8, filter: gl.LINEAR };
    case 'rgba16f':
      return { internal: limits.halfFloatTargets ? gl.RGBA16F : gl.RGBA8, filter: gl.LINEAR };
    case 'rgba32f':
      if (limits.floatTargets && limits.floatLinear) return { internal: gl.RGBA32F, filter: gl.LINEAR };
      return { internal: limits.halfFloatTargets ? gl.RGBA16F : gl.RGBA8, filter: gl.LINEAR };
    case 'r32f':
      return { internal: limits.floatTargets ? gl.R32F : limits.halfFloatTargets ? gl.R16F : gl.R8, filter: gl.NEAREST };
  }
}

/** Maximum number of samples of a format. Devices need not support multisampling of 16-bit floats. */
function maxSamplesOf(gl: WebGL2RenderingContext, format: GLenum, { maxSamples }: GlLimits): number {
  if (format !== gl.RGBA16F) return maxSamples;
  const counts = gl.getInternalformatParameter(gl.RENDERBUFFER, format, gl.SAMPLES) as Int32Array | null;
  return counts?.[0] ?? 1;
}
