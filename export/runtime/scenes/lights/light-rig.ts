import { type Color, DirectionalLight, type Scene, Vector3 } from 'three';
import type { LightItem, LightList } from '../../../../nodes/kit/runtime.ts';
import { createVersionWatch } from '../../../../nodes/kit/version-watch.ts';
import type { RenderedShadowMaps } from './shadow-maps.ts';

/** three's lights for the light lists of one scene. */
export interface LightRig {
  /** Takes over changed lists and this frame's directions and colours. */
  update(lists: readonly LightList[]): void;
  /** Hands three the maps rendered this frame, or takes them away. */
  bindShadows(maps: RenderedShadowMaps | null): void;
  dispose(): void;
}

// Read by the call that fills it, before anything else can.
const scratchDirection = new Vector3();

interface RigLight {
  readonly item: LightItem;
  readonly light: DirectionalLight;
}

export function createLightRig(scene: Scene): LightRig {
  const watch = createVersionWatch();
  const rig: RigLight[] = [];

  function clear(): void {
    for (const { light } of rig) {
      scene.remove(light);
      // The map belongs to the shadow maps.
      light.shadow.map = null;
      light.dispose();
    }
    rig.length = 0;
  }

  return {
    update: (lists) => {
      if (watch.changed(lists)) {
        clear();
        for (const list of lists) for (const item of list.items) rig.push({ item, light: createLight(scene) });
      }
      for (const { item, light } of rig) {
        setLinear(light.color, item.radiance);
        light.matrixWorld.setPosition(scratchDirection.fromArray(item.towardsLightWorld));
      }
    },
    bindShadows: (maps) => {
      for (const { item, light } of rig) bindShadow(light, item, maps);
    },
    dispose: clear,
  };
}

/** three takes the direction from the light's place to its target's, which stays at the origin. */
function createLight(scene: Scene): DirectionalLight {
  const light = new DirectionalLight();
  light.matrixAutoUpdate = false;
  light.matrixWorldAutoUpdate = false;
  light.target.matrixAutoUpdate = false;
  light.target.matrixWorldAutoUpdate = false;
  light.shadow.autoUpdate = false;
  light.shadow.needsUpdate = false;
  scene.add(light);
  return light;
}

function bindShadow(light: DirectionalLight, item: LightItem, maps: RenderedShadowMaps | null): void {
  const map = maps?.mapOf(item) ?? null;
  light.castShadow = map !== null;
  light.shadow.map = map?.target ?? null;
  if (map === null) return;
  light.shadow.matrix = map.mapFromWorld;
  light.shadow.mapSize.setScalar(map.shadow.mapSizePx);
  // three adds its bias to the receiver's depth; ours pulls the receiver towards the light.
  light.shadow.bias = -map.shadow.bias;
  light.shadow.normalBias = map.shadow.normalBiasM;
}

/** Without conversion: the list holds linear-sRGB, which is three's working space. */
function setLinear(color: Color, radiance: Float32Array): void {
  color.r = radiance[0] ?? 0;
  color.g = radiance[1] ?? 0;
  color.b = radiance[2] ?? 0;
}
