import { checkUnpacked } from './check-packed.ts';
import { checkSparse } from './check-sparse.ts';
import { damaged, elementBytes, type GltfAccessor, type GltfDocument, isPacked } from './document.ts';

/** Refuses what three would read past the end of a buffer for, or stop at with words of its own. */
export function checkAccessors(document: GltfDocument): void {
  const { accessors = [], meshes = [], bufferViews = [] } = document;
  accessors.forEach((accessor, i) => {
    const bytes = elementBytes(accessor);
    if (bytes === null) throw damaged(`its list ${i} is of a kind that glTF does not have`);
    if (!Number.isInteger(accessor.count) || accessor.count < 1) throw damaged(`its list ${i} has ${accessor.count} entries`);
    checkUnpacked(accessor.count * bytes, `list ${i}`);
    checkSparse(document, accessor, i);
    if (accessor.bufferView === undefined) return;
    const view = bufferViews[accessor.bufferView];
    if (!view) throw damaged(`its list ${i} names a part that is not there`);
    if (isPacked(view)) return;
    const lastByte = (accessor.byteOffset ?? 0) + (view.byteStride ?? bytes) * (accessor.count - 1) + bytes;
    if (lastByte > view.byteLength) throw damaged(`its list ${i} is longer than the part that holds it`);
  });
  meshes.forEach(({ primitives }, i) => {
    for (const { attributes, indices, targets = [] } of primitives) {
      const lists = [...Object.values(attributes), ...targets.flatMap((target) => Object.values(target))];
      if (indices !== undefined) lists.push(indices);
      if (lists.some((index) => accessors[index] === undefined)) throw damaged(`its mesh ${i} names a list that is not there`);
      checkCounts(Object.values(attributes), accessors, i);
    }
  });
}

/** All attributes of a primitive have an entry per vertex (§3.7.2.1). */
function checkCounts(attributes: readonly number[], accessors: readonly GltfAccessor[], mesh: number): void {
  const counts = new Set(attributes.map((index) => accessors[index]?.count));
  if (counts.size > 1) throw damaged(`the vertices of its mesh ${mesh} have attributes of different lengths`);
}
