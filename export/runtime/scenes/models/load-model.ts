import type { BufferGeometry, Material, Object3D, Texture } from 'three';
import { type GLTF, GLTFLoader } from 'three/addons/loaders/GLTFLoader.js';
import { clone } from 'three/addons/utils/SkeletonUtils.js';
import type { LoadedModel } from '../../scene-backend.ts';
import { isDrawable, materialsOf } from '../proxies/drawable.ts';
import { damaged, type GltfDocument, ModelError, readGltf } from './check-gltf.ts';
import { embeddedContent } from './embedded.ts';

/**
 * Reads a glTF 2.0 model, `.glb` or self-contained `.gltf`. Its first scene counts; its cameras and lights are not used.
 *
 * @throws ModelError, by rejection
 */
export async function loadModel(bytes: ArrayBuffer): Promise<LoadedModel> {
  const document = readGltf(bytes);
  const bitmaps: ImageBitmap[] = [];
  const closeBitmaps = (): void => {
    for (const bitmap of bitmaps) bitmap.close();
  };
  try {
    const { scene, animations } = await parse(bytes, document, bitmaps);
    const freeable = collectFreeable(scene);
    return {
      clips: animations,
      instantiate: () => clone(scene),
      dispose: () => {
        for (const part of freeable) part.dispose();
        closeBitmaps();
      },
    };
  } catch (error) {
    closeBitmaps();
    throw error;
  }
}

async function parse(bytes: ArrayBuffer, document: GltfDocument, bitmaps: ImageBitmap[]): Promise<GLTF> {
  const loader = new GLTFLoader();
  loader.register((parser) => embeddedContent(document, parser, bitmaps));
  try {
    return await loader.parseAsync(bytes, '');
  } catch (error) {
    throw error instanceof ModelError ? error : damaged(error instanceof Error ? error.message : String(error));
  }
}

/** Geometries, materials and textures: what `instantiate` shares between its subtrees. */
function collectFreeable(root: Object3D): Set<BufferGeometry | Material | Texture> {
  const found = new Set<BufferGeometry | Material | Texture>();
  root.traverse((object) => {
    if (!isDrawable(object)) return;
    found.add(object.geometry);
    for (const material of materialsOf(object)) {
      found.add(material);
      for (const value of Object.values(material)) if (isTexture(value)) found.add(value);
    }
  });
  return found;
}

function isTexture(value: unknown): value is Texture {
  return typeof value === 'object' && value !== null && 'isTexture' in value;
}
