import { type Gltf, type GltfAccessor, isPacked } from './document.ts';

const READERS = {
  5120: { bytes: 1, read: (view: DataView, at: number) => view.getInt8(at) },
  5121: { bytes: 1, read: (view: DataView, at: number) => view.getUint8(at) },
  5122: { bytes: 2, read: (view: DataView, at: number) => view.getInt16(at, true) },
  5123: { bytes: 2, read: (view: DataView, at: number) => view.getUint16(at, true) },
  5125: { bytes: 4, read: (view: DataView, at: number) => view.getUint32(at, true) },
  5126: { bytes: 4, read: (view: DataView, at: number) => view.getFloat32(at, true) },
} as const;

/** The values of an uncompressed accessor, or null if they cannot be read. Normalized integers are not converted. */
export function readNumbers({ document, binary }: Gltf, index: number | undefined): Float64Array | null {
  const accessor = index === undefined ? undefined : document.accessors?.[index];
  const view = accessor?.bufferView === undefined ? undefined : document.bufferViews?.[accessor.bufferView];
  if (!accessor || !view || !binary || view.buffer !== 0 || isPacked(view) || accessor.sparse !== undefined) return null;
  const reader = READERS[accessor.componentType as keyof typeof READERS];
  const components = componentsOf(accessor);
  if (!reader || components === null) return null;
  const numbers = new Float64Array(accessor.count * components);
  const data = new DataView(binary.buffer, binary.byteOffset + (view.byteOffset ?? 0) + (accessor.byteOffset ?? 0));
  const stride = view.byteStride ?? components * reader.bytes;
  for (let i = 0; i < accessor.count; i++) {
    for (let c = 0; c < components; c++) numbers[i * components + c] = reader.read(data, i * stride + c * reader.bytes);
  }
  return numbers;
}

const COMPONENTS: Readonly<Record<string, number>> = { SCALAR: 1, VEC3: 3, VEC4: 4, MAT4: 16 };

function componentsOf({ type }: GltfAccessor): number | null {
  return COMPONENTS[type] ?? null;
}
