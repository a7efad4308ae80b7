import { Camera } from 'three';
import type { ViewFrame } from '../../../nodes/kit/session.ts';

/** A three.js camera with the matrices of a view; off-center projections stay exact. */
export interface ViewCamera {
  readonly camera: Camera;
  set(view: ViewFrame): void;
}

export function createViewCamera(): ViewCamera {
  const camera = new Camera();
  camera.matrixAutoUpdate = false;
  camera.matrixWorldAutoUpdate = false;
  return {
    camera,
    set: (view) => {
      camera.projectionMatrix.fromArray(view.clipFromView);
      camera.projectionMatrixInverse.copy(camera.projectionMatrix).invert();
      camera.matrixWorld.fromArray(view.worldFromView);
      camera.matrixWorldInverse.fromArray(view.viewFromWorld);
    },
  };
}
