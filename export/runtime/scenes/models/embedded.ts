import { Texture } from 'three';
import type { GLTFLoaderPlugin, GLTFParser } from 'three/addons/loaders/GLTFLoader.js';
import { type GltfDocument, ModelError } from '../../../gltf/document.ts';
import type { ModelDecoder } from './decoders/decoder.ts';

/** The cache of three.js' parser, which it reads before it loads an image; not in its published types. */
interface ParserCache {
  readonly sourceCache: Record<number, Promise<Texture>>;
}

export interface EmbeddedImages {
  readonly document: GltfDocument;
  /** Receives every decoded image, so that the owner of the model can close it. */
  readonly bitmaps: ImageBitmap[];
  readonly decodeKtx2: ModelDecoder['decodeImage'];
}

/**
 * Decodes the images of a GLB file without fetching.
 *
 * three.js converts them to `blob:` URLs and fetches these, which a strict content security policy blocks. This decodes their bytes and
 * passes them to the parser through its cache. `tests/slow/scenes-models.test.ts` loads a model under `default-src 'none'` and fails if
 * an upgrade of three.js does not read the cache.
 */
export function embeddedImages({ document, bitmaps, decodeKtx2 }: EmbeddedImages, parser: GLTFParser): GLTFLoaderPlugin {
  const { sourceCache } = parser as unknown as ParserCache;

  async function decodeImageAt(index: number): Promise<Texture | null> {
    const image = document.images?.[index];
    const bytes: ArrayBuffer = await parser.getDependency('bufferView', image?.bufferView ?? -1);
    if (image?.mimeType !== 'image/ktx2') return decodeBitmap(index, new Blob([bytes], { type: image?.mimeType ?? '' }));
    // The file has a fallback image, or it would have been rejected.
    if (!decodeKtx2) return null;
    return decodeKtx2(bytes).catch(() => {
      throw new ModelError(`image ${index + 1} in it is a broken KTX2 texture. Export it again.`);
    });
  }

  async function decodeBitmap(index: number, blob: Blob): Promise<Texture> {
    const bitmap = await createImageBitmap(blob, {
      // As three.js decodes them: values of the file without color conversion.
      colorSpaceConversion: 'none',
      premultiplyAlpha: 'none',
    }).catch(() => {
      throw new ModelError(`image ${index + 1} in it is damaged or has an unsupported format. Use PNG, JPEG or WebP.`);
    });
    bitmaps.push(bitmap);
    const texture = new Texture(bitmap);
    texture.needsUpdate = true;
    return texture;
  }

  return {
    name: 'SCRIM_embedded_pictures',
    beforeRoot: async () => {
      const images = await Promise.allSettled((document.images ?? []).map((_, i) => decodeImageAt(i)));
      images.forEach((image, i) => {
        if (image.status === 'rejected') throw image.reason;
        if (image.value) sourceCache[i] = Promise.resolve(image.value);
      });
    },
  };
}
