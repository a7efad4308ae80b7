import type { ObjectItem, ObjectList } from './scene-lists.ts';
import { createVersionWatch } from './version-watch.ts';

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
  const watch = createVersionWatch();

  function rebuild(inputs: readonly ObjectList[]): void {
    sources.length = 0;
    output.items.length = 0;
    inputs.forEach((list, i) => {
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
      if (watch.changed(inputs)) rebuild(inputs);
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
