import { type Document, NodeIO, type Texture } from '@gltf-transform/core';
import { ALL_EXTENSIONS, EXTMeshoptCompression, KHRTextureBasisu } from '@gltf-transform/extensions';
import { dedup, getTextureColorSpace, listTextureSlots, prune, quantize, reorder, weld } from '@gltf-transform/functions';
import { MeshoptEncoder } from 'meshoptimizer/encoder';
import { neededDecoders } from '../../gltf/decoders.ts';
import { imageSize } from '../../gltf/image-size.ts';
import { readGltf } from '../../gltf/read-gltf.ts';
import type { CompressedModel } from './compressed-model.ts';
import { GPU_BYTES_PER_FILE_BYTE } from './compressed-model.ts';
import { encodeKtx2 } from './encode-ktx2.ts';

/**
 * Bits of quantization. Positions have 1/16,384 of the size of a mesh, a tenth of a millimeter for furniture; texture coordinates a quarter
 * of a texel of a 4,096 texture; normals 0.1°.
 */
const PRECISION = { quantizePosition: 14, quantizeTexcoord: 14, quantizeNormal: 10, quantizeColor: 8, quantizeWeight: 8 } as const;

/**
 * Compresses a model (one GLB without external files) without visible loss: removes duplicates and unused data, merges equal vertices and
 * packs the rest. Keyframes are not resampled, because that moved the head of RobotExpressive by pixels. Nodes, clips, skins and morph
 * targets keep their names. The same input gives the same bytes. Rejects if glTF-Transform cannot read the model.
 */
export async function compressModel(bytes: Uint8Array): Promise<CompressedModel> {
  const { document } = readGltf(bytes);
  // The model is compressed already; repacking would lose precision again.
  if (neededDecoders(document).length > 0) return { meshopt: null, ktx2: null };
  if (document.extensionsUsed?.some((name) => !KNOWN.has(name))) return { meshopt: null, ktx2: null };
  await MeshoptEncoder.ready;
  const io = new NodeIO().registerExtensions(ALL_EXTENSIONS).registerDependencies({ 'meshopt.encoder': MeshoptEncoder });
  const doc = await io.readBinary(bytes);
  await doc.transform(
    dedup({ keepUniqueNames: true }),
    prune({ keepLeaves: true, keepAttributes: true, keepSolidTextures: true, keepExtras: true }),
    weld(),
    reorder({ encoder: MeshoptEncoder, target: 'size' }),
    // The cleanup of `quantize` would remove nodes without a mesh, which clips and constraints may refer to.
    quantize({ ...PRECISION, cleanup: false }),
  );
  const method = EXTMeshoptCompression.EncoderMethod.QUANTIZE;
  doc.createExtension(EXTMeshoptCompression).setRequired(true).setEncoderOptions({ method });
  const packed = await io.writeBinary(doc);
  const encoded = await encodeTextures(doc);
  return { meshopt: owned(packed), ktx2: encoded ? owned(await io.writeBinary(doc)) : null };
}

/** The extensions that glTF-Transform supports; it would drop others. */
const KNOWN = new Set(ALL_EXTENSIONS.map(({ EXTENSION_NAME }) => EXTENSION_NAME));

/** Encodes the textures that become smaller. Returns false if there are none. */
async function encodeTextures(doc: Document): Promise<boolean> {
  let encoded = false;
  for (const texture of doc.getRoot().listTextures()) {
    const image = texture.getImage();
    const mimeType = texture.getMimeType();
    if (!image || (mimeType !== 'image/png' && mimeType !== 'image/jpeg') || !isEncodable(image)) continue;
    const slots = listTextureSlots(texture);
    const ktx2 = await encodeKtx2(image, {
      mimeType,
      srgb: getTextureColorSpace(texture) === 'srgb',
      normals: slots.length > 0 && slots.every((slot) => /normalTexture$/i.test(slot)),
    });
    if (ktx2 && isWorthIt(texture, image, ktx2)) encoded = true;
  }
  if (encoded) doc.createExtension(KHRTextureBasisu).setRequired(true);
  return encoded;
}

/** Maximum number of pixels of the encoder. */
const MAX_PIXELS = 12 * 2 ** 20;

/** `KHR_texture_basisu` requires sides that are multiples of the block size. */
function isEncodable(image: Uint8Array): boolean {
  const size = imageSize(image);
  return size !== null && size.widthPx % 4 === 0 && size.heightPx % 4 === 0 && size.widthPx * size.heightPx <= MAX_PIXELS;
}

function isWorthIt(texture: Texture, image: Uint8Array, ktx2: Uint8Array): boolean {
  const { widthPx, heightPx } = imageSize(image) ?? { widthPx: 0, heightPx: 0 };
  // 4 bytes per pixel become 1, including mipmaps.
  const savedBytes = widthPx * heightPx * 3 * (4 / 3);
  if ((ktx2.length - image.length) * GPU_BYTES_PER_FILE_BYTE >= savedBytes) return false;
  texture.setImage(ktx2).setMimeType('image/ktx2');
  if (texture.getURI() !== '') texture.setURI(texture.getURI().replace(/(\.\w+)?$/, '.ktx2'));
  return true;
}

/** Copies bytes to their own buffer, so that they can be transferred between threads. */
function owned(bytes: Uint8Array): Uint8Array<ArrayBuffer> {
  return Uint8Array.from(bytes);
}
