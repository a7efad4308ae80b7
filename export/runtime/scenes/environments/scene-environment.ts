import type { Scene } from 'three';
import type { EnvironmentAsset } from '../../../../nodes/kit/assets.ts';
import type { EnvironmentLightItem, LightList, ProbeLightItem } from '../../../../nodes/kit/scene-lists.ts';
import type { NumberView } from '../../../../nodes/kit/value-views.ts';
import type { SceneRenderer } from '../scene-renderer.ts';
import { type Backdrop, createBackdrop } from './backdrop.ts';
import type { NeutralEnvironment } from './neutral.ts';
import type { PanoramaStore } from './panorama-store.ts';
import { createProbeEnvironment, type ProbeEnvironment } from './probe-environment.ts';

/** Environment that lights one scene: that of its first environment light (if loaded) or light estimate; otherwise the neutral studio. */
export interface SceneEnvironment {
  /** Applies the current lights. `lit` says whether the environment lights any object in the scene. */
  update(lists: readonly LightList[], lit: boolean): void;
  dispose(): void;
}

export interface SceneEnvironmentOptions {
  readonly renderer: SceneRenderer;
  readonly scene: Scene;
  readonly neutral: NeutralEnvironment;
  readonly panoramas: PanoramaStore;
  /** Brightness of the neutral studio. */
  readonly ambient: NumberView;
}

export function createSceneEnvironment({ renderer, scene, neutral, panoramas, ambient }: SceneEnvironmentOptions): SceneEnvironment {
  let backdrop: Backdrop | null = null;
  let probe: ProbeEnvironment | null = null;

  function showBehind(environment: EnvironmentAsset, { visible, intensity }: EnvironmentLightItem): void {
    if (!visible) {
      backdrop?.hide();
      return;
    }
    backdrop ??= createBackdrop(scene);
    backdrop.show(environment, intensity, scene.environmentRotation);
  }

  function lightByNeutral(lit: boolean): void {
    if (lit) scene.environment = neutral.texture();
    scene.environmentIntensity = ambient.value;
    scene.environmentRotation.set(0, 0, 0);
    backdrop?.hide();
  }

  function lightByProbe(light: ProbeLightItem, lit: boolean): void {
    if (lit) {
      probe ??= createProbeEnvironment(renderer);
      probe.update(light);
      scene.environment = probe.texture;
    }
    scene.environmentIntensity = light.intensity;
    scene.environmentRotation.set(0, 0, 0);
    backdrop?.hide();
  }

  return {
    update: (lists, lit) => {
      const light = findSurrounding(lists);
      const environment = light?.kind === 'environment' ? light.environment : null;
      if (light?.kind === 'probe') {
        lightByProbe(light, lit);
      } else if (light === null || environment === null) {
        lightByNeutral(lit);
      } else {
        scene.environment = panoramas.prefiltered(environment);
        scene.environmentIntensity = light.intensity;
        scene.environmentRotation.set(0, light.rotationRad, 0);
        showBehind(environment, light);
      }
    },
    dispose: () => {
      backdrop?.dispose();
      probe?.dispose();
    },
  };
}

function findSurrounding(lists: readonly LightList[]): EnvironmentLightItem | ProbeLightItem | null {
  for (const list of lists) {
    for (const light of list.items) if (light.kind === 'environment' || light.kind === 'probe') return light;
  }
  return null;
}
