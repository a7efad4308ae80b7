import { damaged, elementBytes, type GltfAccessor, type GltfDocument } from './document.ts';

/** glTF 2.0, §3.6.2.3: values that replace elements of an accessor. */
interface Sparse {
  readonly count?: number;
  readonly indices?: { readonly bufferView?: number; readonly byteOffset?: number; readonly componentType?: number };
  readonly values?: { readonly bufferView?: number; readonly byteOffset?: number };
}

const INDEX_BYTES: Readonly<Record<number, number>> = { 5121: 1, 5123: 2, 5125: 4 };

/** Rejects sparse accessors whose data is not in the file. */
export function checkSparse({ bufferViews = [] }: GltfDocument, accessor: GltfAccessor, i: number): void {
  if (accessor.sparse === undefined) return;
  const { count = 0, indices, values } = accessor.sparse as Sparse;
  if (!Number.isInteger(count) || count < 1 || count > accessor.count) {
    throw damaged(`accessor ${i} replaces ${count} of ${accessor.count} elements`);
  }
  const indexBytes = INDEX_BYTES[indices?.componentType ?? 0];
  if (indexBytes === undefined) throw damaged(`accessor ${i} does not list the elements it replaces`);
  for (const [part, bytes] of [[indices, indexBytes] as const, [values, elementBytes(accessor) ?? 0] as const]) {
    const view = bufferViews[part?.bufferView ?? -1];
    if (!view) throw damaged(`accessor ${i} refers to a missing buffer view`);
    if ((part?.byteOffset ?? 0) + count * bytes > view.byteLength) throw damaged(`accessor ${i} exceeds its buffer view`);
  }
}
