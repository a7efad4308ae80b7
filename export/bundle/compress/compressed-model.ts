/**
 * Bytes of graphics memory that are worth one byte to download. At 4 Mbit/s a megabyte takes two seconds; a page on a phone can use some
 * hundred megabytes of textures. PNG textures always gain by KTX2, because they shrink too. A JPEG of 1,024 × 1,024 would grow from 150 kB
 * to 1.1 MB and save 4 MB of memory, so it stays.
 */
export const GPU_BYTES_PER_FILE_BYTE = 8;

/**
 * Bytes that decoders add to a page, as hosts send them (gzip -9, three r187). meshopt is part of the script; KTX2 has a loader, a
 * transcoder and its script.
 */
export const DECODER_BYTES = { meshopt: 7_300, ktx2: 287_000 } as const;

/** The compressed forms of a model; null if a form saves nothing. */
export interface CompressedModel {
  /** Packed geometry and animation with the original images. */
  readonly meshopt: Uint8Array<ArrayBuffer> | null;
  /** Packed geometry and animation with the images as KTX2. */
  readonly ktx2: Uint8Array<ArrayBuffer> | null;
}

/** Answer of the worker: the model, or why it could not be compressed. */
export type WorkerAnswer = { readonly ok: true; readonly model: CompressedModel } | { readonly ok: false; readonly reason: string };
