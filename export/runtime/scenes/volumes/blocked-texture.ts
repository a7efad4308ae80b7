import {
  CustomBlending,
  KeepStencilOp,
  LessEqualDepth,
  type Material,
  NearestFilter,
  NotEqualStencilFunc,
  OneFactor,
  RedFormat,
  Scene,
  ShaderMaterial,
  type Texture,
  WebGLRenderTarget,
  ZeroStencilOp,
} from 'three';
import type { DrawView } from '../../../../nodes/kit/runtime.ts';
import type { DirectLightItem, LightItem, LightList, ObjectItem, ObjectList } from '../../../../nodes/kit/scene-lists.ts';
import type { ViewFrame } from '../../../../nodes/kit/session.ts';
import { createVersionWatch } from '../../../../nodes/kit/version-watch.ts';
import { isDirectLight } from '../lights/is-direct-light.ts';
import { createDepthTwin } from '../materials/depth-twin.ts';
import { createLightUniforms, setLight, setLightCount } from '../materials/light-uniforms.ts';
import { catchesShadows, followSides } from '../materials/shadow-catcher.ts';
import { blockedFragment, CATCHER_VERTEX } from '../materials/shadow-catcher-shader.ts';
import { createTwinCache, type Twin } from '../materials/twins.ts';
import { type Drawable, mapMaterials, programFeatures } from '../proxies/drawable.ts';
import type { ProxyPlan } from '../proxies/proxy.ts';
import { createProxySet } from '../proxies/proxy-set.ts';
import type { SceneRenderer } from '../scene-renderer.ts';
import { createViewCamera, type ViewCamera } from '../view-camera.ts';
import { createVolumeLight, type VolumeLight } from './volume-light.ts';
import { createVolumeSet, type VolumeLimits } from './volume-set.ts';

/**
 * Offset in the projection matrix that keeps points at infinity in front of the far plane, also in 32-bit floats (Lengyel 2007, “Projection
 * matrix tricks”).
 */
const EPSILON = 2 ** -20;

/** A texture with the blocked fraction of the light per pixel of a view, computed by shadow volumes. */
export interface BlockedTexture {
  /** Applies changed lists and this frame's matrices. */
  update(receivers: readonly ObjectList[], lights: readonly LightList[]): void;
  /**
   * Draws the texture for a view. Its red channel is 1 where all light is blocked. The bottom left pixel of the viewport is the first
   * texel; the texture may be larger than the viewport.
   */
  draw(view: DrawView): Texture;
  dispose(): void;
}

export interface BlockedTextureOptions {
  readonly renderer: SceneRenderer;
  readonly casters: readonly ObjectList[];
  /** Selects the objects that hide others. Those of them that receive shadows also catch them. */
  readonly catches: (item: ObjectItem) => boolean;
  readonly limits: VolumeLimits;
}

/** Samples for antialiased edges of shadows, as for edges of objects. */
const SAMPLES = 4;

/**
 * Number of render orders per light: back faces of volumes, front faces, then the light's contribution at pixels marked in the stencil. All
 * follow the depth of the receivers.
 */
const STEPS = 3;

/**
 * Creates a `BlockedTexture`. It is drawn in a single render call of three.js, because three.js' multisampled targets do not keep depth
 * between calls. For each light, volumes mark pixels in the stencil; receivers add the light's fraction of all light there, 0 to 1, and
 * reset the marks. The target has its own stencil, because WebXR's framebuffers may have none.
 */
export function createBlockedTexture({ renderer, casters, catches, limits }: BlockedTextureOptions): BlockedTexture {
  const scene = new Scene();
  scene.matrixWorldAutoUpdate = false;
  const camera = createInfiniteCamera();
  const target = new WebGLRenderTarget(1, 1, {
    format: RedFormat,
    minFilter: NearestFilter,
    magFilter: NearestFilter,
    generateMipmaps: false,
    stencilBuffer: true,
    samples: SAMPLES,
  });
  const twins = createTwinCache();
  const receivers = createProxySet(scene, plan);
  const volumes = createVolumeSet(scene, casters, limits);
  const uniforms = createLightUniforms();
  const watch = createVersionWatch();
  let directLights: readonly DirectLightItem[] = [];
  let volumeLights: readonly VolumeLight[] = [];

  function plan(master: Drawable, item: ObjectItem): readonly ProxyPlan[] {
    if (!catches(item)) return [];
    const features = programFeatures(master);
    const plans: ProxyPlan[] = [
      {
        material: mapMaterials(master, (part) => twins.get(part, `${features}|${item.role}`, () => createExactDepth(part, item.role))),
        renderOrder: 0,
      },
    ];
    if (!catchesShadows(master, item)) return plans;
    directLights.forEach((light, i) => {
      const variant = `${features}|${directLights.length}|${i}`;
      plans.push({
        material: mapMaterials(master, (part) => twins.get(part, variant, () => createBlockedTwin(part, i))),
        renderOrder: STEPS * (i + 1),
        shows: ({ receivesShadow }) => receivesShadow && light.shadow !== null,
      });
    });
    return plans;
  }

  function createBlockedTwin(master: Material, light: number): Twin {
    const material = new ShaderMaterial({
      name: 'blocked light',
      vertexShader: CATCHER_VERTEX,
      fragmentShader: blockedFragment(directLights.length, light),
    });
    Object.assign(material.uniforms, uniforms);
    material.transparent = true;
    material.depthWrite = false;
    material.depthFunc = LessEqualDepth;
    // The depth was drawn by another shader and may differ in its last digits. The offset does not depend on the slope, because surfaces
    // seen edge-on would otherwise appear in front of others.
    material.polygonOffset = true;
    material.polygonOffsetFactor = 0;
    material.polygonOffsetUnits = -4;
    material.blending = CustomBlending;
    material.blendSrc = OneFactor;
    material.blendDst = OneFactor;
    material.stencilWrite = true;
    material.stencilFunc = NotEqualStencilFunc;
    material.stencilRef = 0;
    material.stencilFail = KeepStencilOp;
    material.stencilZFail = KeepStencilOp;
    material.stencilZPass = ZeroStencilOp;
    const sync = (): void => followSides(material, master);
    sync();
    return { material, sync, dispose: () => material.dispose() };
  }

  function takeOver(lists: readonly LightList[]): void {
    for (const light of volumeLights) light.dispose();
    directLights = lists.flatMap(({ items }) => items.filter(isSharp));
    volumeLights = directLights.map((light, i) => createVolumeLight(light, STEPS * i + 1));
    setLightCount(uniforms, directLights.length);
  }

  return {
    update: (lists, lightLists) => {
      const relit = watch.changed(lightLists);
      if (relit) takeOver(lightLists);
      for (let i = 0; i < directLights.length; i++) {
        const light = directLights[i];
        if (light) setLight(uniforms, i, light);
        volumeLights[i]?.update();
      }
      twins.sync();
      if (receivers.update(lists, relit)) twins.sweep();
      volumes.update(volumeLights, relit);
    },
    draw: ({ view, viewport: { widthPx, heightPx } }) => {
      // Views of different sizes share the largest target.
      if (widthPx > target.width || heightPx > target.height)
        target.setSize(Math.max(widthPx, target.width), Math.max(heightPx, target.height));
      camera.set(view);
      renderer.drawCorner(target, widthPx, heightPx, scene, camera.camera);
      return target.texture;
    },
    dispose: () => {
      receivers.dispose();
      volumes.dispose();
      for (const light of volumeLights) light.dispose();
      twins.dispose();
      target.dispose();
    },
  };
}

/** Creates a material that draws depth exactly at the surface, where volumes start, without the usual offset. */
function createExactDepth(master: Material, role: ObjectItem['role']): Twin {
  const twin = createDepthTwin(master, role === 'phantom' ? 'surface' : 'solid');
  twin.material.polygonOffset = false;
  return twin;
}

/**
 * Whether a light can cast shadows by volumes, which have sharp edges. Lights without a position or direction are excluded, and directional
 * lights that stand for the rest of a panorama's light (`onlyShadows`), whose shadow is soft.
 */
function isSharp(light: LightItem): light is DirectLightItem {
  return isDirectLight(light) && !(light.kind === 'directional' && light.onlyShadows);
}

/** Creates a camera with an infinite far plane, because shadow volumes are infinite and must not be clipped. */
function createInfiniteCamera(): ViewCamera {
  const { camera, set } = createViewCamera();
  return {
    camera,
    set: (view: ViewFrame) => {
      set(view);
      const { elements } = camera.projectionMatrix;
      const nearM = (elements[14] ?? 0) / ((elements[10] ?? 0) - 1);
      elements[10] = EPSILON - 1;
      elements[14] = (EPSILON - 2) * nearM;
      camera.projectionMatrixInverse.copy(camera.projectionMatrix).invert();
    },
  };
}
