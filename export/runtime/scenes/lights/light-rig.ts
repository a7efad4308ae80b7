import { type Color, DirectionalLight, PointLight, type Scene, SpotLight, type Texture, Vector3 } from 'three';
import type { DirectionalLightItem, LightItem, LightList, PointLightItem, SpotLightItem } from '../../../../nodes/kit/scene-lists.ts';
import { createVersionWatch } from '../../../../nodes/kit/version-watch.ts';
import type { TranslucentShadowPatch } from '../materials/translucent-shadow-patch.ts';
import type { ShadowMap } from './light-map.ts';
import type { RenderedShadowMaps } from './shadow-maps.ts';

/** The three.js lights of one scene's light lists, except environments: see `scene-environment.ts`. */
export interface LightRig {
  /** Applies changed lists, and this frame's positions and colors. */
  update(lists: readonly LightList[]): void;
  /**
   * Sets or removes the shadow maps of the lights for this frame, and passes translucent shadow maps to `translucentShadows`. Returns how
   * many lights transparent objects do not dim, because the device has too few texture units.
   */
  bindShadows(maps: RenderedShadowMaps | null, translucentShadows: TranslucentShadowPatch, maxTextures: number): number;
  dispose(): void;
}

/** Minimum penumbra of a spot light. Below it, the two cosines between which three.js fades the edge of the cone would be equal. */
export const MIN_PENUMBRA = 1e-3;

// Valid within one call.
const scratchPoint = new Vector3();

/** Number of textures that three.js' largest material reads besides shadow maps. */
const MATERIAL_TEXTURES = 10;

type Textures = (Texture | null)[];

type DirectLight = DirectionalLight | PointLight | SpotLight;

interface RigLight {
  readonly item: LightItem;
  readonly light: DirectLight;
  update(): void;
}

export function createLightRig(scene: Scene): LightRig {
  const watch = createVersionWatch();
  const rig: RigLight[] = [];
  const texturesBy = { directional: [] as Textures, spot: [] as Textures, point: [] as Textures };
  const directionalFarM: number[] = [];

  function clear(): void {
    for (const { light } of rig) {
      scene.remove(light);
      // The shadow maps own the map.
      light.shadow.map = null;
      light.dispose();
    }
    rig.length = 0;
  }

  function add(item: LightItem): void {
    const made = createLight(item);
    if (made === null) return;
    setUp(made.light);
    // Draws of a part of the scene have the same lights.
    made.light.layers.enableAll();
    scene.add(made.light);
    rig.push(made);
  }

  return {
    update: (lists) => {
      if (watch.changed(lists)) {
        clear();
        for (const list of lists) for (const item of list.items) add(item);
      }
      for (let i = 0; i < rig.length; i++) rig[i]?.update();
    },
    bindShadows: (maps, translucentShadows, maxTextures) => {
      for (const list of Object.values(texturesBy)) list.length = 0;
      directionalFarM.length = 0;
      let shadows = 0;
      let dimmed = 0;
      for (const { item, light } of rig) {
        const map = maps?.mapOf(item) ?? null;
        bindShadow(light, map);
        if (map === null) continue;
        shadows++;
        if (map.translucent !== null) dimmed++;
        // three.js visits lights of one kind in this order, those with a shadow first.
        texturesBy[item.kind as keyof typeof texturesBy].push(map.translucent);
        if (item.kind === 'directional') directionalFarM.push(map.farM);
      }
      const fits = 2 * shadows + MATERIAL_TEXTURES <= maxTextures;
      translucentShadows.bind(texturesBy.directional, directionalFarM, texturesBy.spot, texturesBy.point, fits);
      return fits ? 0 : dimmed;
    },
    dispose: clear,
  };
}

function createLight(item: LightItem): RigLight | null {
  switch (item.kind) {
    case 'directional':
      return item.onlyShadows ? null : createDirectional(item);
    case 'point':
      return createPoint(item);
    case 'spot':
      return createSpot(item);
    case 'environment':
    case 'probe':
      return null;
  }
}

/** Creates a directional light. three.js computes its direction from its position and its target, which stays at the origin. */
function createDirectional(item: DirectionalLightItem): RigLight {
  const light = new DirectionalLight();
  return {
    item,
    light,
    update: () => {
      setLinear(light.color, item.radiance);
      light.matrixWorld.setPosition(scratchPoint.fromArray(item.towardsLightWorld));
    },
  };
}

function createPoint(item: PointLightItem): RigLight {
  const light = new PointLight();
  return {
    item,
    light,
    update: () => {
      setLinear(light.color, item.intensityCd);
      light.matrixWorld.setPosition(scratchPoint.fromArray(item.positionWorld));
      light.distance = item.rangeM;
    },
  };
}

function createSpot(item: SpotLightItem): RigLight {
  const light = new SpotLight();
  return {
    item,
    light,
    update: () => {
      setLinear(light.color, item.intensityCd);
      const [x = 0, y = 0, z = 0] = item.positionWorld;
      light.matrixWorld.setPosition(scratchPoint.set(x, y, z));
      const [towardsX = 0, towardsY = 0, towardsZ = 0] = item.towardsLightWorld;
      light.target.matrixWorld.setPosition(scratchPoint.set(x - towardsX, y - towardsY, z - towardsZ));
      light.distance = item.rangeM;
      light.angle = item.halfAngleRad;
      light.penumbra = Math.max(item.penumbra, MIN_PENUMBRA);
    },
  };
}

/** Disables automatic updates of matrices and shadows. */
function setUp(light: DirectLight): void {
  light.matrixAutoUpdate = false;
  light.matrixWorldAutoUpdate = false;
  if (!('isPointLight' in light)) {
    light.target.matrixAutoUpdate = false;
    light.target.matrixWorldAutoUpdate = false;
  }
  light.shadow.autoUpdate = false;
  light.shadow.needsUpdate = false;
}

function bindShadow(light: DirectLight, map: ShadowMap | null): void {
  const { shadow } = light;
  light.castShadow = map !== null;
  shadow.map = map?.target ?? null;
  if (map === null) return;
  shadow.matrix = map.mapFromWorld;
  shadow.mapSize.setScalar(map.target.width);
  // three.js adds its bias to the receiver's depth; here the bias moves the receiver towards the light.
  shadow.bias = -map.bias;
  shadow.normalBias = map.normalBias;
  if ('isPointLight' in light) {
    light.shadow.camera.near = map.nearM;
    light.shadow.camera.far = map.farM;
  }
}

/** Sets a color without conversion: the values are linear sRGB, three.js' working color space. */
function setLinear(color: Color, radiance: Float32Array): void {
  color.r = radiance[0] ?? 0;
  color.g = radiance[1] ?? 0;
  color.b = radiance[2] ?? 0;
}
