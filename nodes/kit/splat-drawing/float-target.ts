import { setPassState } from '../pass-state.ts';

/** An image of floating-point numbers, in which splats are blended. */
export interface FloatTarget {
  readonly texture: WebGLTexture;
  /** Makes the image at least as large; two views of different size may take turns. Returns whether it can be drawn to. */
  grow(widthPx: number, heightPx: number): boolean;
  /** Binds the image to draw to its lower left part, and clears it. */
  begin(widthPx: number, heightPx: number): void;
  dispose(): void;
}

const CLEAR = Float32Array.of(0, 0, 0, 0);

/**
 * Creates an image without size.
 *
 * @param channels Number of channels: 2 or 4.
 * @param type `gl.FLOAT` or `gl.HALF_FLOAT`.
 *
 * @example
 * const target = createFloatTarget(gl, 4, gl.HALF_FLOAT);
 * if (target.grow(640, 480)) target.begin(640, 480);
 */
export function createFloatTarget(gl: WebGL2RenderingContext, channels: 2 | 4, type: GLenum): FloatTarget {
  const isFloat = type === gl.FLOAT;
  const [internal, format] = channels === 2 ? [isFloat ? gl.RG32F : gl.RG16F, gl.RG] : [isFloat ? gl.RGBA32F : gl.RGBA16F, gl.RGBA];
  const texture = gl.createTexture();
  const framebuffer = gl.createFramebuffer();
  let width = 0;
  let height = 0;
  let isComplete = false;
  return {
    texture,
    grow: (widthPx, heightPx) => {
      if (widthPx <= width && heightPx <= height) return isComplete;
      width = Math.max(width, widthPx);
      height = Math.max(height, heightPx);
      gl.activeTexture(gl.TEXTURE0);
      gl.bindTexture(gl.TEXTURE_2D, texture);
      gl.bindBuffer(gl.PIXEL_UNPACK_BUFFER, null);
      gl.texImage2D(gl.TEXTURE_2D, 0, internal, width, height, 0, format, type, null);
      gl.bindFramebuffer(gl.FRAMEBUFFER, framebuffer);
      gl.framebufferTexture2D(gl.FRAMEBUFFER, gl.COLOR_ATTACHMENT0, gl.TEXTURE_2D, texture, 0);
      isComplete = gl.checkFramebufferStatus(gl.FRAMEBUFFER) === gl.FRAMEBUFFER_COMPLETE;
      return isComplete;
    },
    begin: (widthPx, heightPx) => {
      setPassState(gl, framebuffer, null, 0, 0, widthPx, heightPx);
      gl.clearBufferfv(gl.COLOR, 0, CLEAR);
    },
    dispose: () => {
      gl.deleteTexture(texture);
      gl.deleteFramebuffer(framebuffer);
    },
  };
}
