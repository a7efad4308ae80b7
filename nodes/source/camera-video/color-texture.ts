/** A texture of one pixel that shows a color. */
export interface ColorTexture {
  /** The number of colors so far. */
  readonly version: number;
  /**
   * Sets the color and returns the texture.
   *
   * @param color Display-referred sRGB with straight alpha; stored premultiplied, as in all layers.
   */
  paint(color: Readonly<Float64Array>): WebGLTexture;
  dispose(): void;
}

export function createColorTexture(gl: WebGL2RenderingContext): ColorTexture {
  const texture = gl.createTexture();
  const painted = new Uint8Array(4);
  let empty = true;
  let version = 0;
  return {
    get version() {
      return version;
    },
    paint: (color) => {
      const alpha = color[3] ?? 1;
      let changed = empty;
      for (let i = 0; i < 4; i++) {
        const byte = Math.round(Math.min(Math.max((color[i] ?? 0) * (i < 3 ? alpha : 1), 0), 1) * 255);
        changed ||= painted[i] !== byte;
        painted[i] = byte;
      }
      if (!changed) return texture;
      empty = false;
      version++;
      gl.bindTexture(gl.TEXTURE_2D, texture);
      gl.bindBuffer(gl.PIXEL_UNPACK_BUFFER, null);
      gl.pixelStorei(gl.UNPACK_PREMULTIPLY_ALPHA_WEBGL, false);
      gl.pixelStorei(gl.UNPACK_SKIP_PIXELS, 0);
      gl.pixelStorei(gl.UNPACK_SKIP_ROWS, 0);
      gl.texImage2D(gl.TEXTURE_2D, 0, gl.RGBA8, 1, 1, 0, gl.RGBA, gl.UNSIGNED_BYTE, painted);
      return texture;
    },
    dispose: () => gl.deleteTexture(texture),
  };
}
