import { borrowGl, type Gl, isWebGl2 } from './app-gl.ts';
import type { LayerTarget, LayerTargetOptions } from './layer-target.ts';
import { createWebGl1Target } from './webgl1-target.ts';

const SAMPLES = 4;

/** Creates the device's framebuffer in the page's WebGL 1 or 2 context. */
export function createLayerTarget(gl: Gl, widthPx: number, heightPx: number, options: LayerTargetOptions): LayerTarget {
  return isWebGl2(gl) ? createWebGl2Target(gl, widthPx, heightPx, options) : createWebGl1Target(gl, widthPx, heightPx, options);
}

function createWebGl2Target(
  gl: WebGL2RenderingContext,
  startWidthPx: number,
  startHeightPx: number,
  { antialias, depth, stencil, alpha }: LayerTargetOptions,
): LayerTarget {
  const buffers: WebGLRenderbuffer[] = [];
  let widthPx = startWidthPx;
  let heightPx = startHeightPx;
  const colorFormat = alpha ? gl.RGBA8 : gl.RGB8;
  const attach = (attachment: GLenum, format: GLenum, samples: number): void => {
    const buffer = gl.createRenderbuffer();
    buffers.push(buffer);
    gl.bindRenderbuffer(gl.RENDERBUFFER, buffer);
    if (samples > 0) gl.renderbufferStorageMultisample(gl.RENDERBUFFER, samples, format, widthPx, heightPx);
    else gl.renderbufferStorage(gl.RENDERBUFFER, format, widthPx, heightPx);
    gl.framebufferRenderbuffer(gl.FRAMEBUFFER, attachment, gl.RENDERBUFFER, buffer);
  };
  const samples = antialias ? Math.min(SAMPLES, gl.getParameter(gl.MAX_SAMPLES) as number) : 0;
  const framebuffer = gl.createFramebuffer();
  const resolved = samples > 0 ? gl.createFramebuffer() : null;
  const allocate = (): void => {
    gl.bindFramebuffer(gl.FRAMEBUFFER, framebuffer);
    attach(gl.COLOR_ATTACHMENT0, colorFormat, samples);
    if (depth && stencil) attach(gl.DEPTH_STENCIL_ATTACHMENT, gl.DEPTH24_STENCIL8, samples);
    else if (depth) attach(gl.DEPTH_ATTACHMENT, gl.DEPTH_COMPONENT24, samples);
    else if (stencil) attach(gl.STENCIL_ATTACHMENT, gl.STENCIL_INDEX8, samples);
    if (resolved) {
      gl.bindFramebuffer(gl.FRAMEBUFFER, resolved);
      attach(gl.COLOR_ATTACHMENT0, colorFormat, 0);
    }
  };
  const free = (): void => {
    for (const buffer of buffers.splice(0)) gl.deleteRenderbuffer(buffer);
  };
  borrowGl(gl, allocate);

  /** Whether the framebuffer is lost with its context. It stays lost when the context is restored: the page creates a new layer. */
  const isGone = (): boolean => gl.isContextLost() || !gl.isFramebuffer(framebuffer);

  return {
    framebuffer,
    get widthPx() {
      return widthPx;
    },
    get heightPx() {
      return heightPx;
    },
    resize: (toWidthPx, toHeightPx) => {
      if (isGone()) return;
      widthPx = toWidthPx;
      heightPx = toHeightPx;
      free();
      borrowGl(gl, allocate);
    },
    clear: () => {
      if (isGone()) return;
      borrowGl(gl, () => {
        const colorMask = gl.getParameter(gl.COLOR_WRITEMASK) as boolean[];
        const depthMask = gl.getParameter(gl.DEPTH_WRITEMASK) as boolean;
        const stencilMask = gl.getParameter(gl.STENCIL_WRITEMASK) as number;
        gl.colorMask(true, true, true, true);
        gl.depthMask(true);
        gl.stencilMask(0xff);
        gl.bindFramebuffer(gl.DRAW_FRAMEBUFFER, framebuffer);
        gl.clearBufferfv(gl.COLOR, 0, [0, 0, 0, 0]);
        if (depth) gl.clearBufferfv(gl.DEPTH, 0, [1]);
        if (stencil) gl.clearBufferiv(gl.STENCIL, 0, [0]);
        gl.colorMask(colorMask[0] ?? true, colorMask[1] ?? true, colorMask[2] ?? true, colorMask[3] ?? true);
        gl.depthMask(depthMask);
        gl.stencilMask(stencilMask);
      });
    },
    read: (out) => {
      if (isGone()) {
        out.fill(0);
        return;
      }
      borrowGl(gl, () => {
        gl.bindFramebuffer(gl.READ_FRAMEBUFFER, framebuffer);
        if (resolved) {
          gl.bindFramebuffer(gl.DRAW_FRAMEBUFFER, resolved);
          gl.blitFramebuffer(0, 0, widthPx, heightPx, 0, 0, widthPx, heightPx, gl.COLOR_BUFFER_BIT, gl.NEAREST);
          gl.bindFramebuffer(gl.READ_FRAMEBUFFER, resolved);
        }
        gl.readPixels(0, 0, widthPx, heightPx, gl.RGBA, gl.UNSIGNED_BYTE, out);
      });
    },
    dispose: () => {
      gl.deleteFramebuffer(framebuffer);
      gl.deleteFramebuffer(resolved);
      free();
    },
  };
}
