import { Scene, Sphere } from 'three';
import type { LightItem, LightList, ObjectItem, ObjectList } from '../../../../nodes/kit/scene-lists.ts';
import type { ShadowMaps } from '../../scene-backend.ts';
import { createDepthTwin } from '../materials/depth-twin.ts';
import { castsTranslucentShadow, createTranslucentShadowTwin } from '../materials/translucent-shadow-twin.ts';
import { createTwinCache } from '../materials/twins.ts';
import { boundsInObject, mapMaterials, materialsOf, programFeatures } from '../proxies/drawable.ts';
import type { FlatProxy } from '../proxies/proxy.ts';
import { createProxySet } from '../proxies/proxy-set.ts';
import type { SceneRenderer } from '../scene-renderer.ts';
import { MAX_SHADOWS, mapLimitsOf } from './light-limits.ts';
import { createLightMap, type LightMap, type ShadowMap, shadowOf } from './light-map.ts';

/** The shadow maps of one set of casters, by light. */
export interface RenderedShadowMaps extends ShadowMaps {
  /** The shadow map of a light; null if the light casts no shadow, or comes after the maximum number of lights with shadows. */
  mapOf(light: LightItem): ShadowMap | null;
  /** Makes flat maps keep the last caster, too, from the next update on. */
  keepLast(): void;
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
  const translucentScene = new Scene();
  translucentScene.matrixWorldAutoUpdate = false;
  const translucentTwins = createTwinCache();
  const translucentProxies = createProxySet(translucentScene, (master) => {
    if (!materialsOf(master).some(castsTranslucentShadow)) return [];
    const features = programFeatures(master);
    const material = mapMaterials(master, (part) => translucentTwins.get(part, features, () => createTranslucentShadowTwin(part)));
    return [{ material, renderOrder: 0, shows: castsShadow }];
  });
  /** Number of transparent casters; it may change at run time. */
  let translucentCount = 0;

  function updateTranslucent(rebuilt: boolean): Scene | null {
    const now = countTranslucent(proxies.proxies);
    translucentTwins.sync();
    if (translucentProxies.update(casters, rebuilt || now !== translucentCount)) translucentTwins.sweep();
    translucentCount = now;
    for (let i = 0; i < translucentProxies.proxies.length; i++) if (translucentProxies.proxies[i]?.object.visible) return translucentScene;
    return null;
  }
  let keepsLast = false;
  const limits = mapLimitsOf(renderer.three);
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
      // Excludes empty geometries and invalid vertices.
      if (sphere.radius >= 0) shown.push(sphere.applyMatrix4(proxy.item.worldFromObject));
    }
  }

  function find(light: LightItem): LightMap | null {
    for (const map of maps) if (map.light === light) return map;
    return null;
  }

  function mapFor(light: LightItem): LightMap | null {
    const known = find(light);
    if (known && isCurrent(known)) return known;
    if (known) remove(known);
    const made = createLightMap(light, limits);
    if (made) maps.push(made);
    return made;
  }

  function remove(map: LightMap): void {
    map.dispose();
    maps.splice(maps.indexOf(map), 1);
  }

  /** Keeps the maps of the first lights that cast a shadow and disposes those of other lights. */
  function dropUnused(): void {
    for (let i = maps.length - 1; i >= 0; i--) {
      const map = maps[i];
      if (map && !(isCurrent(map) && rankOf(map.light) < MAX_SHADOWS)) remove(map);
    }
  }

  /** Number of lights with shadows before this one; infinity if it is not in the lists. */
  function rankOf(light: LightItem): number {
    let rank = 0;
    for (const list of lights) {
      for (const item of list.items) {
        if (item === light) return rank;
        if (shadowOf(item) !== null) rank++;
      }
    }
    return Number.POSITIVE_INFINITY;
  }

  return {
    mapOf: (light) => find(light)?.map ?? null,
    keepLast: () => {
      keepsLast = true;
    },
    update: () => {
      dropUnused();
      twins.sync();
      const rebuilt = proxies.update(casters, false);
      if (rebuilt) twins.sweep();
      updateBounds(rebuilt);
      const translucentShadows = updateTranslucent(rebuilt);
      let count = 0;
      for (const list of lights) {
        for (const light of list.items) {
          if (shadowOf(light) !== null && count++ < MAX_SHADOWS)
            mapFor(light)?.render(renderer, scene, translucentShadows, shown, keepsLast);
        }
      }
    },
    dispose: () => {
      proxies.dispose();
      translucentProxies.dispose();
      twins.dispose();
      translucentTwins.dispose();
      while (maps[0]) remove(maps[0]);
    },
  };
}

function countTranslucent(proxies: readonly FlatProxy[]): number {
  let count = 0;
  for (let i = 0; i < proxies.length; i++) {
    const material = proxies[i]?.master.material;
    if (Array.isArray(material)) for (const part of material) count += castsTranslucentShadow(part) ? 1 : 0;
    else if (material && castsTranslucentShadow(material)) count++;
  }
  return count;
}

/** Whether the map still matches the settings of its light. */
function isCurrent({ light, shadow, askedSizePx }: LightMap): boolean {
  const wanted = shadowOf(light);
  return wanted === shadow && wanted.mapSizePx === askedSizePx;
}
