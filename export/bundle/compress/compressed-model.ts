/** A model made smaller, once for each way; null where a way does nothing for it. */
export interface CompressedModel {
  /** Packed geometry and animation; its pictures as they were. */
  readonly meshopt: Uint8Array<ArrayBuffer> | null;
  /** The same with pictures packed for the GPU. */
  readonly ktx2: Uint8Array<ArrayBuffer> | null;
}

/** What a worker answers: the model, or why there is none. */
export type WorkerAnswer = { readonly ok: true; readonly model: CompressedModel } | { readonly ok: false; readonly reason: string };
