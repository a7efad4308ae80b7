import { Camera } from 'three';

/** One view as it is drawn: what a page gets as XRView and XRViewport. */
export interface Eye {
  readonly name: 'none' | 'left' | 'right';
  /** Column-major 4×4. */
  readonly clipFromView: Float32Array;
  readonly worldFromView: Float32Array;
  /** In the framebuffer, pixels, origin bottom left. */
  readonly viewport: { readonly x: number; readonly y: number; readonly widthPx: number; readonly heightPx: number };
}

/** A camera of three.js that takes its matrices as they are. */
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
