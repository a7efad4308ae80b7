import { Group, InstancedMesh, Matrix4, type Mesh, type Object3D } from 'three';
import type { ObjectItem } from '../scene-lists.ts';

/** The copies of one object. */
export interface CopiedObject {
  readonly source: ObjectItem;
  /** The items to put into the output list: one that draws all copies as instances, or one per copy. They stay the same objects. */
  readonly items: readonly ObjectItem[];
  /**
   * Updates poses, flags and transforms. Call it once per frame.
   *
   * @param places For each copy, the matrix from the space of the source to world space; null if the copy is not shown.
   */
  update(places: readonly (Matrix4 | null)[]): void;
  /**
   * Whether the way of drawing no longer fits the parts: because a material has become transparent or opaque, instances are impossible or
   * have become possible. The caller then creates the copies again.
   */
  isOutdated(): boolean;
  /** Disposes the instance buffers. */
  dispose(): void;
}

// Filled and read within one call.
const scratchMatrix = new Matrix4();

/**
 * Copies an object: several copies as instances if its parts allow it, else as one item per copy, with the key `key/index`. Instances are
 * for subtrees of meshes without skinning and morphing, and without transparency, which needs sorting by distance.
 *
 * @param source The object to copy. Copies share its geometries and materials, and follow its flags.
 * @param key Unique within the output list.
 * @param count Number of copies, shown or not.
 * @returns The caller disposes it.
 *
 * @example
 * const copied = createCopiedObject(source, `0/${source.key}`, places.length);
 * ctx.outputs.objects.items.push(...copied.items);
 * // Every frame:
 * copied.update(places);
 */
export function createCopiedObject(source: ObjectItem, key: string, count: number): CopiedObject {
  return count > 1 && canBeInstances(source.root) ? createInstances(source, key, count) : createItems(source, key, count);
}

function canBeInstances(root: Object3D): boolean {
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

function createInstances(source: ObjectItem, key: string, count: number): CopiedObject {
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
      let shown = 0;
      for (let p = 0; p < parts.length; p++) {
        const part = parts[p];
        if (!part) continue;
        const { mesh, instances } = part;
        instances.visible = isShown(mesh, source.root);
        shown = 0;
        let moved = false;
        for (let i = 0; i < places.length; i++) {
          const place = places[i];
          if (!place) continue;
          scratchMatrix.multiplyMatrices(place, source.worldFromObject).multiply(mesh.matrixWorld);
          moved = setInstance(instances.instanceMatrix.array, shown++, scratchMatrix) || moved;
        }
        if (!moved && instances.count === shown) continue;
        instances.count = shown;
        instances.instanceMatrix.needsUpdate = true;
        instances.computeBoundingSphere();
      }
      item.hidden = (source.hidden ?? false) || shown === 0;
    },
    isOutdated: () => !canBeInstances(source.root),
    dispose: () => {
      for (const { instances } of parts) instances.dispose();
    },
  };
}

/** Writes the matrix of an instance. Returns whether it has changed, compared as the 32-bit floats that are stored. */
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

function createItems(source: ObjectItem, key: string, count: number): CopiedObject {
  const items = Array.from({ length: count }, (_, i): ObjectItem => ({ ...source, key: `${key}/${i}`, worldFromObject: new Matrix4() }));
  return {
    source,
    items,
    update: (places) => {
      for (let i = 0; i < items.length; i++) {
        const item = items[i];
        if (!item) continue;
        const place = places[i];
        item.worldFromObject.copy(source.worldFromObject);
        if (place) item.worldFromObject.premultiply(place);
        item.hidden = (source.hidden ?? false) || !place;
        item.castsShadow = source.castsShadow;
        item.receivesShadow = source.receivesShadow;
      }
    },
    isOutdated: () => count > 1 && canBeInstances(source.root),
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
