/**
 * A photograph of a capture for `createImageBitmap` or an image element. No standard tells browsers to recognize AVIF by its bytes, so it has
 * its type; they recognize the other formats.
 *
 * @param file Its name or path.
 *
 * @example
 * const bitmap = await createImageBitmap(photoBlob(view.file, bytes));
 */
export function photoBlob(file: string, bytes: BlobPart): Blob {
  return new Blob([bytes], file.endsWith('.avif') ? { type: 'image/avif' } : {});
}
