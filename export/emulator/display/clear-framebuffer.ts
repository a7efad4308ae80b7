import type { Gl } from './app-gl.ts';

/** Clears the bound framebuffer to transparent black, far depth and stencil 0 regardless of the page's masks and clear values, which it restores. */
export function clearFramebuffer(gl: Gl): void {
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
