import { getBounds, NodeIO } from '@gltf-transform/core';
import { ALL_EXTENSIONS } from '@gltf-transform/extensions';
import { MeshoptDecoder } from 'meshoptimizer';
import type { SheetModel } from './sheet-project.ts';

/**
 * Measures the bounding box of a glTF file, without skinning.
 *
 * @throws If the file cannot be read or has no scene.
 */
export async function measureModel(file: string): Promise<SheetModel> {
  await MeshoptDecoder.ready;
  const io = new NodeIO().registerExtensions(ALL_EXTENSIONS).registerDependencies({ 'meshopt.decoder': MeshoptDecoder });
  const doc = await io.read(file);
  const scene = doc.getRoot().getDefaultScene() ?? doc.getRoot().listScenes()[0];
  if (!scene) throw new Error(`${file} has no scene.`);
  const { min, max } = getBounds(scene);
  const center = min.map((low, axis) => (low + (max[axis] ?? 0)) / 2) as unknown as SheetModel['center'];
  return { file, center, sideM: Math.max(...min.map((low, axis) => (max[axis] ?? 0) - low)) };
}
