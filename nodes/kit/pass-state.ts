/**
 * Sets all GL state that a full-screen triangle depends on, mostly to the defaults of GL. It makes no assumption about the current
 * state: three.js, the XR code of the browser and nodes use the same context.
 *
 * @param framebuffer The target; null is the canvas.
 * @param vertexArray The vertex array of the triangle; null if the vertex shader computes its positions.
 * @param x Left edge of the viewport, pixels; `y` is its bottom edge.
 *
 * @example
 * setPassState(ctx.gl, target, null, 0, 0, widthPx, heightPx);
 * ctx.gl.drawArrays(ctx.gl.TRIANGLES, 0, 3);
 */
export function setPassState(
  gl: WebGL2RenderingContext,
  framebuffer: WebGLFramebuffer | null,
  vertexArray: WebGLVertexArrayObject | null,
  x: number,
  y: number,
  widthPx: number,
  heightPx: number,
): void {
  gl.bindFramebuffer(gl.FRAMEBUFFER, framebuffer);
  gl.viewport(x, y, widthPx, heightPx);
  gl.disable(gl.SCISSOR_TEST);
  gl.disable(gl.DEPTH_TEST);
  gl.disable(gl.STENCIL_TEST);
  gl.disable(gl.CULL_FACE);
  gl.disable(gl.BLEND);
  gl.disable(gl.RASTERIZER_DISCARD);
  gl.disable(gl.SAMPLE_ALPHA_TO_COVERAGE);
  gl.disable(gl.SAMPLE_COVERAGE);
  gl.colorMask(true, true, true, true);
  gl.bindVertexArray(vertexArray);
}

/**
 * Configures a sampler that clamps to the edge. Samplers are used instead of texture parameters because textures also come from
 * browsers and nodes, and may be read-only or have mipmaps.
 *
 * @param filter `gl.NEAREST` or `gl.LINEAR`, for minification and magnification.
 *
 * @example
 * setSampler(ctx.gl, sampler, ctx.gl.LINEAR);
 */
export function setSampler(gl: WebGL2RenderingContext, sampler: WebGLSampler, filter: GLenum): void {
  gl.samplerParameteri(sampler, gl.TEXTURE_MIN_FILTER, filter);
  gl.samplerParameteri(sampler, gl.TEXTURE_MAG_FILTER, filter);
  gl.samplerParameteri(sampler, gl.TEXTURE_WRAP_S, gl.CLAMP_TO_EDGE);
  gl.samplerParameteri(sampler, gl.TEXTURE_WRAP_T, gl.CLAMP_TO_EDGE);
}
