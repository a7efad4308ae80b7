import type { ObjectItem, ObjectList } from './runtime.ts';

/** Keeps an output list in step with the lists that it is made from. */
export interface DerivedObjects {
  /** Once per frame: takes over items that came or went, and matrices and flags of all. */
  update(inputs: readonly ObjectList[]): void;
}

/**
 * Strings several lists together in one of the node's own, in order. `adjust` is called for every item and frame, when the item
 * has its source's matrix and flags, and changes what the node is there to change.
 *
 * @example
 * const derived = deriveObjects(ctx.outputs.objects, (item) => { item.castsShadow = false; });
 */
export function deriveObjects(output: ObjectList, adjust: (item: ObjectItem) => void): DerivedObjects {
  const sources: ObjectItem[] = [];
  let seen: ObjectList[] = [];
  const versions: number[] = [];

  function isSame(inputs: readonly ObjectList[]): boolean {
    if (inputs.length !== seen.length) return false;
    for (let i = 0; i < inputs.length; i++) {
      if (inputs[i] !== seen[i] || inputs[i]?.version !== versions[i]) return false;
    }
    return true;
  }

  function rebuild(inputs: readonly ObjectList[]): void {
    seen = [...inputs];
    versions.length = 0;
    sources.length = 0;
    output.items.length = 0;
    inputs.forEach((list, i) => {
      versions.push(list.version);
      for (const source of list.items) {
        sources.push(source);
        // A list may be wired in twice.
        output.items.push({ ...source, key: `${i}/${source.key}`, worldFromObject: source.worldFromObject.clone() });
      }
    });
    output.version++;
  }

  return {
    update: (inputs) => {
      if (!isSame(inputs)) rebuild(inputs);
      for (let i = 0; i < sources.length; i++) {
        const source = sources[i];
        const item = output.items[i];
        if (!source || !item) continue;
        item.worldFromObject.copy(source.worldFromObject);
        item.castsShadow = source.castsShadow;
        item.receivesShadow = source.receivesShadow;
        adjust(item);
      }
    },
  };
}
