import type { DecoderFiles, ModelDecoder } from './decoder.ts';
import { preloaded } from './preloaded.ts';

/** Opens the decoder of `KHR_draco_mesh_compression`: Google's WebAssembly, in workers. */
export async function openDraco(files: DecoderFiles): Promise<ModelDecoder> {
  const { DRACOLoader } = await import('three/addons/loaders/DRACOLoader.js');
  const draco = new DRACOLoader();
  const js = 'draco_wasm_wrapper.js';
  const wasm = 'draco_decoder.wasm';
  draco.setDecoderPath({ js, wasm } as unknown as string);
  const contents = await Promise.all([files('draco/gltf/draco_wasm_wrapper.js'), files('draco/gltf/draco_decoder.wasm')]);
  preloaded({ [js]: new TextDecoder().decode(contents[0]), [wasm]: contents[1] }, () => draco.preload());
  return {
    attach: (loader) => loader.setDRACOLoader(draco),
    dispose: () => draco.dispose(),
  };
}
