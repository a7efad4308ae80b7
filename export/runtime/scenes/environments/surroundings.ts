import type { Scene } from 'three';
import type { EnvironmentAsset, EnvironmentLightItem, LightList, NumberView } from '../../../../nodes/kit/runtime.ts';
import { type Backdrop, createBackdrop } from './backdrop.ts';
import type { NeutralEnvironment } from './neutral.ts';
import type { PanoramaStore } from './panorama-store.ts';

/** What lights one scene from all sides: the first environment light that has loaded, else the neutral studio. */
export interface Surroundings {
  /** `lit`: whether anything in the scene takes light from its surroundings. */
  update(lists: readonly LightList[], lit: boolean): void;
  dispose(): void;
}

export interface SurroundingsOptions {
  readonly scene: Scene;
  readonly neutral: NeutralEnvironment;
  readonly panoramas: PanoramaStore;
  /** Brightness of the neutral studio. */
  readonly ambient: NumberView;
}

export function createSurroundings({ scene, neutral, panoramas, ambient }: SurroundingsOptions): Surroundings {
  let backdrop: Backdrop | null = null;

  function showBehind(environment: EnvironmentAsset, { visible, intensity }: EnvironmentLightItem): void {
    if (!visible) {
      backdrop?.hide();
      return;
    }
    backdrop ??= createBackdrop(scene);
    backdrop.show(environment, intensity, scene.environmentRotation);
  }

  return {
    update: (lists, lit) => {
      const light = findEnvironment(lists);
      const environment = light?.environment ?? null;
      if (light === null || environment === null) {
        if (lit) scene.environment = neutral.texture();
        scene.environmentIntensity = ambient.value;
        scene.environmentRotation.set(0, 0, 0);
        backdrop?.hide();
        return;
      }
      scene.environment = panoramas.prefiltered(environment);
      scene.environmentIntensity = light.intensity;
      scene.environmentRotation.set(0, light.rotationRad, 0);
      showBehind(environment, light);
    },
    dispose: () => backdrop?.dispose(),
  };
}

function findEnvironment(lists: readonly LightList[]): EnvironmentLightItem | null {
  for (const list of lists) {
    for (const light of list.items) if (light.kind === 'environment') return light;
  }
  return null;
}
