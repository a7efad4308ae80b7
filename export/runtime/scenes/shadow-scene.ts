import { Scene } from 'three';
import type { DrawnScene, LightList, NumberView, ObjectItem, VectorView } from '../../../nodes/kit/runtime.ts';
import type { LightLimits } from './lights/light-limits.ts';
import type { RenderedShadowMaps } from './lights/shadow-maps.ts';
import { createDepthTwin } from './materials/depth-twin.ts';
import type { OcclusionPatch } from './materials/occlusion-patch.ts';
import { createShadowCatcher } from './materials/shadow-catcher.ts';
import { createTwinCache } from './materials/twins.ts';
import { type Drawable, mapMaterials, programFeatures } from './proxies/drawable.ts';
import type { ProxyPlan } from './proxies/proxy.ts';
import { createProxySet } from './proxies/proxy-set.ts';
import type { SceneRenderer } from './scene-renderer.ts';
import { createViewCamera } from './view-camera.ts';

export interface ShadowSceneOptions {
  readonly renderer: SceneRenderer;
  readonly strength: NumberView;
  readonly color: VectorView;
  readonly shadowMaps: RenderedShadowMaps | null;
  readonly occlusion: OcclusionPatch | null;
  readonly watchLimits: LightLimits;
}

const receivesShadow = (item: ObjectItem): boolean => item.receivesShadow;

/**
 * Phantoms as shadow catchers. Virtual objects are not drawn, and hide nothing: the shadow layer lies under theirs, so what they
 * stand before is covered there.
 */
export function createShadowScene(options: ShadowSceneOptions): DrawnScene {
  const { renderer, strength, color, shadowMaps, occlusion, watchLimits } = options;
  const scene = new Scene();
  scene.matrixWorldAutoUpdate = false;
  const view = createViewCamera();
  const twins = createTwinCache();
  const catcher = createShadowCatcher(strength, color, occlusion);
  const proxies = createProxySet(scene, plan);
  let lights: readonly LightList[] = [];

  function plan(master: Drawable, item: ObjectItem): readonly ProxyPlan[] {
    if (item.role !== 'phantom') return [];
    const features = programFeatures(master);
    const depth = mapMaterials(master, (part) => twins.get(part, `${features}|depth`, () => createDepthTwin(part, 'surface')));
    const shadow = mapMaterials(master, (part) => twins.get(part, features, () => catcher.createTwin(part)));
    return [
      { material: depth, renderOrder: 0 },
      { material: shadow, renderOrder: 0, shows: receivesShadow },
    ];
  }

  return {
    update: (objects, lightLists) => {
      lights = lightLists;
      watchLimits(lightLists);
      twins.sync();
      if (proxies.update(objects, false)) twins.sweep();
    },
    draw: (drawView) => {
      view.set(drawView.view);
      catcher.update(lights, shadowMaps);
      occlusion?.bind(drawView);
      renderer.draw(drawView, scene, view.camera);
    },
    dispose: () => {
      proxies.dispose();
      twins.dispose();
    },
  };
}
