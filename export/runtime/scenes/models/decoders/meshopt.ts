import type { ModelDecoder } from './decoder.ts';

/** `EXT_meshopt_compression` and `KHR_meshopt_compression`: a decoder so small and fast that it needs neither files nor workers. */
export async function openMeshopt(): Promise<ModelDecoder> {
  const { MeshoptDecoder } = await import('three/addons/libs/meshopt_decoder.module.js');
  return {
    attach: (loader) => loader.setMeshoptDecoder(MeshoptDecoder),
    dispose: () => {},
  };
}
