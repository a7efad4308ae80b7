import { readFile } from 'node:fs/promises';
import { join } from 'node:path';
import createDecoder from '@jsquash/jpeg/codec/dec/mozjpeg_dec.js';
import { decode } from 'jpeg-js';
import type { Photo } from '../../captures/undistort.ts';

const DECODER = 'node_modules/@jsquash/jpeg/codec/dec/mozjpeg_dec.wasm';

/**
 * Decodes JPEG files by MozJPEG as WebAssembly, which takes a quarter of the time of jpeg-js. What it complains about is decoded by jpeg-js,
 * which reads colors of ink, and says what is damaged.
 *
 * @param root Absolute path of the folder with Scrim's sources and `node_modules`.
 * @returns A function that throws an Error if the file is damaged.
 */
export function createJpegDecoder(root: string): (file: Uint8Array) => Promise<Photo> {
  let complaints = 0;
  const start = async () =>
    createDecoder({ noInitialRun: true, wasmBinary: await readFile(join(root, DECODER)), printErr: () => complaints++ });
  let decoder: ReturnType<typeof start> | null = null;
  return async (file) => {
    complaints = 0;
    decoder ??= start();
    try {
      const image = (await decoder).decode(file, false);
      if (image && complaints === 0) return { widthPx: image.width, heightPx: image.height, data: new Uint8Array(image.data.buffer) };
    } catch {
      // It has ended, and its memory may be damaged.
      decoder = null;
    }
    const { width, height, data } = decode(file, { useTArray: true, maxMemoryUsageInMB: 2048, maxResolutionInMP: 68 });
    return { widthPx: width, heightPx: height, data };
  };
}
