import type { ModelDecoder } from './decoder.ts';

/**
 * Opens the decoder of `EXT_meshopt_compression` and `KHR_meshopt_compression`: a small and fast decoder that needs no files or workers.
 */
export async function openMeshopt(): Promise<ModelDecoder> {
  const { MeshoptDecoder } = await import('three/addons/libs/meshopt_decoder.module.js');
  return {
    attach: (loader) => loader.setMeshoptDecoder(MeshoptDecoder),
    dispose: () => {},
  };
}
