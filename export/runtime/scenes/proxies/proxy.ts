import { type Material, Matrix4, Sphere } from 'three';
import type { ObjectItem } from '../../../../nodes/kit/scene-lists.ts';
import { boundsInObject, type Drawable, isInstanced, isShown, isSkinned } from './drawable.ts';

/** How one master is to be drawn in a scene. A master may need several: a depth pass before its colors, two sides. */
export interface ProxyPlan {
  readonly material: Material | Material[];
  /** Draws before others of a higher order; within one order three sorts. */
  readonly renderOrder: number;
  /** Asked every frame; absent means always. */
  readonly shows?: (item: ObjectItem) => boolean;
}

/**
 * A flat stand-in for a master (ADR 6): the same geometry, skeleton and morph weights, another material, and a world matrix that
 * is set from the item instead of a hierarchy.
 */
export interface FlatProxy {
  readonly object: Drawable;
  readonly master: Drawable;
  readonly item: ObjectItem;
  /** Takes over this frame's matrix and flags. */
  update(): void;
  dispose(): void;
}

// Read by the call that fills it, before anything else can.
const scratchInverse = new Matrix4();

export function createProxy(master: Drawable, item: ObjectItem, plan: ProxyPlan): FlatProxy {
  const object = cloneSharing(master);
  object.material = plan.material;
  object.renderOrder = plan.renderOrder;
  object.matrixAutoUpdate = false;
  object.matrixWorldAutoUpdate = false;
  const { shows } = plan;
  let placed = isInstanced(object) ? object.instanceMatrix.version : 0;

  /** three leaves out what its sphere says is out of sight, and makes that once. */
  function followInstances(): void {
    if (!isInstanced(object) || object.instanceMatrix.version === placed) return;
    placed = object.instanceMatrix.version;
    object.computeBoundingSphere();
  }

  return {
    object,
    master,
    item,
    update: () => {
      object.visible = (shows?.(item) ?? true) && isShown(master, item.root);
      object.receiveShadow = item.receivesShadow;
      followInstances();
      object.matrixWorld.multiplyMatrices(item.worldFromObject, master.matrixWorld);
    },
    dispose: () => {
      object.removeFromParent();
      // Frees three's record of the instance buffers; it uploads them again for other proxies that share them.
      if (isInstanced(object)) object.dispose();
    },
  };
}

/** three's own copy, so that any subclass keeps what it is, with the copied per-frame data swapped for the master's. */
function cloneSharing(master: Drawable): Drawable {
  const object = master.clone(false) as Drawable;
  if (master.morphTargetInfluences) object.morphTargetInfluences = master.morphTargetInfluences;
  if (isSkinned(master) && isSkinned(object)) {
    // The skeleton stands in object space: undoing the master's own matrix gives vertices in the space that `matrixWorld` of
    // the proxy maps to the world, whatever the placement.
    object.bindMatrix = master.bindMatrix;
    object.bindMatrixInverse = master.bindMatrixInverse;
    // Vertices move with the bones, out of any sphere made once. Sorting still asks for one.
    object.frustumCulled = false;
    object.boundingSphere = boundsInObject(master, new Sphere()).applyMatrix4(scratchInverse.copy(master.matrixWorld).invert());
  }
  if (isInstanced(master) && isInstanced(object)) {
    object.instanceMatrix = master.instanceMatrix;
    object.instanceColor = master.instanceColor;
    object.morphTexture = master.morphTexture;
  }
  return object;
}
