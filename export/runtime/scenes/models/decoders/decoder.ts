import type { Texture, WebGLRenderer } from 'three';
import type { GLTFLoader } from 'three/addons/loaders/GLTFLoader.js';
import type { DecoderFile, DecoderName } from '../../../../gltf/decoders.ts';

/** Bytes of a decoder's file, from wherever the page keeps it. Rejects with an `Error` that says why there are none. */
export type DecoderFiles = (file: DecoderFile) => Promise<ArrayBuffer>;

/** An open decoder: it may hold workers and some megabytes of memory until it is disposed of. */
export interface ModelDecoder {
  attach(loader: GLTFLoader): void;
  /** Decoders of pictures only; takes the buffer over. */
  readonly decodePicture?: (bytes: ArrayBuffer) => Promise<Texture>;
  dispose(): void;
}

export type OpenDecoder = (files: DecoderFiles, renderer: WebGLRenderer) => Promise<ModelDecoder>;

/** Those that a page has: its script holds no code of others. */
export type ModelDecoders = Readonly<Partial<Record<DecoderName, OpenDecoder>>>;
