/** The pixels of an image file as RGBA, 8 bits, bottom row first, without color conversion. */
export async function photoPixels(bytes: ArrayBuffer, widthPx: number, heightPx: number): Promise<Uint8ClampedArray> {
  const bitmap = await createImageBitmap(new Blob([bytes]), { imageOrientation: 'flipY', colorSpaceConversion: 'none' });
  const context = new OffscreenCanvas(widthPx, heightPx).getContext('2d');
  context?.drawImage(bitmap, 0, 0);
  bitmap.close();
  return context?.getImageData(0, 0, widthPx, heightPx).data ?? new Uint8ClampedArray();
}

/** A PNG of RGBA pixels, bottom row first, as a data URL. */
export function pictureUrl(pixels: Uint8Array | Uint8ClampedArray, widthPx: number, heightPx: number): string {
  const canvas = document.createElement('canvas');
  Object.assign(canvas, { width: widthPx, height: heightPx });
  const image = new ImageData(widthPx, heightPx);
  const stride = 4 * widthPx;
  for (let row = 0; row < heightPx; row++) {
    image.data.set(pixels.subarray((heightPx - 1 - row) * stride, (heightPx - row) * stride), row * stride);
  }
  canvas.getContext('2d')?.putImageData(image, 0, 0);
  return canvas.toDataURL('image/png');
}
