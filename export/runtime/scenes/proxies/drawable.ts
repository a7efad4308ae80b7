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

/** Objects that can be drawn: meshes (skinned and instanced ones too), lines and points. */
export type Drawable = Mesh | Line | Points;

// Valid within one call.
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

/** Whether the object and its ancestors up to `root` are visible. */
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

/** Returns the materials of an object, each replaced by the result of `turn`: one material, or one per geometry group. */
export function mapMaterials(object: Drawable, turn: (material: Material) => Material): Material | Material[] {
  return Array.isArray(object.material) ? object.material.map(turn) : turn(object.material);
}

/**
 * Features of an object that three.js compiles into a program, apart from the material. Objects that differ here get separate materials;
 * otherwise three.js would look up the program at every draw (`setProgram`).
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
 * Bounding sphere of an object in its local space. For a skinned mesh it encloses the bones, because exporters scale vertices and bones
 * differently, plus half their extent.
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
