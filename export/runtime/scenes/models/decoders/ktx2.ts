import type { Texture, WebGLRenderer } from 'three';
import type { DecoderFiles, ModelDecoder } from './decoder.ts';
import { preloaded } from './preloaded.ts';
import { withoutEval } from './without-eval.ts';

/** Opens the decoder of `KHR_texture_basisu`: Basis Universal's WebAssembly transcoder, in workers. Textures stay compressed on the GPU. */
export async function openKtx2(files: DecoderFiles, renderer: WebGLRenderer): Promise<ModelDecoder> {
  const { KTX2Loader } = await import('three/addons/loaders/KTX2Loader.js');
  const ktx2 = new KTX2Loader().detectSupport(renderer);
  const folder = 'basis/';
  ktx2.setTranscoderPath(folder);
  const contents = await Promise.all([files('basis/basis_transcoder.js'), files('basis/basis_transcoder.wasm')]);
  const named = {
    [`${folder}basis_transcoder.js`]: withoutEval(new TextDecoder().decode(contents[0])),
    [`${folder}basis_transcoder.wasm`]: contents[1],
  };
  preloaded(named, () => ktx2.init());
  return {
    attach: (loader) => loader.setKTX2Loader(ktx2),
    decodeImage: (bytes) => new Promise<Texture>((resolve, reject) => ktx2.parse(bytes, resolve, reject)),
    dispose: () => ktx2.dispose(),
  };
}
