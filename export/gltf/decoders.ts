import type { GltfDocument } from './document.ts';

/** Decoders of compressed models, which three.js loads separately. */
export const DECODERS = ['draco', 'meshopt', 'ktx2'] as const;
export type DecoderName = (typeof DECODERS)[number];

const DECODER_OF: Readonly<Record<string, DecoderName>> = {
  KHR_draco_mesh_compression: 'draco',
  EXT_meshopt_compression: 'meshopt',
  KHR_meshopt_compression: 'meshopt',
  KHR_texture_basisu: 'ktx2',
};

/** The decoders that a model needs, in the order of `DECODERS`. */
export function neededDecoders({ extensionsUsed = [] }: GltfDocument): DecoderName[] {
  const needed = new Set(extensionsUsed.map((name) => DECODER_OF[name]));
  return DECODERS.filter((name) => needed.has(name));
}

export function isDecoded(extension: string): boolean {
  return Object.hasOwn(DECODER_OF, extension);
}

/**
 * Files that a decoder loads at run time, in `node_modules/three/examples/jsm/libs`. meshopt is part of the script. File names are unique,
 * so that all can be served from one folder.
 */
export const DECODER_FILES = {
  draco: ['draco/gltf/draco_wasm_wrapper.js', 'draco/gltf/draco_decoder.wasm'],
  meshopt: [],
  ktx2: ['basis/basis_transcoder.js', 'basis/basis_transcoder.wasm'],
} as const satisfies Readonly<Record<DecoderName, readonly string[]>>;

export type DecoderFile = (typeof DECODER_FILES)[DecoderName][number];

export const DECODER_FILES_FOLDER = 'node_modules/three/examples/jsm/libs';
