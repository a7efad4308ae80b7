import type { Matrix4, Object3D } from 'three';
import type { EnvironmentAsset } from './assets.ts';
import type { LightShadow, LocalLightShadow } from './light-shadow.ts';
import type { ReflectionCube, RoomDepth } from './session.ts';
import type { AppliedTechnique } from './technique-view.ts';

/**
 * A list of placed objects. Only the node that outputs a list changes it. Readers rebuild what they derive from the items when
 * `version` has changed, and read matrices and flags every frame.
 *
 * @example
 * ctx.outputs.objects.items.push(item);
 * ctx.outputs.objects.version++;
 */
export interface ObjectList {
  version: number;
  readonly items: ObjectItem[];
}

/** An object with its transform. */
export interface ObjectItem {
  /** Key of the object, unique within the list and stable over frames. */
  key: string;
  /**
   * The subtree in object space. Its world matrices are current, as if the object were at the origin. It is not part of a drawn scene:
   * scenes draw flat proxies that share its geometries and materials (ADR 6).
   */
  root: Object3D;
  readonly worldFromObject: Matrix4;
  /** A phantom stands for a real object: it occludes and takes shadows, and is not visible. */
  role: 'virtual' | 'phantom';
  castsShadow: boolean;
  receivesShadow: boolean;
  /**
   * True if the object is not drawn, casts no shadow and cannot be picked, while its materials are compiled, so that showing it later
   * compiles nothing. Absent: it is shown.
   */
  hidden?: boolean;
  /** False if the node Pick ignores the object, as a reticle. Absent: it can be picked. */
  pickable?: false;
  /** The node that claims presses on the object, as Place does to move it. Other nodes that report presses still report these. */
  claimant?: object;
  /** Custom materials that replace the object's own. */
  techniques?: readonly AppliedTechnique[];
}

/** A list of lights; `version` as in `ObjectList`. */
export interface LightList {
  version: number;
  readonly items: LightItem[];
}

/** A light of any kind. */
export type LightItem = DirectLightItem | EnvironmentLightItem | ProbeLightItem;

/** A light with a position or direction, which can cast shadows. */
export type DirectLightItem = DirectionalLightItem | PointLightItem | SpotLightItem;

/** A directional light. */
export interface DirectionalLightItem {
  key: string;
  readonly kind: 'directional';
  /** True if the light only casts shadows on real objects, and lights nothing. */
  readonly onlyShadows?: true;
  /** Linear-sRGB color times intensity, in the lux-like units of three.js. */
  readonly radiance: Float32Array;
  /** Unit vector from the scene towards the light, world space. */
  readonly towardsLightWorld: Float32Array;
  shadow: LightShadow | null;
}

/** A point light: at a distance of d meters, a surface that faces it receives intensity / d². */
export interface PointLightItem {
  key: string;
  readonly kind: 'point';
  /** Intensity of the light: candela per channel of linear sRGB. */
  readonly intensityCd: Float32Array;
  readonly positionWorld: Float32Array;
  /** Distance at which the light has faded to 0, meters (`getDistanceAttenuation` of three.js). 0: unlimited. */
  rangeM: number;
  shadow: LocalLightShadow | null;
}

/** A spot light. */
export interface SpotLightItem {
  key: string;
  readonly kind: 'spot';
  /** Intensity of the light on the axis of its cone: candela per channel of linear sRGB. */
  readonly intensityCd: Float32Array;
  readonly positionWorld: Float32Array;
  /** Unit vector from the target towards the light, world space. */
  readonly towardsLightWorld: Float32Array;
  /** Distance at which the light has faded to 0, meters, as in `PointLightItem`. 0: unlimited. */
  rangeM: number;
  /** Angle from the axis of the cone to its edge, less than π / 2. */
  halfAngleRad: number;
  /** The fraction of the angle, from the edge inwards, over which the light rises to full intensity; 0 is a hard edge. */
  penumbra: number;
  shadow: LocalLightShadow | null;
}

/** A panorama that lights a scene from all sides, without shadows. */
export interface EnvironmentLightItem {
  key: string;
  readonly kind: 'environment';
  /** The panorama. Null until it has loaded. */
  environment: EnvironmentAsset | null;
  /** Factor on the radiance of the panorama. */
  intensity: number;
  /** Rotation about the y axis of world space. At 0 the center of the panorama is towards -z. */
  rotationRad: number;
  /** Whether the panorama is visible behind the objects. */
  visible: boolean;
}

/** Measured or estimated light from all sides, without shadows. It replaces an environment. */
export interface ProbeLightItem {
  key: string;
  readonly kind: 'probe';
  /** 9 coefficients × RGB, coefficient by coefficient: linear-sRGB radiance in world space (WebXR Lighting Estimation §3.2). */
  readonly sphericalHarmonics: Float32Array;
  /** The cube map that shiny surfaces reflect; null: they reflect the light of the coefficients. */
  reflection: ReflectionCube | null;
  /** Factor on the radiance of the light. */
  intensity: number;
}

/** The output of a Panorama node. */
export interface EnvironmentOutput {
  /** The panorama. Null until it has loaded, and if none is chosen. */
  asset: EnvironmentAsset | null;
  /** Factor on the radiance of the panorama. */
  intensity: number;
  /** Rotation about the y axis of world space. At 0 the center of the panorama is towards -z. */
  rotationRad: number;
}

/** Room depth, one entry per view; null where the view has none. */
export interface RoomDepthOutput {
  readonly views: (RoomDepth | null)[];
}
