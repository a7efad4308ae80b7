import { type IUniform, type Texture, Vector2, Vector4 } from 'three';
import type { NumberView, VectorView } from '../../../../nodes/kit/value-views.ts';
import type { ShaderPatch } from '../materials/shader-patch.ts';
import { createCatcherMaterial, followSides, type ShadowCatcher } from '../materials/shadow-catcher.ts';
import { KNOWN_SHADOW_FRAGMENT } from '../materials/shadow-catcher-shader.ts';
import { type BlockedTextureOptions, createBlockedTexture } from './blocked-texture.ts';

export interface VolumeCatcherOptions extends BlockedTextureOptions {
  readonly strength: NumberView;
  readonly color: VectorView;
  readonly occlusion: readonly ShaderPatch[];
}

/** Creates a catcher that finds shadows by shadow volumes, whose edges are sharp and follow the triangles. */
export function createVolumeCatcher(options: VolumeCatcherOptions): ShadowCatcher {
  const { strength, color, occlusion } = options;
  const blocked = createBlockedTexture(options);
  const blockedPart: IUniform<Texture | null> = { value: null };
  const uniforms = {
    strength: { value: 0 },
    shadowColor: { value: new Vector4() },
    blockedPart,
    viewportStart: { value: new Vector2() },
  };
  return {
    createTwin: (master) => {
      const material = createCatcherMaterial(KNOWN_SHADOW_FRAGMENT, uniforms, occlusion);
      const sync = (): void => followSides(material, master);
      sync();
      return { material, sync, dispose: () => material.dispose() };
    },
    update: (receivers, lights) => {
      uniforms.strength.value = strength.value;
      uniforms.shadowColor.value.fromArray(color.value);
      blocked.update(receivers, lights);
    },
    beforeDraw: (view) => {
      blockedPart.value = blocked.draw(view);
      uniforms.viewportStart.value.set(view.viewport.x, view.viewport.y);
    },
    createRoomMaterial: () => null,
    dispose: blocked.dispose,
  };
}
