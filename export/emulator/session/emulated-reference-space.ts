import type { XRRigidTransform, XRSpace } from 'iwer';
import { P_REF_SPACE, P_SPACE, XRReferenceSpace, XRReferenceSpaceType } from 'iwer';
import { writeMatrix } from '../write-matrix.ts';

/** iwer's `getOffsetReferenceSpace` takes the transform for a matrix and makes a space of NaN. */
export class EmulatedReferenceSpace extends XRReferenceSpace {
  override getOffsetReferenceSpace(originOffset: object): XRReferenceSpace {
    const type = this[P_REF_SPACE].type ?? XRReferenceSpaceType.Local;
    return new EmulatedReferenceSpace(type, this, (originOffset as XRRigidTransform).matrix);
  }
}

/**
 * The native origin of a `local` space: where the viewer is and the way it faces, upright (WebXR Device API §7.1; iwer tilts it
 * with the head).
 *
 * @param worldFromViewer Column-major 4×4.
 */
export function levelPose(worldFromViewer: ArrayLike<number>): Float32Array {
  const at = (i: number): number => worldFromViewer[i] ?? 0;
  // The yaw of −z; looking straight up or down, that of the head's up or down.
  const steep = Math.hypot(at(8), at(10)) < 1e-3;
  const sign = at(9) > 0 ? 1 : -1;
  const [zx, zz] = steep ? [-sign * at(4), -sign * at(6)] : [at(8), at(10)];
  const length = Math.hypot(zx, zz) || 1;
  const [sin, cos] = [zx / length, zz / length];
  return new Float32Array([cos, 0, -sin, 0, 0, 1, 0, 0, sin, 0, cos, 0, at(12), at(13), at(14), 1]);
}

/** Re-centering: the space's origin jumps to where the viewer is now. */
export function moveOrigin(space: XRSpace, globalFromOrigin: Float32Array): void {
  writeMatrix(space[P_SPACE].offsetMatrix, globalFromOrigin);
}
