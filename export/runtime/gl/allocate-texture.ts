/** Allocates storage for a new texture: one level, clamped to the edge, all zero. Leaves it bound to unit 0. */
export function allocateTexture(
  gl: WebGL2RenderingContext,
  texture: WebGLTexture,
  format: GLenum,
  filter: GLenum,
  widthPx: number,
  heightPx: number,
): WebGLTexture {
  gl.activeTexture(gl.TEXTURE0);
  gl.bindTexture(gl.TEXTURE_2D, texture);
  gl.texStorage2D(gl.TEXTURE_2D, 1, format, widthPx, heightPx);
  gl.texParameteri(gl.TEXTURE_2D, gl.TEXTURE_MIN_FILTER, filter);
  gl.texParameteri(gl.TEXTURE_2D, gl.TEXTURE_MAG_FILTER, filter);
  gl.texParameteri(gl.TEXTURE_2D, gl.TEXTURE_WRAP_S, gl.CLAMP_TO_EDGE);
  gl.texParameteri(gl.TEXTURE_2D, gl.TEXTURE_WRAP_T, gl.CLAMP_TO_EDGE);
  return texture;
}
