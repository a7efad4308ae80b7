import {
  Camera,
  CubeDepthTexture,
  DepthTexture,
  FloatType,
  LessEqualCompare,
  LinearFilter,
  Matrix4,
  NearestFilter,
  RedFormat,
  type Scene,
  type Sphere,
  type Texture,
  UnsignedIntType,
  Vector2,
  WebGLCubeRenderTarget,
  WebGLRenderTarget,
} from 'three';
import type { LightShadow, LocalLightShadow, ShadowFilter } from '../../../../nodes/kit/light-shadow.ts';
import type { DirectionalLightItem, LightItem, PointLightItem, SpotLightItem } from '../../../../nodes/kit/scene-lists.ts';
import type { SceneRenderer } from '../scene-renderer.ts';
import { isDirectLight } from './is-direct-light.ts';
import { aimCone, aimFace, createLocalShadowFit, FACE_COUNT, fitReach, type LocalShadowFit } from './local-shadow-fit.ts';
import { createMoments } from './moments.ts';
import { createShadowFit, fitShadow, type ShadowFit } from './shadow-fit.ts';
import { createTranslucentShadow, TRANSLUCENT_SHADOW, type TranslucentShadow } from './translucent-shadow.ts';

/** The shadow map of one light in this frame: depth, and what filters and receivers need. */
export interface ShadowMap {
  /**
   * `flat`: `target` has one depth texture; `mapFromWorld` gives homogeneous UV and depth. `cube`: it has six faces around the light;
   * `mapFromWorld` gives the vector from the light. Samplers of both compare depths and return 1 where lit.
   */
  readonly kind: 'flat' | 'cube';
  readonly target: WebGLRenderTarget;
  readonly mapFromWorld: Matrix4;
  /** Offset of receivers towards the light, in units of normalized depth. */
  readonly bias: number;
  /** Offset of receivers along their normal, in meters; for spot and point lights, per meter of distance. */
  readonly normalBias: number;
  readonly filter: ShadowFilter;
  /** For the filter `pcss`: a texture with 1 minus the depth in the red channel, unfiltered. Null for other filters. */
  readonly depths: Texture | null;
  /** For the filter `vsm`: blurred moments of the depth, see `moments.ts`. Null for other filters. */
  readonly moments: Texture | null;
  /**
   * The translucent shadow map: the fraction of light that passes transparent casters in the red channel, and the distance of the nearest
   * caster in alpha, meters along the light's axis. Null if there are no transparent casters.
   */
  readonly translucent: Texture | null;
  /** 1 minus the depth of the last caster from the light, unfiltered; 1 where there is none. Null if it is not kept, and for `cube`. */
  readonly last: Texture | null;
  /** Near and far distance of the shadow camera, meters. For directional lights, near is 0 and far is the whole range. */
  readonly nearM: number;
  readonly farM: number;
  /**
   * Size of the light, for the filter `pcss`. x: half the size in meters; for directional lights instead the radius of the penumbra, in UV
   * per meter between caster and receiver. y: UV per meter across the map at a distance of 1 m from a spot or point light; 0 for
   * directional lights.
   */
  readonly source: Vector2;
}

/** A light that casts a shadow, and its shadow map. */
export interface LightMap {
  readonly light: LightItem;
  /** The settings that the map was created for; other settings need another map. */
  readonly shadow: object;
  readonly map: ShadowMap;
  readonly askedSizePx: number;
  /**
   * Draws the casters from the light. `translucentShadows` contains the transparent ones; null if there are none. `keepsLast`: also the last
   * caster in each direction.
   */
  render(
    renderer: SceneRenderer,
    scene: Scene,
    translucentShadows: Scene | null,
    castersWorld: readonly Sphere[],
    keepsLast: boolean,
  ): void;
  dispose(): void;
}

/** Capabilities of the device for shadow maps. */
export interface MapLimits {
  readonly maxSizePx: number;
  /** Whether 32-bit floats can be rendered and filtered; without, filters that need them fall back to `soft`. */
  readonly floats: boolean;
}

/**
 * Maximum size of `vsm` maps. With moments and blur targets it takes 670 MB; twice the size would take 2.7 GB, for which browsers drop the
 * whole context.
 */
export const MAX_VSM_PX = 4096;

/** Size of a light's map, limited by the device. */
export function mapSizeOf({ mapSizePx, filter }: LightShadow | LocalLightShadow, { maxSizePx, floats }: MapLimits): number {
  return Math.min(mapSizePx, maxSizePx, filter === 'vsm' && floats ? MAX_VSM_PX : maxSizePx);
}

/** Creates the shadow map of a light; null if the light casts no shadow. */
export function createLightMap(light: LightItem, limits: MapLimits): LightMap | null {
  if (!isDirectLight(light) || light.shadow === null) return null;
  switch (light.kind) {
    case 'directional':
      return createSunMap(light, light.shadow, limits);
    case 'spot':
      return createConeMap(light, light.shadow, limits);
    case 'point':
      return createCubeMap(light, light.shadow, limits);
  }
}

/** The current shadow settings of the light; null if it casts none. */
export function shadowOf(light: LightItem): DirectionalLightItem['shadow'] | PointLightItem['shadow'] {
  return isDirectLight(light) ? light.shadow : null;
}

function createSunMap(light: DirectionalLightItem, shadow: LightShadow, limits: MapLimits): LightMap {
  const fit = createShadowFit();
  const flat = createFlatTarget(shadow, limits);
  const source = new Vector2();
  return {
    light,
    shadow,
    askedSizePx: shadow.mapSizePx,
    map: {
      ...flat.part,
      get translucent() {
        return flat.translucent.texture();
      },
      get last() {
        return flat.last();
      },
      kind: 'flat',
      mapFromWorld: fit.mapFromWorld,
      get bias() {
        return shadow.bias;
      },
      get normalBias() {
        return shadow.normalBiasM;
      },
      nearM: 0,
      get farM() {
        return fit.farM;
      },
      source,
    },
    render: (renderer, scene, translucentShadows, castersWorld, keepsLast) => {
      fitShadow(fit, light.towardsLightWorld, castersWorld, shadow.areaM, flat.part.target.width);
      source.set(Math.tan((shadow.sourceRad ?? 0) / 2) / shadow.areaM, 0);
      flat.render(renderer, scene, translucentShadows, cameraOf(fit), 0, fit.farM);
      if (keepsLast) flat.renderLast(renderer, scene, cameraOf(fit));
    },
    dispose: flat.dispose,
  };
}

function createConeMap(light: SpotLightItem, shadow: LocalLightShadow, limits: MapLimits): LightMap {
  const fit = createLocalShadowFit();
  const flat = createFlatTarget(shadow, limits);
  const mapFromWorld = new Matrix4();
  const source = new Vector2();
  return {
    light,
    shadow,
    askedSizePx: shadow.mapSizePx,
    map: {
      ...flat.part,
      get translucent() {
        return flat.translucent.texture();
      },
      get last() {
        return flat.last();
      },
      kind: 'flat',
      mapFromWorld,
      bias: 0,
      get normalBias() {
        return (shadow.biasPx * 2 * Math.tan(light.halfAngleRad)) / flat.part.target.width;
      },
      get nearM() {
        return fit.nearM;
      },
      get farM() {
        return fit.farM;
      },
      source,
    },
    render: (renderer, scene, translucentShadows, castersWorld, keepsLast) => {
      fitReach(fit, light.positionWorld, castersWorld, light.rangeM);
      aimCone(fit, light.positionWorld, light.towardsLightWorld, light.halfAngleRad, mapFromWorld);
      source.set((shadow.sourceM ?? 0) / 2, 0.5 / Math.tan(light.halfAngleRad));
      flat.render(renderer, scene, translucentShadows, cameraOf(fit), fit.nearM, fit.farM);
      if (keepsLast) flat.renderLast(renderer, scene, cameraOf(fit));
    },
    dispose: flat.dispose,
  };
}

const NO_SOURCE = new Vector2();

function createCubeMap(light: PointLightItem, shadow: LocalLightShadow, limits: MapLimits): LightMap {
  const fit = createLocalShadowFit();
  const target = createCubeTarget(mapSizeOf(shadow, limits));
  const translucent = createTranslucentShadow(() => new WebGLCubeRenderTarget(target.width, TRANSLUCENT_SHADOW));
  const mapFromWorld = new Matrix4();
  return {
    light,
    shadow,
    askedSizePx: shadow.mapSizePx,
    map: {
      kind: 'cube',
      target,
      mapFromWorld,
      filter: shadow.filter ?? 'soft',
      depths: null,
      moments: null,
      get translucent() {
        return translucent.texture();
      },
      last: null,
      bias: 0,
      get normalBias() {
        return (shadow.biasPx * 2) / target.width;
      },
      get nearM() {
        return fit.nearM;
      },
      get farM() {
        return fit.farM;
      },
      source: NO_SOURCE,
    },
    render: (renderer, scene, translucentShadows, castersWorld) => {
      const [x = 0, y = 0, z = 0] = light.positionWorld;
      mapFromWorld.makeTranslation(-x, -y, -z);
      fitReach(fit, light.positionWorld, castersWorld, light.rangeM);
      for (let face = 0; face < FACE_COUNT; face++) {
        aimFace(fit, light.positionWorld, face);
        renderer.drawDepth(target, scene, cameraOf(fit), face);
        translucent.render(renderer, translucentShadows, cameraOf(fit), face);
      }
    },
    dispose: () => {
      target.dispose();
      translucent.dispose();
    },
  };
}

// Set before it is read in every draw.
const scratchCamera = createCamera();
const scratchReverse = new Matrix4();

function cameraOf(fit: LocalShadowFit | ShadowFit): Camera {
  scratchCamera.projectionMatrix.copy(fit.clipFromLight);
  scratchCamera.matrixWorld.copy(fit.worldFromLight);
  scratchCamera.matrixWorldInverse.copy(fit.lightFromWorld);
  return scratchCamera;
}

function createCamera(): Camera {
  const camera = new Camera();
  camera.matrixAutoUpdate = false;
  camera.matrixWorldAutoUpdate = false;
  return camera;
}

/** Options of the color buffer of a shadow map. three.js requires one; this is the smallest. */
const COLOR = { format: RedFormat, minFilter: NearestFilter, magFilter: NearestFilter, generateMipmaps: false } as const;

interface FlatTarget {
  readonly part: Pick<ShadowMap, 'target' | 'filter' | 'depths' | 'moments'>;
  readonly translucent: TranslucentShadow;
  /** See `ShadowMap.last`. */
  last(): Texture | null;
  render(renderer: SceneRenderer, scene: Scene, translucentShadows: Scene | null, camera: Camera, nearM: number, farM: number): void;
  /** Draws the last caster in each direction. Changes the camera. */
  renderLast(renderer: SceneRenderer, scene: Scene, camera: Camera): void;
  dispose(): void;
}

/** Creates the target with the textures that the filter reads besides depth. */
function createFlatTarget(shadow: LightShadow | LocalLightShadow, limits: MapLimits): FlatTarget {
  const asked = shadow.filter ?? 'soft';
  const sizePx = mapSizeOf(shadow, limits);
  const filter = needsFloats(asked) && !limits.floats ? 'soft' : asked;
  const depthTexture = comparing(new DepthTexture(sizePx, sizePx, UnsignedIntType));
  const target = new WebGLRenderTarget(sizePx, sizePx, { ...COLOR, ...(needsFloats(filter) ? { type: FloatType } : {}), depthTexture });
  const translucent = createTranslucentShadow(() => new WebGLRenderTarget(sizePx, sizePx, TRANSLUCENT_SHADOW));
  const moments = filter === 'vsm' ? createMoments(target.texture, sizePx) : null;
  let last: WebGLRenderTarget | null = null;
  return {
    part: { target, filter, depths: filter === 'pcss' ? target.texture : null, moments: moments?.texture ?? null },
    translucent,
    last: () => last?.depthTexture ?? null,
    render: (renderer, scene, translucentShadows, camera, nearM, farM) => {
      renderer.drawDepth(target, scene, camera);
      moments?.update(renderer, nearM, farM);
      translucent.render(renderer, translucentShadows, camera);
    },
    renderLast: (renderer, scene, camera) => {
      last ??= new WebGLRenderTarget(sizePx, sizePx, { ...COLOR, depthTexture: new DepthTexture(sizePx, sizePx, UnsignedIntType) });
      // With near and far exchanged, the depth test keeps the farthest.
      camera.projectionMatrix.premultiply(scratchReverse.makeScale(1, 1, -1));
      renderer.drawDepth(last, scene, camera);
    },
    dispose: () => {
      target.dispose();
      last?.dispose();
      moments?.dispose();
      translucent.dispose();
    },
  };
}

/** Whether the filter reads depth values instead of comparing only. */
export function needsFloats(filter: ShadowFilter | undefined): boolean {
  return filter === 'vsm' || filter === 'pcss';
}

function createCubeTarget(sizePx: number): WebGLCubeRenderTarget {
  const target = new WebGLCubeRenderTarget(sizePx, COLOR);
  const depthTexture = new CubeDepthTexture(sizePx, UnsignedIntType);
  comparing(depthTexture);
  // Its published type requires images, which are not used.
  target.depthTexture = depthTexture as unknown as DepthTexture;
  return target;
}

/** Configures a depth texture for comparison and filtering by the GPU. */
function comparing<T extends Pick<DepthTexture, 'compareFunction' | 'minFilter' | 'magFilter'>>(texture: T): T {
  texture.compareFunction = LessEqualCompare;
  texture.minFilter = LinearFilter;
  texture.magFilter = LinearFilter;
  return texture;
}
