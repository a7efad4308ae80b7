import {
  type InstancedMesh,
  type Line,
  type Material,
  type Mesh,
  type Object3D,
  type Points,
  type SkinnedMesh,
  type Sphere,
  Vector3,
} from 'three';

/** What can be drawn: lines and points too, skinned and instanced meshes among the meshes. */
export type Drawable = Mesh | Line | Points;

// Read by the call that fills it, before anything else can.
const scratchBone = new Vector3();

export function isDrawable(object: Object3D): object is Drawable {
  return 'isMesh' in object || 'isLine' in object || 'isPoints' in object;
}

export function isSkinned(object: Object3D): object is SkinnedMesh {
  return 'isSkinnedMesh' in object;
}

export function isInstanced(object: Object3D): object is InstancedMesh {
  return 'isInstancedMesh' in object;
}

/** Whether neither the object nor an ancestor up to and including `root` is hidden. */
export function isShown(object: Object3D, root: Object3D): boolean {
  for (let at: Object3D | null = object; at !== null; at = at.parent) {
    if (!at.visible) return false;
    if (at === root) return true;
  }
  return true;
}

export function materialsOf(object: Drawable): readonly Material[] {
  return Array.isArray(object.material) ? object.material : [object.material];
}

/** One material of the object's, or several by geometry group, each turned into another. */
export function mapMaterials(object: Drawable, turn: (material: Material) => Material): Material | Material[] {
  return Array.isArray(object.material) ? object.material.map(turn) : turn(object.material);
}

/**
 * Everything about an object that three compiles into a program beside the material. Objects that differ here get materials of
 * their own: one material drawn both skinned and not would look up its program anew at every draw (`setProgram`).
 */
export function programFeatures(object: Drawable): string {
  const { attributes, morphAttributes } = object.geometry;
  const features: string[] = [];
  if (isSkinned(object)) features.push('skin');
  if (isInstanced(object)) features.push(`instance${object.instanceColor === null ? '' : 'color'}${object.morphTexture ? 'morph' : ''}`);
  if (!attributes.normal) features.push('flat');
  if (attributes.tangent) features.push('tangent');
  if (attributes.color?.itemSize === 4) features.push('alpha');
  for (const [name, targets] of Object.entries(morphAttributes)) features.push(`${name}${targets?.length ?? 0}`);
  return features.join();
}

/**
 * A sphere around what the object draws, in object space. A skinned mesh is where its bones are, wherever its vertices rest:
 * exporters scale the two differently. Half the bones' extent is added for the flesh around them.
 */
export function boundsInObject(object: Drawable, into: Sphere): Sphere {
  if (isSkinned(object)) return skeletonBounds(object, into);
  if (isInstanced(object)) {
    if (object.boundingSphere === null) object.computeBoundingSphere();
    into.copy(object.boundingSphere ?? into.makeEmpty());
  } else {
    if (object.geometry.boundingSphere === null) object.geometry.computeBoundingSphere();
    into.copy(object.geometry.boundingSphere ?? into.makeEmpty());
  }
  return into.isEmpty() ? into : into.applyMatrix4(object.matrixWorld);
}

function skeletonBounds(object: SkinnedMesh, into: Sphere): Sphere {
  into.makeEmpty();
  for (const bone of object.skeleton.bones) into.expandByPoint(scratchBone.setFromMatrixPosition(bone.matrixWorld));
  into.radius *= 1.5;
  return into;
}
