import type { ObjectItem, ObjectList } from './scene-lists.ts';
import { createVersionWatch } from './version-watch.ts';

const NOTHING: readonly ObjectList[] = [];

/** An output list whose items are copies of the items of input lists, kept up to date. */
export interface DerivedObjects {
  /**
   * Updates the output list: adds and removes items as in the inputs, and copies the matrices and flags of all items. `shown: false`
   * empties the list. Call it once per frame.
   */
  update(inputs: readonly ObjectList[], shown?: boolean): void;
}

/**
 * Concatenates object lists into an output list of the node. Items are copies, so the inputs do not change.
 *
 * @param output The node's output.
 * @param adjust Called for each item in every frame, after the matrix and the flags of its source have been copied. Makes the changes
 * that the node is for; must allocate nothing.
 *
 * @example
 * const derived = deriveObjects(ctx.outputs.objects, (item) => { item.castsShadow = false; });
 * // Every frame:
 * derived.update(ctx.inputs.objects);
 */
export function deriveObjects(output: ObjectList, adjust: (item: ObjectItem) => void): DerivedObjects {
  const sources: ObjectItem[] = [];
  const watch = createVersionWatch();
  let isShown = true;

  function rebuild(inputs: readonly ObjectList[]): void {
    sources.length = 0;
    output.items.length = 0;
    inputs.forEach((list, i) => {
      for (const source of list.items) {
        sources.push(source);
        // The same list can be connected twice, so the index makes the key unique.
        output.items.push({ ...source, key: `${i}/${source.key}`, worldFromObject: source.worldFromObject.clone() });
      }
    });
    output.version++;
  }

  return {
    update: (inputs, shown = true) => {
      const changed = watch.changed(inputs) || shown !== isShown;
      isShown = shown;
      if (changed) rebuild(shown ? inputs : NOTHING);
      for (let i = 0; i < sources.length; i++) {
        const source = sources[i];
        const item = output.items[i];
        if (!source || !item) continue;
        item.worldFromObject.copy(source.worldFromObject);
        item.castsShadow = source.castsShadow;
        item.receivesShadow = source.receivesShadow;
        item.hidden = source.hidden ?? false;
        adjust(item);
      }
    },
  };
}
