import { type Material, Scene } from 'three';
import type { DrawnScene } from '../../../nodes/kit/runtime.ts';
import type { ObjectItem } from '../../../nodes/kit/scene-lists.ts';
import type { SceneLook } from '../../../nodes/kit/scene-look.ts';
import { createDepthTwin } from './materials/depth-twin.ts';
import type { OcclusionPatch } from './materials/occlusion-patch.ts';
import { patchMaterial, type ShaderPatch, wrapMain } from './materials/shader-patch.ts';
import { createTwinCache, type Twin } from './materials/twins.ts';
import { type Drawable, mapMaterials, programFeatures } from './proxies/drawable.ts';
import type { ProxyPlan } from './proxies/proxy.ts';
import { createProxySet } from './proxies/proxy-set.ts';
import type { SceneRenderer } from './scene-renderer.ts';
import { createViewCamera } from './view-camera.ts';

/** Writes white instead of the depth that `MeshDepthMaterial` writes as color. */
const WHITE: ShaderPatch = {
  key: 'white',
  apply: (shader) => {
    shader.fragmentShader = wrapMain(shader.fragmentShader, { before: '', start: '', end: 'gl_FragColor = vec4( 1.0 );' });
  },
};

export interface MaskSceneOptions {
  readonly renderer: SceneRenderer;
  readonly shows: Extract<SceneLook, { kind: 'mask' }>['shows'];
  readonly occlusion: OcclusionPatch | null;
}

/** Render order of the objects that hide others. Only their depth is drawn, so it must be drawn before the white objects. */
const DEPTH_FIRST = -1;

/**
 * Creates a scene that draws selected objects in white; all other objects only hide them. Depth of hiding objects is drawn a little behind
 * their surface, so that an object does not hide itself.
 */
export function createMaskScene({ renderer, shows, occlusion }: MaskSceneOptions): DrawnScene {
  const scene = new Scene();
  scene.matrixWorldAutoUpdate = false;
  const view = createViewCamera();
  const twins = createTwinCache();
  const proxies = createProxySet(scene, plan);

  function plan(master: Drawable, item: ObjectItem): readonly ProxyPlan[] {
    const features = programFeatures(master);
    if (item.role === 'virtual' && shows(item, master)) {
      const white = mapMaterials(master, (part) => twins.get(part, features, () => createMaskTwin(part, occlusion)));
      return [{ material: white, renderOrder: 0 }];
    }
    const use = item.role === 'phantom' ? 'surface' : 'solid';
    const depth = mapMaterials(master, (part) => twins.get(part, `${features}|${use}`, () => createDepthTwin(part, use)));
    return [{ material: depth, renderOrder: DEPTH_FIRST }];
  }

  return {
    update: (objects) => {
      twins.sync();
      if (proxies.update(objects, false)) twins.sweep();
    },
    draw: (drawView) => {
      view.set(drawView.view);
      occlusion?.bind(drawView);
      renderer.draw(drawView, scene, view.camera);
    },
    dispose: () => {
      proxies.dispose();
      twins.dispose();
    },
  };
}

/** Creates a material that draws the shape of the master in white, faded at a soft border of the room. */
function createMaskTwin(master: Material, occlusion: ShaderPatch | null): Twin {
  const twin = createDepthTwin(master, 'solid');
  const { material } = twin;
  material.colorWrite = true;
  material.polygonOffset = false;
  material.defines = { PREMULTIPLIED_OUTPUT: '' };
  patchMaterial(material, null, occlusion ? [WHITE, occlusion] : [WHITE]);
  return twin;
}
