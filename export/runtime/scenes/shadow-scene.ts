import { type Material, Mesh, PlaneGeometry, Scene } from 'three';
import type { DrawnScene } from '../../../nodes/kit/runtime.ts';
import type { ObjectItem } from '../../../nodes/kit/scene-lists.ts';
import type { LightLimits } from './lights/light-limits.ts';
import { createDepthTwin } from './materials/depth-twin.ts';
import type { OcclusionPatch } from './materials/occlusion-patch.ts';
import type { RoomSurface } from './materials/room-surface.ts';
import { patchMaterial, type ShaderPatch, wrapMain } from './materials/shader-patch.ts';
import { catchesShadows, type ShadowCatcher } from './materials/shadow-catcher.ts';
import { createTwinCache, type Twin } from './materials/twins.ts';
import { type Drawable, mapMaterials, programFeatures } from './proxies/drawable.ts';
import type { ProxyPlan } from './proxies/proxy.ts';
import { createProxySet } from './proxies/proxy-set.ts';
import type { SceneRenderer } from './scene-renderer.ts';
import { createViewCamera } from './view-camera.ts';

export interface ShadowSceneOptions {
  readonly renderer: SceneRenderer;
  readonly catcher: ShadowCatcher;
  /**
   * Selects the objects that are drawn. If it selects only phantoms, virtual objects hide nothing here; the layer above covers the shadows
   * behind them.
   */
  readonly catches: (item: ObjectItem) => boolean;
  readonly occlusion: OcclusionPatch | null;
  /** Surfaces of room depth, which catch shadows where nothing else does and hide what is behind them. */
  readonly surface: RoomSurface | null;
  readonly watchLimits: LightLimits;
}

/** Makes the depth pass and the shadow pass compute exactly the same positions. */
const INVARIANT: ShaderPatch = {
  key: 'invariant position',
  apply: (shader) => {
    shader.vertexShader = wrapMain(shader.vertexShader, { before: 'invariant gl_Position;', start: '', end: '' });
  },
};

/**
 * Moves the depth that a material draws so little behind its surface that nothing behind passes the depth test. An offset by slope would
 * show hidden surfaces along edges, in full shadow.
 */
function setSameDepth(material: Material): void {
  material.polygonOffsetFactor = 0;
  material.polygonOffsetUnits = 2;
}

const receivesShadow = (item: ObjectItem): boolean => item.receivesShadow;

/** Creates a scene that draws objects as shadow catchers. */
export function createShadowScene({ renderer, catcher, catches, occlusion, surface, watchLimits }: ShadowSceneOptions): DrawnScene {
  const scene = new Scene();
  scene.matrixWorldAutoUpdate = false;
  const view = createViewCamera();
  const twins = createTwinCache();
  const proxies = createProxySet(scene, plan);

  const room = surface ? createRoomMesh(scene, catcher, surface) : null;

  function createDepth(master: Material, use: 'surface' | 'solid'): Twin {
    const twin = createDepthTwin(master, use);
    setSameDepth(twin.material);
    patchMaterial(twin.material, null, surface ? [INVARIANT, surface.clip] : [INVARIANT]);
    return twin;
  }

  function plan(master: Drawable, item: ObjectItem): readonly ProxyPlan[] {
    if (!catches(item)) return [];
    const features = programFeatures(master);
    const use = item.role === 'phantom' ? 'surface' : 'solid';
    const depth = mapMaterials(master, (part) => twins.get(part, `${features}|${use}`, () => createDepth(part, use)));
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
      const known = surface?.bind(drawView) ?? false;
      if (room) room.mesh.visible = known;
      renderer.draw(drawView, scene, view.camera);
    },
    dispose: () => {
      proxies.dispose();
      room?.dispose();
      catcher.dispose();
      twins.dispose();
    },
  };
}

/** Render order of the room: after the depth of all objects that catch shadows. */
const ROOM_LAST = 1;

/** Adds a quad over the whole view that draws shadows on the room; null if the shadow method does not support room depth. */
function createRoomMesh(scene: Scene, catcher: ShadowCatcher, surface: RoomSurface): { readonly mesh: Mesh; dispose(): void } | null {
  const material = catcher.createRoomMaterial(surface.uniforms);
  if (!material) return null;
  const mesh = new Mesh(new PlaneGeometry(2, 2), material);
  mesh.frustumCulled = false;
  mesh.matrixAutoUpdate = false;
  mesh.matrixWorldAutoUpdate = false;
  mesh.renderOrder = ROOM_LAST;
  scene.add(mesh);
  return {
    mesh,
    dispose: () => {
      scene.remove(mesh);
      mesh.geometry.dispose();
      material.dispose();
    },
  };
}
