import { readFile } from 'node:fs/promises';
import { join } from 'node:path';
import createDecoder from '@jsquash/avif/codec/dec/avif_dec.js';
import createEncoder from '@jsquash/avif/codec/enc/avif_enc.js';
import { defaultOptions } from '@jsquash/avif/meta.js';
import type { Photo } from '../../captures/undistort.ts';

const CODEC = 'node_modules/@jsquash/avif/codec';
const BITS = 8;
/** Color in the resolution of the photograph, as in its JPEG form. */
const FULL_COLOR = 3;

/** libavif as WebAssembly. Its memory grows to that of the largest photograph, and stays. */
export interface AvifCodec {
  /**
   * The same photograph gives the same bytes on every machine.
   *
   * @param quality 0 to 100.
   * @param speed 0 to 10.
   */
  encode(photo: Photo, form: { readonly quality: number; readonly speed: number }): Promise<Uint8Array>;
  /** @throws Error if the file is damaged. */
  decode(file: Uint8Array): Promise<Photo>;
}

/** @param root Absolute path of the folder with Scrim's sources and `node_modules`. */
export function createAvifCodec(root: string): AvifCodec {
  const load = async (path: string) => ({ noInitialRun: true, wasmBinary: await readFile(join(root, CODEC, path)) });
  let encoder: ReturnType<typeof createEncoder> | null = null;
  let decoder: ReturnType<typeof createDecoder> | null = null;
  return {
    encode: async ({ widthPx, heightPx, data }, form) => {
      encoder ??= load('enc/avif_enc.wasm').then(createEncoder);
      const bytes = (await encoder).encode(data, widthPx, heightPx, { ...defaultOptions, ...form, subsample: FULL_COLOR });
      if (bytes === null) throw new Error('The photograph cannot be encoded.');
      return bytes;
    },
    decode: async (file) => {
      decoder ??= load('dec/avif_dec.wasm').then(createDecoder);
      const image = (await decoder).decode(file, BITS);
      if (image === null) throw new Error('it is not a whole AVIF file');
      return { widthPx: image.width, heightPx: image.height, data: new Uint8Array(image.data.buffer) };
    },
  };
}
