import type { ImageAsset } from '../../../nodes/kit/assets.ts';
import { allocateTexture } from '../gl/allocate-texture.ts';
import type { GlObjects } from '../gl/gl-objects.ts';
import { prepareUpload } from '../gl/upload.ts';

export interface LoadedImage extends ImageAsset {
  dispose(): void;
}

/**
 * Decodes an image to premultiplied RGBA with the first row at the bottom, without color conversion. An image above the GPU's size limit is
 * reduced. Rejects if the browser cannot decode it.
 */
export async function loadImage(objects: GlObjects, bytes: ArrayBuffer): Promise<LoadedImage> {
  const options: ImageBitmapOptions = { premultiplyAlpha: 'premultiply', colorSpaceConversion: 'none', imageOrientation: 'flipY' };
  const full = await createImageBitmap(new Blob([bytes]), options);
  const bitmap = await fitInto(full, objects.limits.maxTextureSizePx);
  const { gl } = objects;
  const { width, height } = bitmap;
  const texture = allocateTexture(gl, objects.createTexture(), gl.RGBA8, gl.LINEAR, width, height);
  prepareUpload(gl, 4);
  gl.texSubImage2D(gl.TEXTURE_2D, 0, 0, 0, gl.RGBA, gl.UNSIGNED_BYTE, bitmap);
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
