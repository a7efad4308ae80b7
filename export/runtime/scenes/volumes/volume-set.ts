import type { BufferGeometry, Material, Mesh, Object3D, Scene } from 'three';
import type { ObjectItem, ObjectList } from '../../../../nodes/kit/scene-lists.ts';
import { createVersionWatch } from '../../../../nodes/kit/version-watch.ts';
import { isInstanced, materialsOf } from '../proxies/drawable.ts';
import { type Caster, castsAsSolid, createCaster, isSeeThrough, isShapedByTexture } from './caster.ts';
import { createMeshShape, type MeshShape } from './mesh-shape.ts';
import type { VolumeLight } from './volume-light.ts';

/** The volumes of all casters in one scene: rebuilt if a list or the lights changed, otherwise only moved. */
export interface VolumeSet {
  update(lights: readonly VolumeLight[], relit: boolean): void;
  dispose(): void;
}

/** Reports casters that shadow volumes cannot reproduce exactly. Each method receives the name of a caster in every frame. */
export interface VolumeLimits {
  /** Reports a caster whose shape depends on a texture: alpha that cuts holes, or displacement. */
  tellShaped(name: string): void;
  /** Reports a caster that lets light pass. */
  tellSeeThrough(name: string): void;
}

export function createVolumeSet(scene: Scene, lists: readonly ObjectList[], limits: VolumeLimits): VolumeSet {
  const casters: Caster[] = [];
  const watch = createVersionWatch();
  const shapes = new WeakMap<BufferGeometry, MeshShape>();
  let shaped: string | null = null;
  const meshes: { readonly mesh: Mesh; readonly item: ObjectItem }[] = [];

  function clear(): void {
    for (const caster of casters) caster.dispose();
    casters.length = 0;
    meshes.length = 0;
  }

  /** Returns the name of a transparent caster, or null. Searched in every frame, because materials may become transparent at run time. */
  function findSeeThrough(): string | null {
    for (let i = 0; i < meshes.length; i++) {
      const { mesh, item } = meshes[i] ?? {};
      if (mesh && item?.castsShadow && hasSeeThrough(mesh)) return mesh.name || item.key;
    }
    return null;
  }

  /** The shape of a geometry with one material; cached, because it does not depend on the material's values. */
  function shapeOf(mesh: Mesh): MeshShape {
    const { geometry } = mesh;
    const materials = materialsOf(mesh);
    if (Array.isArray(mesh.material)) return createMeshShape(geometry, (i) => materials[i] !== undefined && castsAsSolid(materials[i]));
    const shape = shapes.get(geometry) ?? createMeshShape(geometry, () => true);
    shapes.set(geometry, shape);
    return shape;
  }

  function add(object: Object3D, item: ObjectItem, lights: readonly VolumeLight[]): void {
    // Lines and points have no inside.
    if (!isMesh(object)) return;
    const shape = shapeOf(object);
    meshes.push({ mesh: object, item });
    if (materialsOf(object).some((material) => castsAsSolid(material) && isShapedByTexture(material))) shaped ??= object.name || item.key;
    const count = isInstanced(object) ? object.count : 1;
    for (let i = 0; i < count; i++) casters.push(createCaster(scene, object, item, i, shape, lights));
  }

  return {
    update: (lights, relit) => {
      if (watch.changed(lists) || relit) {
        clear();
        shaped = null;
        for (const { items } of lists) for (const item of items) item.root.traverse((object) => add(object, item, lights));
      }
      if (shaped !== null) limits.tellShaped(shaped);
      const seeThrough = findSeeThrough();
      if (seeThrough !== null) limits.tellSeeThrough(seeThrough);
      for (let i = 0; i < casters.length; i++) casters[i]?.update();
    },
    dispose: clear,
  };
}

function hasSeeThrough({ material }: Mesh): boolean {
  if (!Array.isArray(material)) return isSeeThrough(material);
  for (let i = 0; i < material.length; i++) if (material[i] && isSeeThrough(material[i] as Material)) return true;
  return false;
}

function isMesh(object: Object3D): object is Mesh {
  return 'isMesh' in object;
}
