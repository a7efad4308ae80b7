import type { Matrix4, Object3D } from 'three';
import type { EnvironmentAsset } from './assets.ts';
import type { LightShadow, LocalLightShadow } from './light-shadow.ts';
import type { ReflectionCube, RoomDepth } from './session.ts';
import type { AppliedTechnique } from './technique-view.ts';

/**
 * Placed objects. A list is owned and changed by the node whose output it is; its readers rebuild what they derived from it
 * when `version` has changed, and read the matrices anew every frame.
 */
export interface ObjectList {
  version: number;
  readonly items: ObjectItem[];
}

export interface ObjectItem {
  /** Unique within the list and stable over frames. */
  key: string;
  /**
   * The subtree in object space, with up-to-date world matrices as if it stood at the origin. It is never put into a drawn
   * scene: those that draw make flat proxies sharing its geometries and materials (ADR 6).
   */
  root: Object3D;
  readonly worldFromObject: Matrix4;
  role: 'virtual' | 'phantom';
  castsShadow: boolean;
  receivesShadow: boolean;
  techniques?: readonly AppliedTechnique[];
}

export interface LightList {
  version: number;
  readonly items: LightItem[];
}

export type LightItem = DirectLightItem | EnvironmentLightItem | ProbeLightItem;

/** What shines from one place or direction, and may throw shadows. */
export type DirectLightItem = DirectionalLightItem | PointLightItem | SpotLightItem;

/** Light from one direction everywhere. */
export interface DirectionalLightItem {
  key: string;
  readonly kind: 'directional';
  /** It lights nothing, and is there for its shadow on real things. */
  readonly onlyShadows?: true;
  /** Linear-sRGB, times intensity in lux-like three.js units. */
  readonly radiance: Float32Array;
  /** Unit vector from the scene towards the light, world space. */
  readonly towardsLightWorld: Float32Array;
  shadow: LightShadow | null;
}

/** A lamp that shines alike in all directions: at d meters a surface that faces it receives intensity / d². */
export interface PointLightItem {
  key: string;
  readonly kind: 'point';
  /** Candela per channel of linear-sRGB. */
  readonly intensityCd: Float32Array;
  readonly positionWorld: Float32Array;
  /** Where its light ends, meters: it is faded out on the way there (`getDistanceAttenuation` of three.js). 0: it has no end. */
  rangeM: number;
  shadow: LocalLightShadow | null;
}

/** A lamp that shines in a cone. */
export interface SpotLightItem {
  key: string;
  readonly kind: 'spot';
  /** Candela per channel of linear-sRGB, in the middle of the cone. */
  readonly intensityCd: Float32Array;
  readonly positionWorld: Float32Array;
  /** Unit vector against the beam, world space. */
  readonly towardsLightWorld: Float32Array;
  /** As of a point light. */
  rangeM: number;
  /** From the cone's axis to its edge, below a quarter turn. */
  halfAngleRad: number;
  /** The part of that angle, from the edge inwards, over which the light comes up: 0 is a sharp edge. */
  penumbra: number;
  shadow: LocalLightShadow | null;
}

/** Surroundings that light a scene from all sides; without shadows. */
export interface EnvironmentLightItem {
  key: string;
  readonly kind: 'environment';
  /** Null while it loads. */
  environment: EnvironmentAsset | null;
  /** Factor on its radiance. */
  intensity: number;
  /** About the world's y axis. At 0 the middle of the panorama lies towards -z. */
  rotationRad: number;
  /** Whether it shows behind the objects. */
  visible: boolean;
}

/** Light from all sides as it was measured or guessed; without shadows. It takes the place of an environment. */
export interface ProbeLightItem {
  key: string;
  readonly kind: 'probe';
  /** 9 coefficients × RGB, coefficient by coefficient: linear-sRGB radiance in world space (WebXR Lighting Estimation §3.2). */
  readonly sphericalHarmonics: Float32Array;
  /** What shiny surfaces mirror; null: what the coefficients say. */
  reflection: ReflectionCube | null;
  /** Factor on all its radiance. */
  intensity: number;
}

/** A panorama on its way to the lights. */
export interface EnvironmentOutput {
  /** Null while it loads, and where none is chosen. */
  asset: EnvironmentAsset | null;
  /** Factor on its radiance. */
  intensity: number;
  /** About the world's y axis. At 0 the middle of the panorama lies towards -z. */
  rotationRad: number;
}

export interface RoomDepthOutput {
  readonly views: (RoomDepth | null)[];
}
