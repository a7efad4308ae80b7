import {
  Camera,
  CubeDepthTexture,
  DepthTexture,
  LessEqualCompare,
  LinearFilter,
  Matrix4,
  NearestFilter,
  RedFormat,
  type Scene,
  type Sphere,
  UnsignedIntType,
  WebGLCubeRenderTarget,
  WebGLRenderTarget,
} from 'three';
import type { DirectionalLightItem, LightItem, LightShadow, PointLightItem, SpotLightItem } from '../../../../nodes/kit/runtime.ts';
import type { SceneRenderer } from '../scene-renderer.ts';
import { isLamp } from './is-lamp.ts';
import { aimCone, aimFace, createLampFit, FACE_COUNT, fitReach, type LampFit } from './lamp-fit.ts';
import { createShadowFit, fitShadow, type ShadowFit } from './shadow-fit.ts';

/** One light's depth map of this frame. */
export interface ShadowMap {
  /**
   * `flat`: `target` has one depth texture, and `mapFromWorld` gives its UV and depth, homogeneous. `cube`: it has six faces about
   * the light, and `mapFromWorld` gives the vector from the light. Both compare: 1 where lit.
   */
  readonly kind: 'flat' | 'cube';
  readonly target: WebGLRenderTarget;
  readonly mapFromWorld: Matrix4;
  /** Normalised depth by which receivers are pulled towards the light. */
  readonly bias: number;
  /** Metres along the receiver's normal; of a lamp with a place, per metre from it. */
  readonly normalBias: number;
  /** Of a lamp with a place. */
  readonly nearM: number;
  readonly farM: number;
}

/** A light with a shadow, and its map. */
export interface LightMap {
  readonly light: LightItem;
  /** Made for these settings; other ones need another map. */
  readonly shadow: object;
  readonly map: ShadowMap;
  /** Draws the casters as the light sees them. */
  render(renderer: SceneRenderer, scene: Scene, castersWorld: readonly Sphere[]): void;
}

/** Null where the light casts no shadow. */
export function createLightMap(light: LightItem): LightMap | null {
  if (!isLamp(light) || light.shadow === null) return null;
  switch (light.kind) {
    case 'directional':
      return createSunMap(light, light.shadow);
    case 'spot':
      return createConeMap(light, light.shadow);
    case 'point':
      return createCubeMap(light, light.shadow);
  }
}

/** Settings that the map was made for, as they are now; null where the light casts none any more. */
export function shadowOf(light: LightItem): DirectionalLightItem['shadow'] | PointLightItem['shadow'] {
  return isLamp(light) ? light.shadow : null;
}

function createSunMap(light: DirectionalLightItem, shadow: LightShadow): LightMap {
  const fit = createShadowFit();
  const target = createFlatTarget(shadow.mapSizePx);
  return {
    light,
    shadow,
    map: {
      kind: 'flat',
      target,
      mapFromWorld: fit.mapFromWorld,
      get bias() {
        return shadow.bias;
      },
      get normalBias() {
        return shadow.normalBiasM;
      },
      nearM: 0,
      farM: 0,
    },
    render: (renderer, scene, castersWorld) => {
      fitShadow(fit, light.towardsLightWorld, castersWorld, shadow.areaM, shadow.mapSizePx);
      renderer.drawDepth(target, scene, cameraOf(fit));
    },
  };
}

function createConeMap(light: SpotLightItem, shadow: NonNullable<SpotLightItem['shadow']>): LightMap {
  const fit = createLampFit();
  const target = createFlatTarget(shadow.mapSizePx);
  const mapFromWorld = new Matrix4();
  return {
    light,
    shadow,
    map: lampMap('flat', target, mapFromWorld, fit, () => (shadow.biasPx * 2 * Math.tan(light.halfAngleRad)) / shadow.mapSizePx),
    render: (renderer, scene, castersWorld) => {
      fitReach(fit, light.positionWorld, castersWorld, light.rangeM);
      aimCone(fit, light.positionWorld, light.towardsLightWorld, light.halfAngleRad, mapFromWorld);
      renderer.drawDepth(target, scene, cameraOf(fit));
    },
  };
}

function createCubeMap(light: PointLightItem, shadow: NonNullable<PointLightItem['shadow']>): LightMap {
  const fit = createLampFit();
  const target = createCubeTarget(shadow.mapSizePx);
  const mapFromWorld = new Matrix4();
  return {
    light,
    shadow,
    map: lampMap('cube', target, mapFromWorld, fit, () => (shadow.biasPx * 2) / shadow.mapSizePx),
    render: (renderer, scene, castersWorld) => {
      const [x = 0, y = 0, z = 0] = light.positionWorld;
      mapFromWorld.makeTranslation(-x, -y, -z);
      fitReach(fit, light.positionWorld, castersWorld, light.rangeM);
      for (let face = 0; face < FACE_COUNT; face++) {
        aimFace(fit, light.positionWorld, face);
        renderer.drawDepth(target, scene, cameraOf(fit), face);
      }
    },
  };
}

function lampMap(
  kind: ShadowMap['kind'],
  target: WebGLRenderTarget,
  mapFromWorld: Matrix4,
  fit: LampFit,
  normalBias: () => number,
): ShadowMap {
  return {
    kind,
    target,
    mapFromWorld,
    bias: 0,
    get normalBias() {
      return normalBias();
    },
    get nearM() {
      return fit.nearM;
    },
    get farM() {
      return fit.farM;
    },
  };
}

// Every draw sets all of it before it is read.
const scratchCamera = createCamera();

function cameraOf(fit: LampFit | ShadowFit): Camera {
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

/** A colour buffer is of no use, but three insists on one: the smallest. */
const COLOR = { format: RedFormat, minFilter: NearestFilter, magFilter: NearestFilter, generateMipmaps: false } as const;

function createFlatTarget(sizePx: number): WebGLRenderTarget {
  return new WebGLRenderTarget(sizePx, sizePx, { ...COLOR, depthTexture: comparing(new DepthTexture(sizePx, sizePx, UnsignedIntType)) });
}

function createCubeTarget(sizePx: number): WebGLCubeRenderTarget {
  const target = new WebGLCubeRenderTarget(sizePx, COLOR);
  const depthTexture = new CubeDepthTexture(sizePx, UnsignedIntType);
  comparing(depthTexture);
  // Its published type differs in what its images are, which nobody reads.
  target.depthTexture = depthTexture as unknown as DepthTexture;
  return target;
}

/** 24 bits of depth that compare and filter in hardware. */
function comparing<T extends Pick<DepthTexture, 'compareFunction' | 'minFilter' | 'magFilter'>>(texture: T): T {
  texture.compareFunction = LessEqualCompare;
  texture.minFilter = LinearFilter;
  texture.magFilter = LinearFilter;
  return texture;
}
