import { readSog, type SogImage } from '../../../../nodes/kit/splats/sog.ts';
import { openSog } from '../../../../nodes/kit/splats/sog-archive.ts';
import { readSplatFile, SPLAT_FILE_ENDING } from '../../../../nodes/kit/splats/splat-file.ts';
import { readSplatPly } from '../../../../nodes/kit/splats/splat-ply.ts';
import { SplatError, type Splats } from '../../../../nodes/kit/splats/splats.ts';
import type { GlObjects } from '../../gl/gl-objects.ts';
import { prepareReadback, prepareUpload } from '../../gl/upload.ts';

/**
 * Reads a file of splats by its ending: `.ply`, `.sog`, or the form of pages.
 *
 * @throws SplatError
 */
export function readSplatBytes(objects: GlObjects, path: string, bytes: Uint8Array<ArrayBuffer>): Promise<Splats> {
  const name = path.toLowerCase();
  if (name.endsWith(SPLAT_FILE_ENDING)) return readSplatFile(bytes);
  return name.endsWith('.sog') ? readSogFile(objects, bytes) : Promise.resolve(readSplatPly(bytes));
}

async function readSogFile(objects: GlObjects, bytes: Uint8Array<ArrayBuffer>): Promise<Splats> {
  const { meta, open } = await openSog(bytes);
  const images: SogImage[] = [];
  for (const name of meta.files) images.push(await readImage(objects, name, await open(name)));
  return readSog(meta, images);
}

/** Decodes an image exactly: a 2D canvas would multiply by alpha. */
async function readImage(objects: GlObjects, name: string, bytes: Uint8Array<ArrayBuffer>): Promise<SogImage> {
  const bitmap = await createImageBitmap(new Blob([bytes]), { premultiplyAlpha: 'none', colorSpaceConversion: 'none' }).catch(() => null);
  if (bitmap === null) throw new SplatError(`its ${name} is no image that the browser can decode`);
  const { width: widthPx, height: heightPx } = bitmap;
  const { gl, limits } = objects;
  if (Math.max(widthPx, heightPx) > limits.maxTextureSizePx)
    throw new SplatError(`its ${name} is larger than the graphics of this device can read`);
  const texture = objects.createTexture();
  const framebuffer = objects.createFramebuffer();
  const data = new Uint8Array(4 * widthPx * heightPx);
  gl.activeTexture(gl.TEXTURE0);
  gl.bindTexture(gl.TEXTURE_2D, texture);
  prepareUpload(gl, 4);
  gl.texImage2D(gl.TEXTURE_2D, 0, gl.RGBA8, gl.RGBA, gl.UNSIGNED_BYTE, bitmap);
  bitmap.close();
  gl.bindFramebuffer(gl.FRAMEBUFFER, framebuffer);
  gl.framebufferTexture2D(gl.FRAMEBUFFER, gl.COLOR_ATTACHMENT0, gl.TEXTURE_2D, texture, 0);
  prepareReadback(gl);
  gl.readPixels(0, 0, widthPx, heightPx, gl.RGBA, gl.UNSIGNED_BYTE, data);
  gl.bindFramebuffer(gl.FRAMEBUFFER, null);
  objects.deleteFramebuffer(framebuffer);
  objects.deleteTexture(texture);
  return { data, widthPx, heightPx };
}
