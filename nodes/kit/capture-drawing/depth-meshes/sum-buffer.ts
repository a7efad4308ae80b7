/** A sum of colors with weights, and the depth of the nearest surface. */
export interface SumBuffer {
  readonly framebuffer: WebGLFramebuffer;
  /** Sum of color times weight; the weight is in alpha. RGBA16F. */
  readonly sum: WebGLTexture;
  readonly depth: WebGLTexture;
  /** Makes the buffer at least as large. It does not become smaller, because two views may take turns. */
  grow(widthPx: number, heightPx: number): void;
  dispose(): void;
}

/**
 * Creates a buffer without size. It takes 12 bytes per pixel.
 *
 * @example
 * const buffer = createSumBuffer(gl);
 * buffer.grow(1280, 720);
 */
export function createSumBuffer(gl: WebGL2RenderingContext): SumBuffer {
  // Either extension allows 16-bit floats as targets; blending needs no more.
  gl.getExtension('EXT_color_buffer_float') ?? gl.getExtension('EXT_color_buffer_half_float');
  const framebuffer = gl.createFramebuffer();
  const sum = gl.createTexture();
  const depth = gl.createTexture();
  let width = 0;
  let height = 0;
  const allocate = (texture: WebGLTexture, attachment: GLenum, internal: GLenum, format: GLenum, type: GLenum): void => {
    gl.bindTexture(gl.TEXTURE_2D, texture);
    gl.texImage2D(gl.TEXTURE_2D, 0, internal, width, height, 0, format, type, null);
    for (const name of [gl.TEXTURE_MIN_FILTER, gl.TEXTURE_MAG_FILTER]) gl.texParameteri(gl.TEXTURE_2D, name, gl.NEAREST);
    gl.framebufferTexture2D(gl.FRAMEBUFFER, attachment, gl.TEXTURE_2D, texture, 0);
  };
  return {
    framebuffer,
    sum,
    depth,
    grow: (widthPx, heightPx) => {
      if (widthPx <= width && heightPx <= height) return;
      width = Math.max(width, widthPx);
      height = Math.max(height, heightPx);
      gl.activeTexture(gl.TEXTURE0);
      gl.bindFramebuffer(gl.FRAMEBUFFER, framebuffer);
      gl.bindBuffer(gl.PIXEL_UNPACK_BUFFER, null);
      allocate(sum, gl.COLOR_ATTACHMENT0, gl.RGBA16F, gl.RGBA, gl.HALF_FLOAT);
      allocate(depth, gl.DEPTH_ATTACHMENT, gl.DEPTH_COMPONENT24, gl.DEPTH_COMPONENT, gl.UNSIGNED_INT);
      gl.bindTexture(gl.TEXTURE_2D, null);
    },
    dispose: () => {
      gl.deleteFramebuffer(framebuffer);
      gl.deleteTexture(sum);
      gl.deleteTexture(depth);
    },
  };
}
