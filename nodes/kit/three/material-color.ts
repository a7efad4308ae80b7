import type { Color, Material, MeshStandardMaterial } from 'three';

/**
 * Sets the color and the opacity of a material. The material is transparent only if alpha is below 1.
 *
 * @param color Display-referred sRGB, straight alpha.
 *
 * @example
 * setMaterialColor(material, params.color.value);
 */
export function setMaterialColor(material: Material & { readonly color: Color }, color: ArrayLike<number>): void {
  material.color.setRGB(color[0] ?? 1, color[1] ?? 1, color[2] ?? 1).convertSRGBToLinear();
  material.opacity = color[3] ?? 1;
  const isTransparent = material.opacity < 1;
  if (material.transparent === isTransparent) return;
  material.transparent = isTransparent;
  material.needsUpdate = true;
}

/** Values of the params `BASE_COLOR`, `ROUGHNESS` and `METALNESS` of `material-params.ts`. */
export interface SurfaceValues {
  readonly color: { readonly value: ArrayLike<number> };
  readonly roughness: { readonly value: number };
  readonly metalness: { readonly value: number };
}

/**
 * Sets color, opacity, roughness and metalness of a material.
 *
 * @example
 * setSurface(material, ctx.params);
 */
export function setSurface(material: MeshStandardMaterial, { color, roughness, metalness }: SurfaceValues): void {
  setMaterialColor(material, color.value);
  material.roughness = roughness.value;
  material.metalness = metalness.value;
}
