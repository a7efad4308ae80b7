import {
  Camera,
  DepthTexture,
  LessEqualCompare,
  LinearFilter,
  type Matrix4,
  NearestFilter,
  RedFormat,
  Scene,
  Sphere,
  UnsignedIntType,
  WebGLRenderTarget,
} from 'three';
import type { LightItem, LightList, LightShadow, ObjectItem, ObjectList } from '../../../../nodes/kit/runtime.ts';
import type { ShadowMaps } from '../../scene-backend.ts';
import { createDepthTwin } from '../materials/depth-twin.ts';
import { createTwinCache } from '../materials/twins.ts';
import { boundsInObject, mapMaterials, programFeatures } from '../proxies/drawable.ts';
import { createProxySet } from '../proxies/proxy-set.ts';
import type { SceneRenderer } from '../scene-renderer.ts';
import { createShadowFit, fitShadow, type ShadowFit } from './shadow-fit.ts';

/** One light's depth map of this frame. */
export interface ShadowMap {
  readonly shadow: LightShadow;
  /** Its depth texture compares: `texture(sampler2DShadow, vec3(uv, depth))` is 1 where lit. */
  readonly target: WebGLRenderTarget;
  readonly mapFromWorld: Matrix4;
}

/** The maps of one set of casters, by light. */
export interface RenderedShadowMaps extends ShadowMaps {
  /** Null where the light casts none. */
  mapOf(light: LightItem): ShadowMap | null;
}

interface LightMap extends ShadowMap {
  readonly light: LightItem;
  readonly fit: ShadowFit;
}

const castsShadow = (item: ObjectItem): boolean => item.castsShadow;

export function createShadowMaps(
  renderer: SceneRenderer,
  casters: readonly ObjectList[],
  lights: readonly LightList[],
): RenderedShadowMaps {
  const scene = new Scene();
  scene.matrixWorldAutoUpdate = false;
  const twins = createTwinCache();
  const proxies = createProxySet(scene, (master) => {
    const features = programFeatures(master);
    const material = mapMaterials(master, (part) => twins.get(part, features, () => createDepthTwin(part, 'shadow')));
    return [{ material, renderOrder: 0, shows: castsShadow }];
  });
  const camera = createLightCamera();
  const maps: LightMap[] = [];
  const bounds: Sphere[] = [];
  const shown: Sphere[] = [];

  function updateBounds(rebuilt: boolean): void {
    if (rebuilt) {
      bounds.length = 0;
      for (let i = 0; i < proxies.proxies.length; i++) bounds.push(new Sphere());
    }
    shown.length = 0;
    for (let i = 0; i < bounds.length; i++) {
      const proxy = proxies.proxies[i];
      const sphere = bounds[i];
      if (!sphere || !proxy?.object.visible) continue;
      boundsInObject(proxy.master, sphere);
      // Neither empty nor of broken vertices.
      if (sphere.radius >= 0) shown.push(sphere.applyMatrix4(proxy.item.worldFromObject));
    }
  }

  function find(light: LightItem): LightMap | null {
    for (const map of maps) if (map.light === light) return map;
    return null;
  }

  function mapFor(light: LightItem, shadow: LightShadow): LightMap {
    const known = find(light);
    if (known?.shadow === shadow && known.target.width === shadow.mapSizePx) return known;
    if (known) remove(known);
    const fit = createShadowFit();
    const map = { light, shadow, target: createMapTarget(shadow.mapSizePx), mapFromWorld: fit.mapFromWorld, fit };
    maps.push(map);
    return map;
  }

  function remove(map: LightMap): void {
    map.target.dispose();
    maps.splice(maps.indexOf(map), 1);
  }

  function render(light: LightItem, wanted: LightShadow): void {
    const { target, fit, shadow } = mapFor(light, wanted);
    fitShadow(fit, light.towardsLightWorld, shown, shadow.areaM, shadow.mapSizePx);
    camera.projectionMatrix.copy(fit.clipFromLight);
    camera.matrixWorld.copy(fit.worldFromLight);
    camera.matrixWorldInverse.copy(fit.lightFromWorld);
    renderer.drawDepth(target, scene, camera);
  }

  function isLit(light: LightItem): boolean {
    for (const list of lights) if (list.items.includes(light)) return true;
    return false;
  }

  /** Lights that are gone or cast no shadow any more. */
  function dropUnused(): void {
    for (let i = maps.length - 1; i >= 0; i--) {
      const map = maps[i];
      if (map && !(map.light.shadow === map.shadow && isLit(map.light))) remove(map);
    }
  }

  return {
    mapOf: find,
    update: () => {
      dropUnused();
      twins.sync();
      const rebuilt = proxies.update(casters, false);
      if (rebuilt) twins.sweep();
      updateBounds(rebuilt);
      for (const list of lights) {
        for (const light of list.items) if (light.shadow !== null) render(light, light.shadow);
      }
    },
    dispose: () => {
      proxies.dispose();
      twins.dispose();
      while (maps[0]) remove(maps[0]);
    },
  };
}

function createLightCamera(): Camera {
  const camera = new Camera();
  camera.matrixAutoUpdate = false;
  camera.matrixWorldAutoUpdate = false;
  return camera;
}

/** 24 bits of depth that compare and filter in hardware; a colour buffer is of no use, but three insists on one. */
function createMapTarget(sizePx: number): WebGLRenderTarget {
  const depthTexture = new DepthTexture(sizePx, sizePx, UnsignedIntType);
  depthTexture.compareFunction = LessEqualCompare;
  depthTexture.minFilter = LinearFilter;
  depthTexture.magFilter = LinearFilter;
  return new WebGLRenderTarget(sizePx, sizePx, {
    depthTexture,
    format: RedFormat,
    minFilter: NearestFilter,
    magFilter: NearestFilter,
    generateMipmaps: false,
  });
}
