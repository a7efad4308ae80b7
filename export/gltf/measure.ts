import { elementBytes, type Gltf, type GltfDocument } from './document.ts';
import { imageSize } from './image-size.ts';

/** Size of a model, estimated from its document without decoding. */
export interface ModelMeasure {
  readonly triangles: number;
  /** Pixels of the largest image. */
  readonly largestImagePx: number;
  /** Bytes of vertices, indices and morph targets on the GPU. */
  readonly geometryBytes: number;
  /** Bytes of images on the GPU, including mipmaps. */
  readonly textureBytes: number;
}

/** Factor of a full mip chain: 1 + 1/4 + 1/16 + … */
const MIPS = 4 / 3;
const RGBA8_BYTES = 4;
/**
 * Bytes per pixel of the formats that KTX2 is transcoded to on most GPUs: ASTC 4×4, BC7 and ETC2 with alpha have 16 bytes per 4×4 pixels.
 */
const BLOCK_BYTES = 1;
/** three.js stores morph targets as 32-bit RGBA texels, one per attribute, vertex and target (`WebGLMorphtargets`). */
const MORPH_TEXEL_BYTES = 16;

export function measureModel({ document, binary }: Gltf): ModelMeasure {
  let textureBytes = 0;
  let largestImagePx = 0;
  for (const { bufferView } of document.images ?? []) {
    const view = bufferView === undefined ? undefined : document.bufferViews?.[bufferView];
    const start = view?.byteOffset ?? 0;
    const size = view && binary ? imageSize(binary.subarray(start, start + view.byteLength)) : null;
    if (!size) continue;
    const pixels = size.widthPx * size.heightPx;
    largestImagePx = Math.max(largestImagePx, pixels);
    // A KTX2 file with one level is drawn without mipmaps.
    textureBytes += pixels * (size.ktx2 ? BLOCK_BYTES * (size.ktx2.levels === 1 ? 1 : MIPS) : RGBA8_BYTES * MIPS);
  }
  return { ...measureGeometry(document), largestImagePx, textureBytes: Math.round(textureBytes) };
}

function measureGeometry({ meshes = [], accessors = [] }: GltfDocument): Pick<ModelMeasure, 'triangles' | 'geometryBytes'> {
  const lists = new Set<number>();
  let triangles = 0;
  let morphBytes = 0;
  for (const { attributes, indices, mode = 4, targets = [] } of meshes.flatMap((mesh) => mesh.primitives)) {
    const vertices = accessors[attributes.POSITION ?? -1]?.count ?? 0;
    const corners = indices === undefined ? vertices : (accessors[indices]?.count ?? 0);
    if (mode === 4) triangles += Math.floor(corners / 3);
    else if (mode > 4) triangles += Math.max(0, corners - 2);
    for (const index of Object.values(attributes)) lists.add(index);
    if (indices !== undefined) lists.add(indices);
    morphBytes += targets.length * vertices * Object.keys(targets[0] ?? {}).length * MORPH_TEXEL_BYTES;
  }
  let geometryBytes = morphBytes;
  for (const index of lists) {
    const accessor = accessors[index];
    // Padded to 4 bytes, the alignment of vertices in WebGL.
    if (accessor) geometryBytes += accessor.count * paddedBytes(elementBytes(accessor) ?? 0, accessor.type === 'SCALAR');
  }
  return { triangles, geometryBytes };
}

function paddedBytes(bytes: number, isScalar: boolean): number {
  return isScalar ? bytes : (bytes + 3) & ~3;
}
