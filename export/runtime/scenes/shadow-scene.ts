import { Scene } from 'three';
import type { DrawnScene, ObjectItem } from '../../../nodes/kit/runtime.ts';
import type { LightLimits } from './lights/light-limits.ts';
import { createDepthTwin } from './materials/depth-twin.ts';
import type { OcclusionPatch } from './materials/occlusion-patch.ts';
import { catchesShadows, type ShadowCatcher } from './materials/shadow-catcher.ts';
import { createTwinCache } from './materials/twins.ts';
import { type Drawable, mapMaterials, programFeatures } from './proxies/drawable.ts';
import type { ProxyPlan } from './proxies/proxy.ts';
import { createProxySet } from './proxies/proxy-set.ts';
import type { SceneRenderer } from './scene-renderer.ts';
import { createViewCamera } from './view-camera.ts';

export interface ShadowSceneOptions {
  readonly renderer: SceneRenderer;
  readonly catcher: ShadowCatcher;
  /** What takes part. Where it is phantoms alone, virtual objects hide nothing: what they stand before is covered by the layer above. */
  readonly catches: (item: ObjectItem) => boolean;
  readonly occlusion: OcclusionPatch | null;
  readonly watchLimits: LightLimits;
}

const receivesShadow = (item: ObjectItem): boolean => item.receivesShadow;

/** Objects as shadow catchers. */
export function createShadowScene({ renderer, catcher, catches, occlusion, watchLimits }: ShadowSceneOptions): DrawnScene {
  const scene = new Scene();
  scene.matrixWorldAutoUpdate = false;
  const view = createViewCamera();
  const twins = createTwinCache();
  const proxies = createProxySet(scene, plan);

  function plan(master: Drawable, item: ObjectItem): readonly ProxyPlan[] {
    if (!catches(item)) return [];
    const features = programFeatures(master);
    const use = item.role === 'phantom' ? 'surface' : 'solid';
    const depth = mapMaterials(master, (part) => twins.get(part, `${features}|${use}`, () => createDepthTwin(part, use)));
    if (!catchesShadows(master, item)) return [{ material: depth, renderOrder: 0 }];
    const shadow = mapMaterials(master, (part) => twins.get(part, features, () => catcher.createTwin(part)));
    return [
      { material: depth, renderOrder: 0 },
      { material: shadow, renderOrder: 0, shows: receivesShadow },
    ];
  }

  return {
    update: (objects, lights) => {
      watchLimits(lights);
      catcher.update(objects, lights);
      twins.sync();
      if (proxies.update(objects, false)) twins.sweep();
    },
    draw: (drawView) => {
      catcher.beforeDraw(drawView);
      view.set(drawView.view);
      occlusion?.bind(drawView);
      renderer.draw(drawView, scene, view.camera);
    },
    dispose: () => {
      proxies.dispose();
      catcher.dispose();
      twins.dispose();
    },
  };
}
