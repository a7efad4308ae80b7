import { type BufferGeometry, type Material, Matrix4, Sphere } from 'three';
import type { ObjectItem } from '../../../../nodes/kit/scene-lists.ts';
import { boundsInObject, type Drawable, isInstanced, isShown, isSkinned } from './drawable.ts';

/** How to draw a master in a scene. A master may need several plans, such as one for depth before its colors, or one per side. */
export interface ProxyPlan {
  readonly material: Material | Material[];
  /** The geometry to draw; absent means that of the master. */
  readonly geometry?: BufferGeometry;
  /** Lower values are drawn first; three.js sorts objects with equal ones. */
  readonly renderOrder: number;
  /** Whether the proxy is visible, evaluated every frame; absent means always. */
  readonly shows?: (item: ObjectItem) => boolean;
  /** Whether the proxy is glass, which shows what is behind it. */
  readonly isGlass?: boolean;
}

/**
 * A flat copy of a master (ADR 6): the same geometry, skeleton and morph weights, with another material and a world matrix that is set from
 * the item instead of a hierarchy.
 */
export interface FlatProxy {
  readonly object: Drawable;
  readonly master: Drawable;
  readonly item: ObjectItem;
  readonly isGlass: boolean;
  /** Applies this frame's matrix and flags. */
  update(): void;
  dispose(): void;
}

// Valid within one call.
const scratchInverse = new Matrix4();

export function createProxy(master: Drawable, item: ObjectItem, plan: ProxyPlan): FlatProxy {
  const object = cloneSharing(master);
  object.material = plan.material;
  if (plan.geometry) object.geometry = plan.geometry;
  object.renderOrder = plan.renderOrder;
  object.matrixAutoUpdate = false;
  object.matrixWorldAutoUpdate = false;
  const { shows } = plan;
  let placed = isInstanced(object) ? object.instanceMatrix.version : 0;

  /**
   * Updates the number of instances and, after instances have moved, the bounding sphere for frustum culling, which three.js computes only
   * once.
   */
  function followInstances(): void {
    if (!isInstanced(object) || !isInstanced(master)) return;
    object.count = master.count;
    if (object.instanceMatrix.version === placed) return;
    placed = object.instanceMatrix.version;
    object.computeBoundingSphere();
  }

  return {
    object,
    master,
    item,
    isGlass: plan.isGlass ?? false,
    update: () => {
      object.visible = !item.hidden && (shows?.(item) ?? true) && isShown(master, item.root);
      object.receiveShadow = item.receivesShadow;
      followInstances();
      object.matrixWorld.multiplyMatrices(item.worldFromObject, master.matrixWorld);
    },
    dispose: () => {
      object.removeFromParent();
      // Removes three.js' record of the instance buffers, which it uploads again for other proxies that share them.
      if (isInstanced(object)) object.dispose();
    },
  };
}

/** Clones a master by its own method, so that subclasses keep their type. The clone shares the master's data that changes per frame. */
function cloneSharing(master: Drawable): Drawable {
  const object = master.clone(false) as Drawable;
  if (master.morphTargetInfluences) object.morphTargetInfluences = master.morphTargetInfluences;
  if (isSkinned(master) && isSkinned(object)) {
    // The skeleton is in local space. Undoing the master's matrix gives vertices in the space that the proxy's `matrixWorld` maps to the
    // world.
    object.bindMatrix = master.bindMatrix;
    object.bindMatrixInverse = master.bindMatrixInverse;
    // The bones move vertices beyond any precomputed sphere. Sorting still needs one.
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
