import type { Color, Euler, Material, Matrix3, Vector2, Vector3 } from 'three';

/** Properties that belong to one material object or depend on the scene (`layer-blending.ts`), and are not copied. */
const OWN = new Set([
  ...['uuid', 'id', 'name', 'type', 'version', 'userData', '_listeners', 'defines', 'onBeforeCompile', 'customProgramCacheKey'],
  ...['blending', 'blendSrc', 'blendDst', 'blendEquation', 'blendSrcAlpha', 'blendDstAlpha', 'blendEquationAlpha'],
]);

type Values = Record<string, unknown>;
type Copyable = { copy(from: Copyable): void };

/**
 * Makes `material` follow every value of `master`: numbers, booleans and textures by reference, colors and vectors by copy. As in three.js,
 * code that changes something compiled sets the master's `needsUpdate`; the returned function then sets it on the follower and returns
 * true. Keys in `fixed` are skipped.
 *
 * `Material.copy` clones user data, planes and defines in each call.
 */
export function follow(material: Material, master: Material, fixed: readonly string[] = []): () => boolean {
  const from = master as unknown as Values;
  const to = material as unknown as Values;
  const keys = Object.keys(from).filter((key) => !OWN.has(key) && !fixed.includes(key) && key in to);
  let version = master.version;
  return () => {
    for (const key of keys) {
      const value = from[key];
      if (isCopyable(value)) (to[key] as Copyable).copy(value);
      else if (to[key] !== value) to[key] = value;
    }
    if (master.version === version) return false;
    version = master.version;
    material.needsUpdate = true;
    return true;
  };
}

/** Whether a value is copied, as colors and vectors are. Textures have a `copy` method too, but are shared. */
function isCopyable(value: unknown): value is Copyable {
  if (typeof value !== 'object' || value === null) return false;
  const kind = value as Partial<Color & Vector2 & Vector3 & Euler & Matrix3>;
  return Boolean(kind.isColor || kind.isVector2 || kind.isVector3 || kind.isEuler || 'isMatrix3' in value);
}
