import { loadImage } from '../../export/runtime/assets/load-image.ts';
import { createGlObjects } from '../../export/runtime/gl/gl-objects.ts';
import { createGl } from './runtime-kit.ts';

/** Loads the bytes of a file as pages do. Returns its size, and its pixels, premultiplied RGBA8 with the first row at the bottom. */
export async function load(bytes: readonly number[]) {
  const gl = createGl();
  const { texture, widthPx, heightPx } = await loadImage(createGlObjects(gl), Uint8Array.from(bytes).buffer);
  gl.bindFramebuffer(gl.FRAMEBUFFER, gl.createFramebuffer());
  gl.framebufferTexture2D(gl.FRAMEBUFFER, gl.COLOR_ATTACHMENT0, gl.TEXTURE_2D, texture, 0);
  const pixels = new Uint8Array(widthPx * heightPx * 4);
  gl.readPixels(0, 0, widthPx, heightPx, gl.RGBA, gl.UNSIGNED_BYTE, pixels);
  return { widthPx, heightPx, pixels: [...pixels] };
}
