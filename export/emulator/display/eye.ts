import { Camera } from 'three';

/** A view as it is drawn; pages get it as `XRView` and `XRViewport`. */
export interface Eye {
  readonly name: 'none' | 'left' | 'right';
  /** Column-major 4×4. */
  readonly clipFromView: Float32Array;
  readonly worldFromView: Float32Array;
  /** Pixels in the framebuffer, origin bottom left. */
  readonly viewport: { readonly x: number; readonly y: number; readonly widthPx: number; readonly heightPx: number };
}

/** Creates a three.js camera whose matrices the caller sets directly. */
export function createEyeCamera(): Camera {
  const camera = new Camera();
  camera.matrixAutoUpdate = false;
  camera.matrixWorldAutoUpdate = false;
  return camera;
}

export function aimCamera(camera: Camera, clipFromView: ArrayLike<number>, worldFromView: ArrayLike<number>): void {
  camera.projectionMatrix.fromArray(clipFromView);
  camera.projectionMatrixInverse.copy(camera.projectionMatrix).invert();
  camera.matrixWorld.fromArray(worldFromView);
  camera.matrixWorldInverse.copy(camera.matrixWorld).invert();
}
