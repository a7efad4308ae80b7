import { Box3, Vector3 } from 'three';
import type { ObjectItem, ObjectList } from '../scene-lists.ts';
import { createVersionWatch } from '../version-watch.ts';

/** An upright cylinder around an object, in world space. */
export interface BoundingCylinder {
  /** Center of the cylinder's base. */
  readonly baseWorld: Float32Array;
  radiusM: number;
  heightM: number;
}

/** Computes upright cylinders around those objects of lists that are shown and cast shadows. */
export interface BoundingCylinders {
  /** Returns the cylinders of this frame. Call it once per frame. Skinned and morphed objects have the cylinders of their rest position. */
  update(lists: readonly ObjectList[]): readonly BoundingCylinder[];
}

interface Bounded {
  readonly item: ObjectItem;
  readonly box: Box3;
  readonly cylinder: BoundingCylinder;
}

// Valid within one call.
const scratchBox = new Box3();
const scratchSize = new Vector3();

export function createBoundingCylinders(): BoundingCylinders {
  const watch = createVersionWatch();
  let bounded: Bounded[] = [];
  const cylinders: BoundingCylinder[] = [];
  return {
    update: (lists) => {
      if (watch.changed(lists)) {
        bounded = lists.flatMap(({ items }) => items.map(bound)).filter(({ box }) => !box.isEmpty());
      }
      cylinders.length = 0;
      for (let i = 0; i < bounded.length; i++) {
        const each = bounded[i];
        // Both change without a new version of the list.
        if (!each?.item.castsShadow || each.item.hidden) continue;
        place(each);
        cylinders.push(each.cylinder);
      }
      return cylinders;
    },
  };
}

function bound(item: ObjectItem): Bounded {
  const cylinder = { baseWorld: new Float32Array(3), radiusM: 0, heightM: 0 };
  return { item, box: new Box3().setFromObject(item.root), cylinder };
}

function place({ item, box, cylinder }: Bounded): void {
  scratchBox.copy(box).applyMatrix4(item.worldFromObject);
  scratchBox.getSize(scratchSize);
  cylinder.baseWorld[0] = (scratchBox.min.x + scratchBox.max.x) / 2;
  cylinder.baseWorld[1] = scratchBox.min.y;
  cylinder.baseWorld[2] = (scratchBox.min.z + scratchBox.max.z) / 2;
  cylinder.radiusM = Math.hypot(scratchSize.x, scratchSize.z) / 2;
  cylinder.heightM = scratchSize.y;
}
