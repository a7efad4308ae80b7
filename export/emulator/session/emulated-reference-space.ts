import type { XRRigidTransform, XRSpace } from 'iwer';
import { P_REF_SPACE, P_SPACE, XRReferenceSpace, XRReferenceSpaceType } from 'iwer';
import { writeMatrix } from './rigid-transform.ts';

/** Fixes `getOffsetReferenceSpace` of iwer, which reads the transform as a matrix and returns NaN. */
export class EmulatedReferenceSpace extends XRReferenceSpace {
  override getOffsetReferenceSpace(originOffset: object): XRReferenceSpace {
    const type = this[P_REF_SPACE].type ?? XRReferenceSpaceType.Local;
    return new EmulatedReferenceSpace(type, this, (originOffset as XRRigidTransform).matrix);
  }
}

/**
 * Native origin of a `local` space: the viewer's position and yaw, upright (WebXR Device API §7.1). iwer tilts it with the head.
 *
 * @param worldFromViewer Column-major 4×4.
 */
export function levelPose(worldFromViewer: ArrayLike<number>): Float32Array {
  const at = (i: number): number => worldFromViewer[i] ?? 0;
  // The yaw of −z, or that of the head's y axis if the viewer looks straight up or down.
  const steep = Math.hypot(at(8), at(10)) < 1e-3;
  const sign = at(9) > 0 ? 1 : -1;
  const [zx, zz] = steep ? [-sign * at(4), -sign * at(6)] : [at(8), at(10)];
  const length = Math.hypot(zx, zz) || 1;
  const [sin, cos] = [zx / length, zz / length];
  return new Float32Array([cos, 0, -sin, 0, 0, 1, 0, 0, sin, 0, cos, 0, at(12), at(13), at(14), 1]);
}

/** Moves the origin of the space, to re-center it. */
export function moveOrigin(space: XRSpace, globalFromOrigin: Float32Array): void {
  writeMatrix(space[P_SPACE].offsetMatrix, globalFromOrigin);
}
