import { layoutOf, wrongShape } from '../../../nodes/kit/panorama/layouts.ts';
import { toEquirectangular } from '../../../nodes/kit/panorama/to-equirectangular.ts';
import type { StoredPanorama } from './panorama-storage.ts';

/** Maximum width and height of an image that is converted. Larger ones are reduced, because the conversion blocks the page. */
const MOST_PX = 4096;

/**
 * Reads a panorama from an image file of the visitor: equirectangular, a mirror ball, or the faces of a cube.
 *
 * @param widthPx Width to which an equirectangular image is scaled.
 * @throws Error whose message is text for the visitor.
 */
export async function readPicture(document: Document, file: Blob, widthPx: number): Promise<StoredPanorama> {
  const bitmap = await createImageBitmap(file).catch(() => {
    throw new Error('The file is no picture that this browser can read. Choose a JPEG, PNG, WebP or AVIF picture.');
  });
  try {
    const layout = layoutOf(bitmap.width, bitmap.height);
    if (layout === null) throw new Error(`This is no panorama. ${wrongShape(bitmap.width, bitmap.height)}`);
    if (layout === 'equirectangular') return draw(document, bitmap, widthPx, widthPx / 2);
    const scale = Math.min(1, MOST_PX / Math.max(bitmap.width, bitmap.height));
    const picture = draw(document, bitmap, Math.max(1, Math.round(bitmap.width * scale)), Math.max(1, Math.round(bitmap.height * scale)));
    const { data, widthPx: width, heightPx } = toEquirectangular({ ...picture, channels: 4 }, layout);
    return { widthPx: width, heightPx, data: data as Uint8ClampedArray<ArrayBuffer> };
  } finally {
    bitmap.close();
  }
}

function draw(document: Document, bitmap: ImageBitmap, widthPx: number, heightPx: number): StoredPanorama {
  const canvas = document.createElement('canvas');
  canvas.width = widthPx;
  canvas.height = heightPx;
  const context = canvas.getContext('2d');
  if (!context) throw new Error('The browser has no memory for the picture. Close other tabs, then try again.');
  context.imageSmoothingQuality = 'high';
  context.drawImage(bitmap, 0, 0, widthPx, heightPx);
  return { widthPx, heightPx, data: context.getImageData(0, 0, widthPx, heightPx).data as Uint8ClampedArray<ArrayBuffer> };
}

/** Encodes a panorama as a PNG file. Filled holes become opaque. */
export function pictureOf(document: Document, { widthPx, heightPx, data }: StoredPanorama): Promise<Blob | null> {
  const canvas = document.createElement('canvas');
  canvas.width = widthPx;
  canvas.height = heightPx;
  const opaque = data.slice();
  for (let i = 3; i < opaque.length; i += 4) opaque[i] = 255;
  canvas.getContext('2d')?.putImageData(new ImageData(opaque, widthPx, heightPx), 0, 0);
  return new Promise((resolve) => canvas.toBlob(resolve, 'image/png'));
}
