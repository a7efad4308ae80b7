import { Matrix4, type Sphere, Vector3 } from 'three';
import { placeCamera, REACH_M, type ShadowFit, setLevelAxes, UV_FROM_CLIP } from './shadow-fit.ts';

const MIN_NEAR_M = 0.01;

/** The shadow camera of a spot or point light: at the light, looking along its -z axis. */
export interface LocalShadowFit extends Omit<ShadowFit, 'mapFromWorld'> {
  nearM: number;
}

export function createLocalShadowFit(): LocalShadowFit {
  return {
    lightFromWorld: new Matrix4(),
    worldFromLight: new Matrix4(),
    clipFromLight: new Matrix4(),
    nearM: MIN_NEAR_M,
    farM: REACH_M,
  };
}

// Valid within one call.
const scratchRight = new Vector3();
const scratchUp = new Vector3();
const scratchBack = new Vector3();
const scratchPosition = new Vector3();

/**
 * Sets the near and far planes of the shadow camera: from the nearest caster to the range of the light, or far behind the farthest caster
 * if the range is unlimited. With a near plane at 1 cm, 24-bit perspective depth resolves 0.15 mm at 5 m.
 */
export function fitReach(fit: LocalShadowFit, positionWorld: ArrayLike<number>, castersWorld: readonly Sphere[], rangeM: number): void {
  scratchPosition.fromArray(positionWorld);
  let near = Infinity;
  let far = 0;
  for (const { center, radius } of castersWorld) {
    const distance = scratchPosition.distanceTo(center);
    near = Math.min(near, distance - radius);
    far = Math.max(far, distance + radius);
  }
  // Depth is measured along a face's axis, which at the corners of a cube is shorter than the distance by up to √3.
  fit.nearM = Number.isFinite(near) ? Math.max(near / Math.sqrt(3), MIN_NEAR_M) : MIN_NEAR_M;
  fit.farM = Math.max(rangeM > 0 ? rangeM : far + REACH_M, fit.nearM * 2);
}

/** Sets the shadow camera of a spot light, which sees the whole cone. `towardsLightWorld` is a unit vector against the beam. */
export function aimCone(
  fit: LocalShadowFit,
  positionWorld: ArrayLike<number>,
  towardsLightWorld: ArrayLike<number>,
  halfAngleRad: number,
  mapFromWorld: Matrix4,
): void {
  scratchBack.fromArray(towardsLightWorld);
  setLevelAxes(scratchBack, scratchRight, scratchUp);
  place(fit, positionWorld);
  project(fit, Math.tan(halfAngleRad));
  mapFromWorld.multiplyMatrices(UV_FROM_CLIP, fit.clipFromLight).multiply(fit.lightFromWorld);
}

/** Right, up and back axes of the camera for each face of a cube map, as in GL (OpenGL ES 3.0 §3.8.10, table 3.21). */
const FACES: readonly (readonly [right: Vector3, up: Vector3, back: Vector3])[] = [
  [new Vector3(0, 0, -1), new Vector3(0, -1, 0), new Vector3(-1, 0, 0)],
  [new Vector3(0, 0, 1), new Vector3(0, -1, 0), new Vector3(1, 0, 0)],
  [new Vector3(1, 0, 0), new Vector3(0, 0, 1), new Vector3(0, -1, 0)],
  [new Vector3(1, 0, 0), new Vector3(0, 0, -1), new Vector3(0, 1, 0)],
  [new Vector3(1, 0, 0), new Vector3(0, -1, 0), new Vector3(0, 0, -1)],
  [new Vector3(-1, 0, 0), new Vector3(0, -1, 0), new Vector3(0, 0, 1)],
];

export const FACE_COUNT = FACES.length;

/** Sets the shadow camera of a point light for one face of the cube around it: +x, -x, +y, -y, +z, -z. */
export function aimFace(fit: LocalShadowFit, positionWorld: ArrayLike<number>, face: number): void {
  const axes = FACES[face];
  if (!axes) throw new Error(`A cube has no face ${face}.`);
  scratchRight.copy(axes[0]);
  scratchUp.copy(axes[1]);
  scratchBack.copy(axes[2]);
  place(fit, positionWorld);
  project(fit, 1);
}

function place(fit: LocalShadowFit, positionWorld: ArrayLike<number>): void {
  scratchPosition.fromArray(positionWorld);
  placeCamera(fit, scratchRight, scratchUp, scratchBack, scratchPosition);
}

function project(fit: LocalShadowFit, tangent: number): void {
  const half = tangent * fit.nearM;
  fit.clipFromLight.makePerspective(-half, half, half, -half, fit.nearM, fit.farM);
}
