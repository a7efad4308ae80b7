/** The compressed forms of a model; null if a form saves nothing. */
export interface CompressedModel {
  /** Packed geometry and animation with the original images. */
  readonly meshopt: Uint8Array<ArrayBuffer> | null;
  /** The same with images as KTX2. */
  readonly ktx2: Uint8Array<ArrayBuffer> | null;
}

/** Answer of the worker: the model, or why it could not be compressed. */
export type WorkerAnswer = { readonly ok: true; readonly model: CompressedModel } | { readonly ok: false; readonly reason: string };
