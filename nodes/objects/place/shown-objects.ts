import type { Matrix4 } from 'three';
import type { ObjectItem, ObjectList } from '../../kit/scene-lists.ts';
import { type CopiedObject, createCopiedObject } from '../../kit/three/copied-objects.ts';
import { createVersionWatch } from '../../kit/version-watch.ts';

/** Keeps the output list: the copies of all connected objects, followed by the items of the reticle. */
export interface ShownObjects {
  /**
   * Updates the list. Call it once per frame. `places` has an entry per copy, null while the copy is not placed; hidden items stay in the
   * list.
   */
  update(inputs: readonly ObjectList[], places: readonly (Matrix4 | null)[]): void;
  dispose(): void;
}

/**
 * Creates the keeper of an output list.
 *
 * @param extra Items of the reticle.
 * @param claimant The node that claims presses on the copies; null if none does.
 */
export function createShownObjects(output: ObjectList, extra: readonly ObjectItem[], claimant: object | null): ShownObjects {
  const copied: CopiedObject[] = [];
  const watch = createVersionWatch();

  function clear(): void {
    for (const each of copied) each.dispose();
    copied.length = 0;
    output.items.length = 0;
  }
  function rebuild(inputs: readonly ObjectList[], count: number): void {
    clear();
    inputs.forEach((list, i) => {
      for (const source of list.items) {
        const made = createCopiedObject(source, `${i}/${source.key}`, count);
        copied.push(made);
        for (const item of made.items) if (claimant) item.claimant = claimant;
        output.items.push(...made.items);
      }
    });
    output.items.push(...extra);
    output.version++;
  }
  function isOutdated(): boolean {
    for (let i = 0; i < copied.length; i++) if (copied[i]?.isOutdated()) return true;
    return false;
  }

  return {
    update: (inputs, places) => {
      if (watch.changed(inputs) || isOutdated()) rebuild(inputs, places.length);
      for (let i = 0; i < copied.length; i++) copied[i]?.update(places);
    },
    dispose: clear,
  };
}
