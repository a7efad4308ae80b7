import { Texture } from 'three';
import type { GLTFLoaderPlugin, GLTFParser } from 'three/addons/loaders/GLTFLoader.js';
import { type GltfDocument, ModelError } from './check-gltf.ts';

/** Two caches of three's parser, which it asks before it loads anything; not in its published types. */
interface ParserCaches {
  readonly cache: { add(key: string, value: Promise<unknown>): void };
  readonly sourceCache: Record<number, Promise<Texture>>;
}

/**
 * Decodes what is embedded in a model without fetching anything.
 *
 * three turns embedded images into `blob:` URLs and fetches them, and fetches `data:` URLs, which a page with a strict content
 * security policy refuses. Here images are decoded from their bytes, and handed to the parser through its own caches.
 * `tests/browser/scenes-models.test.ts` loads a model under `default-src 'none'`, so that an upgrade that no longer asks them fails.
 *
 * @param bitmaps takes every image decoded, for whoever frees the model
 */
export function embeddedContent(document: GltfDocument, parser: GLTFParser, bitmaps: ImageBitmap[]): GLTFLoaderPlugin {
  const caches = parser as unknown as ParserCaches;

  async function decodeImage(index: number): Promise<Texture> {
    const bitmap = await createImageBitmap(await imageBlob(document, parser, index), {
      // As three decodes them: values stay those of the file, whatever the screen.
      colorSpaceConversion: 'none',
      premultiplyAlpha: 'none',
    }).catch(() => {
      throw new ModelError(`image ${index + 1} in it is broken or of an unknown kind. Use PNG, JPEG or WebP images.`);
    });
    bitmaps.push(bitmap);
    const texture = new Texture(bitmap);
    texture.needsUpdate = true;
    return texture;
  }

  return {
    name: 'SCRIM_embedded_content',
    beforeRoot: async () => {
      document.buffers?.forEach(({ uri }, i) => {
        if (uri !== undefined) caches.cache.add(`buffer:${i}`, Promise.resolve(decodeDataUrl(uri).bytes));
      });
      const images = await Promise.allSettled((document.images ?? []).map((image, i) => (isOptional(image) ? null : decodeImage(i))));
      images.forEach((image, i) => {
        if (image.status === 'rejected') throw image.reason;
        if (image.value) caches.sourceCache[i] = Promise.resolve(image.value);
      });
    },
  };
}

/** KTX2 pictures come with a plain one for those who cannot decode them, unless the file requires their extension. */
function isOptional({ mimeType }: { readonly mimeType?: string }): boolean {
  return mimeType === 'image/ktx2';
}

async function imageBlob(document: GltfDocument, parser: GLTFParser, index: number): Promise<Blob> {
  const image = document.images?.[index];
  if (image?.uri !== undefined) {
    const { bytes, type } = decodeDataUrl(image.uri);
    return new Blob([bytes], { type });
  }
  const bytes: ArrayBuffer = await parser.getDependency('bufferView', image?.bufferView ?? -1);
  return new Blob([bytes], { type: image?.mimeType ?? '' });
}

/** `data:TYPE;base64,…` or percent-encoded text (RFC 2397). */
export function decodeDataUrl(url: string): { bytes: ArrayBuffer; type: string } {
  const comma = url.indexOf(',');
  const [type = '', ...options] = url.slice('data:'.length, comma).split(';');
  const content = url.slice(comma + 1);
  const binary = options.includes('base64') ? atob(content) : decodeURIComponent(content);
  const bytes = new Uint8Array(binary.length);
  for (let i = 0; i < binary.length; i++) bytes[i] = binary.charCodeAt(i);
  return { bytes: bytes.buffer, type };
}
