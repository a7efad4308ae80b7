import { type ShaderMaterial, Vector4 } from 'three';
import type { DirectLightItem } from '../../../../nodes/kit/scene-lists.ts';
import { createVolumeMaterial } from './volume-material.ts';

/** A light, as its shadow volumes need it. */
export interface VolumeLight {
  /** Place with w 1, or with w 0 the unit vector towards the light; world. */
  readonly lightWorld: { readonly value: Vector4 };
  /** For the backs of volumes and for their fronts, drawn at `renderOrder` and the next. */
  readonly materials: readonly [ShaderMaterial, ShaderMaterial];
  readonly renderOrder: number;
  casts(): boolean;
  /** Takes over the light's place. */
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
