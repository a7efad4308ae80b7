const TRANSPARENT = new Float32Array(4);
const FARTHEST = new Float32Array([1]);

/** Clears a whole framebuffer to transparent, and its depth to the maximum. */
export function clearAll(gl: WebGL2RenderingContext, framebuffer: WebGLFramebuffer, withDepth: boolean): void {
  prepareClear(gl, framebuffer);
  gl.disable(gl.SCISSOR_TEST);
  gl.clearBufferfv(gl.COLOR, 0, TRANSPARENT);
  if (withDepth) gl.clearBufferfv(gl.DEPTH, 0, FARTHEST);
}

/** Clears the depth of a rectangle, and its color if one is given (premultiplied). */
export function clearRectangle(
  gl: WebGL2RenderingContext,
  framebuffer: WebGLFramebuffer | null,
  x: number,
  y: number,
  widthPx: number,
  heightPx: number,
  color: Float32Array | null,
): void {
  prepareClear(gl, framebuffer);
  gl.enable(gl.SCISSOR_TEST);
  gl.scissor(x, y, widthPx, heightPx);
  gl.clearBufferfv(gl.DEPTH, 0, FARTHEST);
  if (color) gl.clearBufferfv(gl.COLOR, 0, color);
  gl.disable(gl.SCISSOR_TEST);
}

/** Resets masks and RASTERIZER_DISCARD, which affect clears. */
function prepareClear(gl: WebGL2RenderingContext, framebuffer: WebGLFramebuffer | null): void {
  gl.bindFramebuffer(gl.FRAMEBUFFER, framebuffer);
  gl.disable(gl.RASTERIZER_DISCARD);
  gl.colorMask(true, true, true, true);
  gl.depthMask(true);
}
