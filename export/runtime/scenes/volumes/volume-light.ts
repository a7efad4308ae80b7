import { type ShaderMaterial, Vector4 } from 'three';
import type { DirectLightItem } from '../../../../nodes/kit/scene-lists.ts';
import { createVolumeMaterial } from './volume-material.ts';

/** A light and the materials of its shadow volumes. */
export interface VolumeLight {
  /** Where the light is, in world space: its position with w 1, or a unit vector towards it with w 0. */
  readonly lightWorld: { readonly value: Vector4 };
  /** Materials of the back faces and the front faces of volumes, drawn at `renderOrder` and `renderOrder + 1`. */
  readonly materials: readonly [ShaderMaterial, ShaderMaterial];
  readonly renderOrder: number;
  casts(): boolean;
  /** Applies the light's position or direction. */
  update(): void;
  dispose(): void;
}

export function createVolumeLight(light: DirectLightItem, renderOrder: number): VolumeLight {
  const lightWorld = { value: new Vector4() };
  const materials = [createVolumeMaterial('back', lightWorld), createVolumeMaterial('front', lightWorld)] as const;
  return {
    lightWorld,
    materials,
    renderOrder,
    casts: () => light.shadow !== null,
    update: () => {
      const at = light.kind === 'directional' ? light.towardsLightWorld : light.positionWorld;
      lightWorld.value.set(at[0] ?? 0, at[1] ?? 0, at[2] ?? 0, light.kind === 'directional' ? 0 : 1);
    },
    dispose: () => {
      for (const material of materials) material.dispose();
    },
  };
}
