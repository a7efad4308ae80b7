import { damaged, type Gltf, type GltfBufferView, isPacked } from './document.ts';

/** Maximum decoded size of a buffer view, in bytes. More than any device supports means a damaged count. */
export const MAX_UNPACKED_BYTES = 2 ** 29;

/** First byte of meshopt's streams (EXT_meshopt_compression, appendix A): the high four bits; the rest is the version. */
const MESHOPT_HEADS: Readonly<Record<string, number>> = { ATTRIBUTES: 0xa0, TRIANGLES: 0xe0, INDICES: 0xd0 };

/** Rejects compressed data that the decoder would fail on. The content is not decoded. */
export function checkPacked({ document, binary }: Gltf): void {
  const { bufferViews = [], buffers = [], meshes = [] } = document;
  /** The bytes of a buffer view; null if they are not in the file's own buffer. */
  const contentOf = ({ buffer, byteOffset = 0, byteLength }: Pick<GltfBufferView, 'buffer' | 'byteOffset' | 'byteLength'>) =>
    binary !== null && buffer === 0 && buffers[0]?.uri === undefined ? binary.subarray(byteOffset, byteOffset + byteLength) : null;

  bufferViews.forEach((view, i) => {
    if (!isPacked(view)) return;
    const packed = (view.extensions?.EXT_meshopt_compression ?? view.extensions?.KHR_meshopt_compression) as Partial<PackedView> | null;
    const { buffer, byteOffset = 0, byteLength, byteStride, count, mode = '' } = packed ?? {};
    if (![buffer, byteOffset, byteLength, byteStride, count].every((number) => Number.isInteger(number) && (number as number) >= 0)) {
      throw damaged(`compressed buffer view ${i} does not describe its content`);
    }
    const whole = { buffer, byteOffset, byteLength, byteStride, count } as PackedView;
    if (whole.byteOffset + whole.byteLength > (buffers[whole.buffer]?.byteLength ?? 0)) {
      throw damaged(`compressed buffer view ${i} exceeds its buffer`);
    }
    checkUnpacked(whole.byteStride * whole.count, `compressed buffer view ${i}`);
    const content = contentOf(whole);
    if (content !== null && ((content[0] ?? 0) & 0xf0) !== MESHOPT_HEADS[mode]) throw notDecoded(`compressed buffer view ${i}`, 'meshopt');
  });

  meshes.forEach(({ primitives }, i) => {
    for (const { extensions } of primitives) {
      const draco = extensions?.KHR_draco_mesh_compression as { readonly bufferView?: number } | undefined;
      if (draco === undefined) continue;
      const view = bufferViews[draco.bufferView ?? -1];
      if (!view) throw damaged(`mesh ${i} refers to a missing buffer view`);
      const content = contentOf(view);
      // Draco Bitstream Specification, §4.1.
      if (content !== null && new TextDecoder('latin1').decode(content.subarray(0, 5)) !== 'DRACO') throw notDecoded(`mesh ${i}`, 'Draco');
    }
  });
}

interface PackedView extends Required<Pick<GltfBufferView, 'buffer' | 'byteOffset' | 'byteLength' | 'byteStride'>> {
  readonly count: number;
  readonly mode?: string;
}

export function checkUnpacked(bytes: number, what: string): void {
  if (bytes <= MAX_UNPACKED_BYTES) return;
  throw damaged(`${what} has ${Math.round(bytes / 2 ** 20)} MB, but the limit is ${MAX_UNPACKED_BYTES / 2 ** 20} MB`);
}

function notDecoded(what: string, decoder: string) {
  return damaged(`${what} is not valid ${decoder} data`);
}
