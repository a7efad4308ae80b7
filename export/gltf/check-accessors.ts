import { checkUnpacked } from './check-packed.ts';
import { checkSparse } from './check-sparse.ts';
import { damaged, elementBytes, type GltfAccessor, type GltfDocument, isPacked } from './document.ts';

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

/** All attributes of a primitive must have the same count (§3.7.2.1). */
function checkCounts(attributes: readonly number[], accessors: readonly GltfAccessor[], mesh: number): void {
  const counts = new Set(attributes.map((index) => accessors[index]?.count));
  if (counts.size > 1) throw damaged(`the attributes of mesh ${mesh} have different lengths`);
}
