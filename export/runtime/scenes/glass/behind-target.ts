import { ExternalTexture } from 'three';
import type { LayerEncoding } from '../../../../nodes/kit/definition.ts';
import { clearAll } from '../../gl/clear.ts';

/** An image of what is behind glass, with mip levels, in linear premultiplied light. */
export interface BehindTarget {
  /** The framebuffer to draw to; valid after `begin`. */
  readonly framebuffer: WebGLFramebuffer | null;
  /** The image that was last published. It may be read while more is drawn, because the framebuffer is a separate buffer. */
  readonly texture: ExternalTexture;
  /** Allocates the size and clears the framebuffer to transparent black. Binds framebuffers. */
  begin(widthPx: number, heightPx: number): void;
  /** Copies what is drawn so far to `texture` and computes its mip levels. Binds framebuffers and a texture. */
  publish(): void;
  dispose(): void;
}

/** Samples per pixel, as in three.js' own transmission buffer. */
const SAMPLES = 4;

/**
 * Creates the target; it allocates memory at the first `begin`. For display layers it has 8 bits per channel in sRGB, which the GPU converts,
 * so that a clear pane changes no pixel; for scene layers 16-bit floats.
 */
export function createBehindTarget(gl: WebGL2RenderingContext, encoding: LayerEncoding): BehindTarget {
  const canFloat = encoding === 'scene' && gl.getExtension('EXT_color_buffer_float') !== null;
  const format = canFloat ? gl.RGBA16F : gl.SRGB8_ALPHA8;
  const image = new ExternalTexture();
  let parts: Parts | null = null;

  function free(): void {
    if (!parts) return;
    for (const framebuffer of [parts.drawn, parts.resolved]) gl.deleteFramebuffer(framebuffer);
    for (const buffer of parts.buffers) gl.deleteRenderbuffer(buffer);
    gl.deleteTexture(parts.texture);
    image.sourceTexture = null;
    parts = null;
  }

  return {
    get framebuffer() {
      return parts?.drawn ?? null;
    },
    texture: image,
    begin: (widthPx, heightPx) => {
      if (parts?.widthPx !== widthPx || parts.heightPx !== heightPx) {
        free();
        parts = createParts(gl, format, widthPx, heightPx);
        image.sourceTexture = parts.texture;
      }
      clearAll(gl, parts.drawn, true);
    },
    publish: () => {
      if (!parts) return;
      const { drawn, resolved, texture, widthPx, heightPx } = parts;
      // The scissor test also limits a blit.
      gl.disable(gl.SCISSOR_TEST);
      gl.bindFramebuffer(gl.READ_FRAMEBUFFER, drawn);
      gl.bindFramebuffer(gl.DRAW_FRAMEBUFFER, resolved);
      gl.blitFramebuffer(0, 0, widthPx, heightPx, 0, 0, widthPx, heightPx, gl.COLOR_BUFFER_BIT, gl.NEAREST);
      gl.activeTexture(gl.TEXTURE0);
      gl.bindTexture(gl.TEXTURE_2D, texture);
      gl.generateMipmap(gl.TEXTURE_2D);
    },
    dispose: free,
  };
}

interface Parts {
  readonly widthPx: number;
  readonly heightPx: number;
  readonly texture: WebGLTexture;
  readonly drawn: WebGLFramebuffer;
  readonly resolved: WebGLFramebuffer;
  readonly buffers: readonly WebGLRenderbuffer[];
}

function createParts(gl: WebGL2RenderingContext, format: GLenum, widthPx: number, heightPx: number): Parts {
  const texture = gl.createTexture();
  gl.activeTexture(gl.TEXTURE0);
  gl.bindTexture(gl.TEXTURE_2D, texture);
  gl.texStorage2D(gl.TEXTURE_2D, Math.floor(Math.log2(Math.max(widthPx, heightPx))) + 1, format, widthPx, heightPx);
  gl.texParameteri(gl.TEXTURE_2D, gl.TEXTURE_MIN_FILTER, gl.LINEAR_MIPMAP_LINEAR);
  gl.texParameteri(gl.TEXTURE_2D, gl.TEXTURE_MAG_FILTER, gl.LINEAR);
  gl.texParameteri(gl.TEXTURE_2D, gl.TEXTURE_WRAP_S, gl.CLAMP_TO_EDGE);
  gl.texParameteri(gl.TEXTURE_2D, gl.TEXTURE_WRAP_T, gl.CLAMP_TO_EDGE);
  const resolved = gl.createFramebuffer();
  gl.bindFramebuffer(gl.FRAMEBUFFER, resolved);
  gl.framebufferTexture2D(gl.FRAMEBUFFER, gl.COLOR_ATTACHMENT0, gl.TEXTURE_2D, texture, 0);
  const drawn = gl.createFramebuffer();
  gl.bindFramebuffer(gl.FRAMEBUFFER, drawn);
  // Devices need not multisample 16-bit floats.
  const counts = gl.getInternalformatParameter(gl.RENDERBUFFER, format, gl.SAMPLES) as Int32Array | null;
  const samples = Math.min(SAMPLES, counts?.[0] ?? 0);
  const attach = (attachment: GLenum, storage: GLenum): WebGLRenderbuffer => {
    const buffer = gl.createRenderbuffer();
    gl.bindRenderbuffer(gl.RENDERBUFFER, buffer);
    gl.renderbufferStorageMultisample(gl.RENDERBUFFER, samples, storage, widthPx, heightPx);
    gl.framebufferRenderbuffer(gl.FRAMEBUFFER, attachment, gl.RENDERBUFFER, buffer);
    return buffer;
  };
  const buffers = [attach(gl.COLOR_ATTACHMENT0, format), attach(gl.DEPTH_ATTACHMENT, gl.DEPTH_COMPONENT24)];
  return { widthPx, heightPx, texture, drawn, resolved, buffers };
}
