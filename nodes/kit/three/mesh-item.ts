import { Matrix4, type Mesh } from 'three';
import type { ObjectItem } from '../scene-lists.ts';

/**
 * Creates an object that consists of one mesh. The node writes the mesh's place within the object to `mesh.matrixWorld`, which three.js
 * leaves alone.
 *
 * @param flags Which shadows the object casts and receives. Default: none.
 *
 * @example
 * const item = createMeshItem('line', mesh);
 */
export function createMeshItem(
  key: string,
  mesh: Mesh,
  flags: Partial<Pick<ObjectItem, 'castsShadow' | 'receivesShadow' | 'hidden'>> = {},
): ObjectItem {
  mesh.matrixAutoUpdate = false;
  mesh.matrixWorldAutoUpdate = false;
  return { key, root: mesh, worldFromObject: new Matrix4(), role: 'virtual', castsShadow: false, receivesShadow: false, ...flags };
}

/** Values of the params `CASTS_SHADOW` and `RECEIVES_SHADOW` of `material-params.ts`. */
export interface ShadowValues {
  readonly castShadow: { readonly value: boolean };
  readonly receiveShadow: { readonly value: boolean };
}

/**
 * Sets which shadows an object casts and receives.
 *
 * @example
 * setShadows(item, ctx.params);
 */
export function setShadows(item: ObjectItem, { castShadow, receiveShadow }: ShadowValues): void {
  item.castsShadow = castShadow.value;
  item.receivesShadow = receiveShadow.value;
}
