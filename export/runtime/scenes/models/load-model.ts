import type { BufferGeometry, Material, Object3D, Texture, WebGLRenderer } from 'three';
import { type GLTF, GLTFLoader } from 'three/addons/loaders/GLTFLoader.js';
import { clone } from 'three/addons/utils/SkeletonUtils.js';
import { neededDecoders } from '../../../gltf/decoders.ts';
import { damaged, type Gltf, ModelError } from '../../../gltf/document.ts';
import { readWholeModel } from '../../../gltf/whole-model.ts';
import type { LoadedModel, ModelFinding, SceneBackend } from '../../scene-backend.ts';
import { isDrawable, materialsOf } from '../proxies/drawable.ts';
import type { DecoderFiles, ModelDecoder, ModelDecoders } from './decoders/decoder.ts';
import { createDecoderPool } from './decoders/decoder-pool.ts';
import { embeddedImages } from './embedded.ts';
import { addMissingNormals } from './missing-normals.ts';

export interface ModelTools {
  readonly decoders: ModelDecoders;
  readonly files: DecoderFiles;
  /** Returns warnings about a valid model for designers; absent in exported pages. */
  readonly inspect?: (gltf: Gltf, path: string, fileBytes: number) => readonly ModelFinding[];
}

export const NO_TOOLS: ModelTools = { decoders: {}, files: () => Promise.reject(new Error('this page has none')) };

/**
 * Creates `loadModel` of the backend, which reads glTF 2.0 models, `.glb` or `.gltf`. It loads the file's default scene,
 * or the first one if none is named; cameras and lights of the file are never drawn. Rejects with `ModelError`.
 */
export function createModelLoader({ decoders, files, inspect }: ModelTools, renderer: WebGLRenderer): SceneBackend['loadModel'] {
  const pool = createDecoderPool(decoders, files, renderer);
  return async (file, path, readFile) => {
    const { bytes, gltf } = await readWholeModel(new Uint8Array(file), path, async (beside) => new Uint8Array(await readFile(beside)));
    const findings = inspect?.(gltf, path, bytes.length) ?? [];
    const model = await pool.use(neededDecoders(gltf.document), (ready) => decode(bytes.buffer, gltf, ready));
    return { ...model, findings };
  };
}

async function decode(bytes: ArrayBuffer, { document }: Gltf, decoders: readonly ModelDecoder[]): Promise<Omit<LoadedModel, 'findings'>> {
  const bitmaps: ImageBitmap[] = [];
  const closeBitmaps = (): void => {
    for (const bitmap of bitmaps) bitmap.close();
  };
  const decodeKtx2 = decoders.find(({ decodeImage }) => decodeImage)?.decodeImage;
  const loader = new GLTFLoader();
  for (const decoder of decoders) decoder.attach(loader);
  loader.register((parser) => embeddedImages({ document, bitmaps, decodeKtx2 }, parser));
  try {
    const { scene, animations } = await parse(loader, bytes);
    const missing = addMissingNormals(scene);
    const freeable = collectFreeable(scene);
    return {
      clips: animations,
      instantiate: (normals = 'flat') => {
        const instance = clone(scene);
        if (normals === 'smooth') missing.smooth(instance);
        return instance;
      },
      dispose: () => {
        missing.dispose();
        for (const part of freeable) part.dispose();
        closeBitmaps();
      },
    };
  } catch (error) {
    closeBitmaps();
    throw error;
  }
}

async function parse(loader: GLTFLoader, bytes: ArrayBuffer): Promise<GLTF> {
  try {
    return await loader.parseAsync(bytes, '');
  } catch (error) {
    throw error instanceof ModelError ? error : damaged(reasonOf(error));
  }
}

/** The reason why a model did not load, as text. Decoders reject with messages of their workers, which are not `Error` objects. */
function reasonOf(error: unknown): string {
  if (error instanceof Error) return error.message;
  if (typeof error === 'object' && error !== null && 'error' in error) return String(error.error);
  return String(error);
}

/** Returns the geometries, materials and textures of a model, which are disposed with it. Instances of the model share them. */
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
