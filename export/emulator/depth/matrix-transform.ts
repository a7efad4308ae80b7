import { P_RIGID_TRANSFORM, XRRigidTransform } from 'iwer';
import { Matrix4 } from 'three';
import { writeMatrix } from '../write-matrix.ts';

/**
 * An `XRRigidTransform` with an arbitrary matrix. `normDepthBufferFromNormView` contains flips and scales on real devices, which position
 * and orientation cannot express.
 */
export class MatrixTransform extends XRRigidTransform {
  constructor(matrix: ArrayLike<number>) {
    super();
    writeMatrix(this[P_RIGID_TRANSFORM].matrix, matrix);
  }

  override get inverse(): XRRigidTransform {
    const inverted = new Matrix4().fromArray(Array.from(this.matrix)).invert();
    return new MatrixTransform(inverted.elements);
  }
}
