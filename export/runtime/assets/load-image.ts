import type { ImageAsset } from '../../../nodes/kit/runtime.ts';
import type { GlObjects } from '../gl/gl-objects.ts';
import { prepareUpload } from '../gl/upload.ts';

export interface LoadedImage extends ImageAsset {
  dispose(): void;
}

/**
 * Decodes a picture as layers want it: premultiplied, its numbers as they are in the file whatever profile it has, first row at
 * the bottom. A picture larger than the GPU takes is made smaller. Rejects where the browser cannot decode it.
 */
export async function loadImage(objects: GlObjects, bytes: ArrayBuffer): Promise<LoadedImage> {
  const options: ImageBitmapOptions = { premultiplyAlpha: 'premultiply', colorSpaceConversion: 'none', imageOrientation: 'flipY' };
  const full = await createImageBitmap(new Blob([bytes]), options);
  const bitmap = await fitInto(full, objects.limits.maxTextureSizePx);
  const { gl } = objects;
  const { width, height } = bitmap;
  const texture = objects.createTexture();
  prepareUpload(gl, 4);
  gl.activeTexture(gl.TEXTURE0);
  gl.bindTexture(gl.TEXTURE_2D, texture);
  gl.texStorage2D(gl.TEXTURE_2D, 1, gl.RGBA8, width, height);
  gl.texSubImage2D(gl.TEXTURE_2D, 0, 0, 0, gl.RGBA, gl.UNSIGNED_BYTE, bitmap);
  gl.texParameteri(gl.TEXTURE_2D, gl.TEXTURE_MIN_FILTER, gl.LINEAR);
  gl.texParameteri(gl.TEXTURE_2D, gl.TEXTURE_WRAP_S, gl.CLAMP_TO_EDGE);
  gl.texParameteri(gl.TEXTURE_2D, gl.TEXTURE_WRAP_T, gl.CLAMP_TO_EDGE);
  bitmap.close();
  return { texture, widthPx: width, heightPx: height, dispose: () => objects.deleteTexture(texture) };
}

async function fitInto(bitmap: ImageBitmap, maxPx: number): Promise<ImageBitmap> {
  const scale = maxPx / Math.max(bitmap.width, bitmap.height);
  if (scale >= 1) return bitmap;
  const smaller = await createImageBitmap(bitmap, {
    premultiplyAlpha: 'premultiply',
    resizeWidth: Math.max(1, Math.floor(bitmap.width * scale)),
    resizeHeight: Math.max(1, Math.floor(bitmap.height * scale)),
    resizeQuality: 'high',
  });
  bitmap.close();
  return smaller;
}
