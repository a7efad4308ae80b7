import { Group, InstancedMesh, Matrix4, type Mesh, type Object3D } from 'three';
import type { ObjectItem } from '../../kit/scene-lists.ts';

/** The copies of one object. */
export interface Copied {
  readonly source: ObjectItem;
  /** The items of the output list: one that draws all copies as instances, or one per copy. */
  readonly items: readonly ObjectItem[];
  /** Updates pose, flags and transforms; the number of transforms does not change. */
  update(places: readonly Matrix4[]): void;
  dispose(): void;
}

// Filled and read within one call.
const scratchMatrix = new Matrix4();

export function createCopied(source: ObjectItem, key: string, count: number): Copied {
  return canBeInstances(source.root) ? createInstances(source, key, count) : createItems(source, key, count);
}

/**
 * Whether the subtree can be drawn as instances: only meshes without skinning and morphing, and without transparency, which needs
 * sorting by distance.
 */
export function canBeInstances(root: Object3D): boolean {
  if ('isLine' in root || 'isPoints' in root || 'isInstancedMesh' in root) return false;
  if (isMesh(root)) {
    const { material, morphTargetInfluences } = root;
    if ('isSkinnedMesh' in root || morphTargetInfluences) return false;
    if (Array.isArray(material) ? material.some(({ transparent }) => transparent) : material.transparent) return false;
  }
  const { children } = root;
  for (let i = 0; i < children.length; i++) {
    const child = children[i];
    if (child && !canBeInstances(child)) return false;
  }
  return true;
}

function createInstances(source: ObjectItem, key: string, count: number): Copied {
  const root = new Group();
  const parts: { readonly mesh: Mesh; readonly instances: InstancedMesh }[] = [];
  source.root.traverse((object) => {
    if (!isMesh(object)) return;
    const instances = new InstancedMesh(object.geometry, object.material, count);
    instances.matrixAutoUpdate = false;
    instances.matrixWorldAutoUpdate = false;
    instances.renderOrder = object.renderOrder;
    root.add(instances);
    parts.push({ mesh: object, instances });
  });
  const item: ObjectItem = { ...source, key, root, worldFromObject: new Matrix4() };
  return {
    source,
    items: [item],
    update: (places) => {
      item.castsShadow = source.castsShadow;
      item.receivesShadow = source.receivesShadow;
      for (let p = 0; p < parts.length; p++) {
        const part = parts[p];
        if (!part) continue;
        const { mesh, instances } = part;
        instances.visible = isShown(mesh, source.root);
        let moved = false;
        for (let i = 0; i < places.length; i++) {
          const place = places[i];
          if (!place) continue;
          scratchMatrix.multiplyMatrices(place, source.worldFromObject).multiply(mesh.matrixWorld);
          moved = setInstance(instances.instanceMatrix.array, i, scratchMatrix) || moved;
        }
        if (!moved) continue;
        instances.instanceMatrix.needsUpdate = true;
        instances.computeBoundingSphere();
      }
    },
    dispose: () => {
      for (const { instances } of parts) instances.dispose();
    },
  };
}

/** Whether a matrix changed, compared as 32-bit floats, as it is stored. */
function setInstance(into: { [index: number]: number }, index: number, { elements }: Matrix4): boolean {
  let changed = false;
  for (let c = 0; c < 16; c++) {
    const value = Math.fround(elements[c] ?? 0);
    if (into[index * 16 + c] === value) continue;
    into[index * 16 + c] = value;
    changed = true;
  }
  return changed;
}

function createItems(source: ObjectItem, key: string, count: number): Copied {
  const items = Array.from({ length: count }, (_, i): ObjectItem => ({ ...source, key: `${key}/${i}`, worldFromObject: new Matrix4() }));
  return {
    source,
    items,
    update: (places) => {
      for (let i = 0; i < items.length; i++) {
        const item = items[i];
        const place = places[i];
        if (!item || !place) continue;
        item.worldFromObject.multiplyMatrices(place, source.worldFromObject);
        item.castsShadow = source.castsShadow;
        item.receivesShadow = source.receivesShadow;
      }
    },
    dispose: () => {},
  };
}

function isMesh(object: Object3D): object is Mesh {
  return 'isMesh' in object;
}

function isShown(object: Object3D, root: Object3D): boolean {
  for (let at: Object3D | null = object; at !== null; at = at.parent) {
    if (!at.visible) return false;
    if (at === root) return true;
  }
  return true;
}
