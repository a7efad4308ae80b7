import { Matrix4, type Sphere, Vector3 } from 'three';

/**
 * How far a shadow map reaches behind the casters, meters: beyond any room. For a directional light depth is linear over this distance, so
 * 24 bits resolve 4 µm.
 */
export const REACH_M = 60;

/** The shadow camera of a directional light. Depth 0 is in front of the nearest caster. */
export interface ShadowFit {
  /** Transform from world space to the space of the shadow camera: rigid, looking along -z, away from the light. */
  readonly lightFromWorld: Matrix4;
  readonly worldFromLight: Matrix4;
  readonly clipFromLight: Matrix4;
  /** Transform from world space to UV and depth of the map, each in [0, 1]. */
  readonly mapFromWorld: Matrix4;
  /** Distance from the camera at which depth is 1, meters. */
  farM: number;
}

export function createShadowFit(): ShadowFit {
  return {
    lightFromWorld: new Matrix4(),
    worldFromLight: new Matrix4(),
    clipFromLight: new Matrix4(),
    mapFromWorld: new Matrix4(),
    farM: REACH_M,
  };
}

// Valid within one call.
const scratchRight = new Vector3();
const scratchUp = new Vector3();
const scratchBack = new Vector3();
const scratchCenter = new Vector3();
/** Transform from clip space to UV and depth, each in [0, 1]. */
export const UV_FROM_CLIP = new Matrix4().set(0.5, 0, 0, 0.5, 0, 0.5, 0, 0.5, 0, 0, 0.5, 0.5, 0, 0, 0, 1);

/**
 * Centers a square map of `areaM` meters on the casters.
 *
 * The center moves by whole texels, so that the shadow's edge does not flicker while objects move. Casters outside the square cast no
 * shadow; those in front of it are kept, however near to the light.
 *
 * @param towardsLightWorld Unit vector.
 * @param castersWorld Bounding spheres of the casters; without any, the map is centered at the origin.
 */
export function fitShadow(
  fit: ShadowFit,
  towardsLightWorld: ArrayLike<number>,
  castersWorld: readonly Sphere[],
  areaM: number,
  mapSizePx: number,
): void {
  scratchBack.fromArray(towardsLightWorld);
  setLevelAxes(scratchBack, scratchRight, scratchUp);
  // Extent of the casters along the light's axes, relative to the world's origin.
  let minX = Infinity;
  let maxX = -Infinity;
  let minY = Infinity;
  let maxY = -Infinity;
  let minZ = Infinity;
  let maxZ = -Infinity;
  for (const { center, radius } of castersWorld) {
    const x = scratchRight.dot(center);
    const y = scratchUp.dot(center);
    const z = scratchBack.dot(center);
    minX = Math.min(minX, x - radius);
    maxX = Math.max(maxX, x + radius);
    minY = Math.min(minY, y - radius);
    maxY = Math.max(maxY, y + radius);
    minZ = Math.min(minZ, z - radius);
    maxZ = Math.max(maxZ, z + radius);
  }
  if (castersWorld.length === 0) minX = maxX = minY = maxY = minZ = maxZ = 0;
  const texelM = areaM / mapSizePx;
  scratchCenter
    .set(0, 0, 0)
    .addScaledVector(scratchRight, snap((minX + maxX) / 2, texelM))
    .addScaledVector(scratchUp, snap((minY + maxY) / 2, texelM))
    // The camera is in front of the nearest caster.
    .addScaledVector(scratchBack, maxZ + NEAR_M);

  placeCamera(fit, scratchRight, scratchUp, scratchBack, scratchCenter);
  const half = areaM / 2;
  fit.farM = maxZ - minZ + NEAR_M + REACH_M;
  fit.clipFromLight.makeOrthographic(-half, half, half, -half, 0, fit.farM);
  fit.mapFromWorld.multiplyMatrices(UV_FROM_CLIP, fit.clipFromLight).multiply(fit.lightFromWorld);
}

const NEAR_M = 0.01;

/** Sets the right and up axes of a camera from its back axis, all unit vectors. The right axis is horizontal. */
export function setLevelAxes(back: Vector3, right: Vector3, up: Vector3): void {
  // Any horizontal axis will do; near the zenith, x does.
  right.set(back.z, 0, -back.x);
  if (right.lengthSq() < 1e-6) right.set(1, 0, 0);
  right.normalize();
  up.crossVectors(back, right);
}

export function placeCamera(
  fit: Pick<ShadowFit, 'worldFromLight' | 'lightFromWorld'>,
  right: Vector3,
  up: Vector3,
  back: Vector3,
  positionWorld: Vector3,
): void {
  fit.worldFromLight.makeBasis(right, up, back).setPosition(positionWorld);
  fit.lightFromWorld.copy(fit.worldFromLight).invert();
}

function snap(value: number, step: number): number {
  return Math.round(value / step) * step;
}
