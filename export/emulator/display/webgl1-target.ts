import { borrowGl, type Gl } from './app-gl.ts';
import type { LayerTarget, LayerTargetOptions } from './layer-target.ts';

/** The device's framebuffer in a WebGL 1 context, without antialiasing because WebGL 1 has no multisampling. */
export function createWebGl1Target(
  gl: WebGLRenderingContext,
  startWidthPx: number,
  startHeightPx: number,
  { depth, stencil, alpha }: LayerTargetOptions,
): LayerTarget {
  let widthPx = startWidthPx;
  let heightPx = startHeightPx;
  const framebuffer = gl.createFramebuffer();
  const color = gl.createTexture();
  const depthBuffer = depth || stencil ? gl.createRenderbuffer() : null;
  const [attachment, depthFormat] = depthFormatOf(gl, depth, stencil);
  const allocate = (): void => {
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
  };
  borrowGl(gl, allocate);
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
      borrowGl(gl, allocate);
    },
    clear: () => {
      if (isGone()) return;
      borrowGl(gl, () => {
        gl.bindFramebuffer(gl.FRAMEBUFFER, framebuffer);
        clearAll(gl);
      });
    },
    read: (out) => {
      if (isGone()) {
        out.fill(0);
        return;
      }
      borrowGl(gl, () => {
        gl.bindFramebuffer(gl.FRAMEBUFFER, framebuffer);
        gl.readPixels(0, 0, widthPx, heightPx, gl.RGBA, gl.UNSIGNED_BYTE, out);
      });
    },
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

/** Clears to transparent black, far depth and stencil 0 regardless of the page's masks and clear values, which it restores. */
export function clearAll(gl: Gl): void {
  const colorMask = gl.getParameter(gl.COLOR_WRITEMASK) as boolean[];
  const depthMask = gl.getParameter(gl.DEPTH_WRITEMASK) as boolean;
  const stencilMask = gl.getParameter(gl.STENCIL_WRITEMASK) as number;
  const stencilBackMask = gl.getParameter(gl.STENCIL_BACK_WRITEMASK) as number;
  const [r = 0, g = 0, b = 0, a = 0] = gl.getParameter(gl.COLOR_CLEAR_VALUE) as Float32Array;
  const depthValue = gl.getParameter(gl.DEPTH_CLEAR_VALUE) as number;
  const stencilValue = gl.getParameter(gl.STENCIL_CLEAR_VALUE) as number;
  gl.colorMask(true, true, true, true);
  gl.depthMask(true);
  gl.stencilMask(0xff);
  gl.clearColor(0, 0, 0, 0);
  gl.clearDepth(1);
  gl.clearStencil(0);
  gl.clear(gl.COLOR_BUFFER_BIT | gl.DEPTH_BUFFER_BIT | gl.STENCIL_BUFFER_BIT);
  gl.colorMask(colorMask[0] ?? true, colorMask[1] ?? true, colorMask[2] ?? true, colorMask[3] ?? true);
  gl.depthMask(depthMask);
  gl.stencilMaskSeparate(gl.FRONT, stencilMask);
  gl.stencilMaskSeparate(gl.BACK, stencilBackMask);
  gl.clearColor(r, g, b, a);
  gl.clearDepth(depthValue);
  gl.clearStencil(stencilValue);
}
