import type { Texture, WebGLRenderer } from 'three';
import type { GLTFLoader } from 'three/addons/loaders/GLTFLoader.js';
import type { DecoderFile, DecoderName } from '../../../../gltf/decoders.ts';

/** Reads a decoder's file. Rejects with an `Error` whose message is text for the user. */
export type DecoderFiles = (file: DecoderFile) => Promise<ArrayBuffer>;

/** An open decoder, which may own workers and a few megabytes of memory until it is disposed. */
export interface ModelDecoder {
  attach(loader: GLTFLoader): void;
  /** Decodes an image; absent in decoders of meshes. It takes ownership of the buffer. */
  readonly decodeImage?: (bytes: ArrayBuffer) => Promise<Texture>;
  dispose(): void;
}

export type OpenDecoder = (files: DecoderFiles, renderer: WebGLRenderer) => Promise<ModelDecoder>;

/** The decoders of a page; others are not bundled. */
export type ModelDecoders = Readonly<Partial<Record<DecoderName, OpenDecoder>>>;
