import basisScript from 'three/examples/jsm/libs/basis/basis_transcoder.js?url';
import basisWasm from 'three/examples/jsm/libs/basis/basis_transcoder.wasm?url';
import dracoWasm from 'three/examples/jsm/libs/draco/gltf/draco_decoder.wasm?url';
import dracoScript from 'three/examples/jsm/libs/draco/gltf/draco_wasm_wrapper.js?url';
import type { DecoderFile } from '../../export/gltf/decoders.ts';
import { pageFetch } from './network.ts';

const URLS: Readonly<Record<DecoderFile, string>> = {
  'draco/gltf/draco_wasm_wrapper.js': dracoScript,
  'draco/gltf/draco_decoder.wasm': dracoWasm,
  'basis/basis_transcoder.js': basisScript,
  'basis/basis_transcoder.wasm': basisWasm,
};

/** Loads a decoder for compressed models, which lies beside the preview’s script. */
export async function previewDecoderFile(file: DecoderFile): Promise<ArrayBuffer> {
  const response = await pageFetch(new URL(URLS[file], document.baseURI).href);
  if (!response.ok) throw new Error(`the preview responded with status ${response.status}`);
  return response.arrayBuffer();
}
