import { allocateTexture } from '../../../export/runtime/gl/allocate-texture.ts';
import type { GlObjects } from '../../../export/runtime/gl/gl-objects.ts';

const SIDE_PX = 64;

/** Test textures for layers and depth: all colors, some transparency, 0.5 to 4.5 m. */
export function createTestImage(objects: GlObjects): { readonly color: WebGLTexture; readonly depth: WebGLTexture } {
  const { gl } = objects;
  const colors = new Uint8Array(SIDE_PX ** 2 * 4);
  const meters = new Float32Array(SIDE_PX ** 2);
  for (let i = 0; i < meters.length; i++) {
    const x = i % SIDE_PX;
    const y = Math.floor(i / SIDE_PX);
    const alpha = y < SIDE_PX / 8 ? y * 32 : 255;
    colors.set([(x * 4 * alpha) / 255, (y * 4 * alpha) / 255, ((x ^ y) * 4 * alpha) / 255, alpha], i * 4);
    meters[i] = 0.5 + (x + y) / 32;
  }
  const color = allocateTexture(gl, objects.createTexture(), gl.RGBA8, gl.LINEAR, SIDE_PX, SIDE_PX);
  gl.texSubImage2D(gl.TEXTURE_2D, 0, 0, 0, SIDE_PX, SIDE_PX, gl.RGBA, gl.UNSIGNED_BYTE, colors);
  const depth = allocateTexture(gl, objects.createTexture(), gl.R32F, gl.NEAREST, SIDE_PX, SIDE_PX);
  gl.texSubImage2D(gl.TEXTURE_2D, 0, 0, 0, SIDE_PX, SIDE_PX, gl.RED, gl.FLOAT, meters);
  return { color, depth };
}
