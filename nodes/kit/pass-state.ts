/**
 * Sets all GL state that a full-screen triangle depends on, mostly to GL's own defaults, and assumes nothing about what others
 * left: three.js, the browser's XR code and nodes use the same context.
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

/** Samplers rather than texture parameters: textures come from browsers and nodes too, and may be read-only or have mips. */
export function setSampler(gl: WebGL2RenderingContext, sampler: WebGLSampler, filter: GLenum): void {
  gl.samplerParameteri(sampler, gl.TEXTURE_MIN_FILTER, filter);
  gl.samplerParameteri(sampler, gl.TEXTURE_MAG_FILTER, filter);
  gl.samplerParameteri(sampler, gl.TEXTURE_WRAP_S, gl.CLAMP_TO_EDGE);
  gl.samplerParameteri(sampler, gl.TEXTURE_WRAP_T, gl.CLAMP_TO_EDGE);
}
