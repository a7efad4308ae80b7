import { imageSize } from '../../../export/gltf/image-size.ts';
import { readCapture } from '../../../nodes/kit/capture.ts';
import { captureSize, PHONE_TEXTURE_PX, phoneCaptureSize } from '../../../nodes/kit/capture-size.ts';
import type { AssetKind } from '../../../nodes/kit/definition.ts';
import type { Editor } from '../editor/editor.ts';
import { bytesOf } from './base64.ts';

/** What a look into an asset tells. Null: not known, or not of that kind. */
export interface AssetFacts {
  /** A small picture as a data URL. */
  readonly picture: string | null;
  /** Textures with their mipmaps, and geometry. */
  readonly gpuBytes: number | null;
  /** What a capture takes on phones and headsets, where pages limit it. */
  readonly phoneGpuBytes: number | null;
}

export interface AssetPlace {
  readonly handle: string;
  /** Address of the project's files, for the preview. */
  readonly assetBaseUrl: string;
  readonly path: string;
  readonly kind: AssetKind;
  /** Size on disk. */
  readonly bytes: number;
  /** Whether a node draws the depth meshes of a capture. */
  readonly depthMeshes: boolean;
}

/** Size of pictures in pixels, twice that on screen. */
export const PICTURE_PX = { widthPx: 96, heightPx: 72 };

/** Images and models above this size are not read, because the whole file is read for the picture. */
const MAX_BYTES = 32 * 2 ** 20;

const RGBA8_BYTES = 4;

export const NO_FACTS: AssetFacts = { picture: null, gpuBytes: null, phoneGpuBytes: null };

/** Draws a small picture of an image, a model or a capture, and computes what the asset takes on the GPU. Never rejects. */
export async function readAssetFacts(editor: Editor, place: AssetPlace): Promise<AssetFacts> {
  try {
    switch (place.kind) {
      case 'image':
        return place.bytes <= MAX_BYTES ? await imageFacts(await readFile(editor, place, place.path)) : NO_FACTS;
      case 'model':
        return place.bytes <= MAX_BYTES ? await modelFacts(editor, place) : NO_FACTS;
      case 'capture':
        return await captureFacts(editor, place);
      case 'video':
      case 'audio':
      case 'environment':
      case 'splats':
        return NO_FACTS;
    }
  } catch {
    // The check of the project says what is wrong with the file.
    return NO_FACTS;
  }
}

async function readFile({ host }: Editor, { handle }: AssetPlace, path: string): Promise<Uint8Array<ArrayBuffer>> {
  const { base64 } = await host.call('asset.read', { handle, path });
  return bytesOf(base64);
}

/** An image is an RGBA8 texture without mipmaps (`load-image.ts`). */
async function imageFacts(file: Uint8Array<ArrayBuffer>): Promise<AssetFacts> {
  const size = imageSize(file);
  return { ...NO_FACTS, picture: await drawImage(file), gpuBytes: size && size.widthPx * size.heightPx * RGBA8_BYTES };
}

async function modelFacts({ models }: Editor, { assetBaseUrl, path }: AssetPlace): Promise<AssetFacts> {
  const drawn = await models.draw?.({ assetBaseUrl, path }, PICTURE_PX);
  if (!drawn) return NO_FACTS;
  const { image, gpuBytes } = drawn;
  const picture = image && toUrl(image);
  return { ...NO_FACTS, picture, gpuBytes };
}

/** The picture of a capture is the photograph in the middle of its list. */
async function captureFacts(editor: Editor, place: AssetPlace): Promise<AssetFacts> {
  const text = new TextDecoder().decode(await readFile(editor, place, place.path));
  const capture = readCapture(text);
  const { depthMeshes } = place;
  const { gpuBytes } = captureSize(capture, { maxSidePx: PHONE_TEXTURE_PX, depthMeshes });
  const view = capture.views[Math.floor(capture.views.length / 2)];
  const folder = place.path.slice(0, place.path.lastIndexOf('/') + 1);
  return {
    picture: view ? await drawImage(await readFile(editor, place, folder + view.file)) : null,
    gpuBytes,
    phoneGpuBytes: phoneCaptureSize(capture, depthMeshes).gpuBytes,
  };
}

/** Draws a small copy, so that large images do not stay in memory. Null if the browser cannot read the image. */
async function drawImage(file: Uint8Array<ArrayBuffer>): Promise<string | null> {
  try {
    return toUrl(await createImageBitmap(new Blob([file]), { resizeWidth: PICTURE_PX.widthPx, resizeQuality: 'medium' }));
  } catch {
    return null;
  }
}

/** Closes the image. */
function toUrl(image: ImageBitmap): string {
  const canvas = document.createElement('canvas');
  canvas.width = image.width;
  canvas.height = image.height;
  canvas.getContext('2d')?.drawImage(image, 0, 0);
  image.close();
  return canvas.toDataURL();
}
