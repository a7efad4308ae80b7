import type { LayerTargetOptions } from './layer-target.ts';

/** A framebuffer of the device with its attachments. Its functions change bindings of the context. */
export interface LayerStorage {
  readonly framebuffer: WebGLFramebuffer;
  /** Allocates the attachments at this size, in pixels, and frees the previous ones. */
  allocate(widthPx: number, heightPx: number): void;
  /** Binds a framebuffer with the image for `readPixels`; if the image is multisampled, it is first resolved into that framebuffer. */
  bindForReading(widthPx: number, heightPx: number): void;
  dispose(): void;
}

const SAMPLES = 4;

/** The storage of a WebGL 2 context: renderbuffers, with multisampling if the options ask for antialiasing. */
export function createWebGl2Storage(gl: WebGL2RenderingContext, { antialias, depth, stencil, alpha }: LayerTargetOptions): LayerStorage {
  const buffers: WebGLRenderbuffer[] = [];
  const colorFormat = alpha ? gl.RGBA8 : gl.RGB8;
  const samples = antialias ? Math.min(SAMPLES, gl.getParameter(gl.MAX_SAMPLES) as number) : 0;
  const framebuffer = gl.createFramebuffer();
  const resolved = samples > 0 ? gl.createFramebuffer() : null;
  const free = (): void => {
    for (const buffer of buffers.splice(0)) gl.deleteRenderbuffer(buffer);
  };
  return {
    framebuffer,
    allocate: (widthPx, heightPx) => {
      const attach = (attachment: GLenum, format: GLenum, sampleCount: number): void => {
        const buffer = gl.createRenderbuffer();
        buffers.push(buffer);
        gl.bindRenderbuffer(gl.RENDERBUFFER, buffer);
        if (sampleCount > 0) gl.renderbufferStorageMultisample(gl.RENDERBUFFER, sampleCount, format, widthPx, heightPx);
        else gl.renderbufferStorage(gl.RENDERBUFFER, format, widthPx, heightPx);
        gl.framebufferRenderbuffer(gl.FRAMEBUFFER, attachment, gl.RENDERBUFFER, buffer);
      };
      free();
      gl.bindFramebuffer(gl.FRAMEBUFFER, framebuffer);
      attach(gl.COLOR_ATTACHMENT0, colorFormat, samples);
      if (depth && stencil) attach(gl.DEPTH_STENCIL_ATTACHMENT, gl.DEPTH24_STENCIL8, samples);
      else if (depth) attach(gl.DEPTH_ATTACHMENT, gl.DEPTH_COMPONENT24, samples);
      else if (stencil) attach(gl.STENCIL_ATTACHMENT, gl.STENCIL_INDEX8, samples);
      if (!resolved) return;
      gl.bindFramebuffer(gl.FRAMEBUFFER, resolved);
      attach(gl.COLOR_ATTACHMENT0, colorFormat, 0);
    },
    bindForReading: (widthPx, heightPx) => {
      gl.bindFramebuffer(gl.READ_FRAMEBUFFER, framebuffer);
      if (!resolved) return;
      gl.bindFramebuffer(gl.DRAW_FRAMEBUFFER, resolved);
      gl.blitFramebuffer(0, 0, widthPx, heightPx, 0, 0, widthPx, heightPx, gl.COLOR_BUFFER_BIT, gl.NEAREST);
      gl.bindFramebuffer(gl.READ_FRAMEBUFFER, resolved);
    },
    dispose: () => {
      gl.deleteFramebuffer(framebuffer);
      gl.deleteFramebuffer(resolved);
      free();
    },
  };
}

/** The storage of a WebGL 1 context: a color texture, without antialiasing because WebGL 1 has no multisampling. */
export function createWebGl1Storage(gl: WebGLRenderingContext, { depth, stencil, alpha }: LayerTargetOptions): LayerStorage {
  const framebuffer = gl.createFramebuffer();
  const color = gl.createTexture();
  const depthBuffer = depth || stencil ? gl.createRenderbuffer() : null;
  const [attachment, depthFormat] = depthFormatOf(gl, depth, stencil);
  return {
    framebuffer,
    allocate: (widthPx, heightPx) => {
      const format = alpha ? gl.RGBA : gl.RGB;
      gl.bindTexture(gl.TEXTURE_2D, color);
      gl.texImage2D(gl.TEXTURE_2D, 0, format, widthPx, heightPx, 0, format, gl.UNSIGNED_BYTE, null);
      // Textures whose size is not a power of two need these filters and wrap modes to be complete.
      for (const name of [gl.TEXTURE_MIN_FILTER, gl.TEXTURE_MAG_FILTER]) gl.texParameteri(gl.TEXTURE_2D, name, gl.NEAREST);
      for (const name of [gl.TEXTURE_WRAP_S, gl.TEXTURE_WRAP_T]) gl.texParameteri(gl.TEXTURE_2D, name, gl.CLAMP_TO_EDGE);
      gl.bindFramebuffer(gl.FRAMEBUFFER, framebuffer);
      gl.framebufferTexture2D(gl.FRAMEBUFFER, gl.COLOR_ATTACHMENT0, gl.TEXTURE_2D, color, 0);
      if (!depthBuffer) return;
      gl.bindRenderbuffer(gl.RENDERBUFFER, depthBuffer);
      gl.renderbufferStorage(gl.RENDERBUFFER, depthFormat, widthPx, heightPx);
      gl.framebufferRenderbuffer(gl.FRAMEBUFFER, attachment, gl.RENDERBUFFER, depthBuffer);
    },
    bindForReading: () => gl.bindFramebuffer(gl.FRAMEBUFFER, framebuffer),
    dispose: () => {
      gl.deleteFramebuffer(framebuffer);
      gl.deleteTexture(color);
      gl.deleteRenderbuffer(depthBuffer);
    },
  };
}

function depthFormatOf(gl: WebGLRenderingContext, depth: boolean, stencil: boolean): readonly [attachment: GLenum, format: GLenum] {
  if (depth && stencil) return [gl.DEPTH_STENCIL_ATTACHMENT, gl.DEPTH_STENCIL];
  return stencil ? [gl.STENCIL_ATTACHMENT, gl.STENCIL_INDEX8] : [gl.DEPTH_ATTACHMENT, gl.DEPTH_COMPONENT16];
}
