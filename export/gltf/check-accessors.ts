import { checkUnpacked } from './check-packed.ts';
import { damaged, elementBytes, type GltfAccessor, type GltfDocument, isPacked } from './document.ts';

/** glTF 2.0, §3.6.2.3: values that replace elements of an accessor. */
interface Sparse {
  readonly count?: number;
  readonly indices?: { readonly bufferView?: number; readonly byteOffset?: number; readonly componentType?: number };
  readonly values?: { readonly bufferView?: number; readonly byteOffset?: number };
}

const INDEX_BYTES: Readonly<Record<number, number>> = { 5121: 1, 5123: 2, 5125: 4 };

/** Rejects accessors that three.js would read beyond the end of a buffer or fail on with its own messages. */
export function checkAccessors(document: GltfDocument): void {
  const { accessors = [], meshes = [], bufferViews = [] } = document;
  accessors.forEach((accessor, i) => {
    const bytes = elementBytes(accessor);
    if (bytes === null) throw damaged(`the type of accessor ${i} is invalid`);
    if (!Number.isInteger(accessor.count) || accessor.count < 1) throw damaged(`accessor ${i} has ${accessor.count} elements`);
    checkUnpacked(accessor.count * bytes, `accessor ${i}`);
    checkSparse(document, accessor, i);
    if (accessor.bufferView === undefined) return;
    const view = bufferViews[accessor.bufferView];
    if (!view) throw damaged(`accessor ${i} refers to a missing buffer view`);
    if (isPacked(view)) return;
    const lastByte = (accessor.byteOffset ?? 0) + (view.byteStride ?? bytes) * (accessor.count - 1) + bytes;
    if (lastByte > view.byteLength) throw damaged(`accessor ${i} exceeds its buffer view`);
  });
  meshes.forEach(({ primitives }, i) => {
    for (const { attributes, indices, targets = [] } of primitives) {
      const lists = [...Object.values(attributes), ...targets.flatMap((target) => Object.values(target))];
      if (indices !== undefined) lists.push(indices);
      if (lists.some((index) => accessors[index] === undefined)) throw damaged(`mesh ${i} refers to a missing accessor`);
      checkCounts(Object.values(attributes), accessors, i);
    }
  });
}

/** Rejects a primitive whose attributes have different counts (glTF 2.0, §3.7.2.1). */
function checkCounts(attributes: readonly number[], accessors: readonly GltfAccessor[], mesh: number): void {
  const counts = new Set(attributes.map((index) => accessors[index]?.count));
  if (counts.size > 1) throw damaged(`the attributes of mesh ${mesh} have different lengths`);
}

/** Rejects sparse accessors whose data is not in the file. */
function checkSparse({ bufferViews = [] }: GltfDocument, accessor: GltfAccessor, i: number): void {
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
