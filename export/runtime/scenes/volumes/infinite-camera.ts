import type { ViewFrame } from '../../../../nodes/kit/session.ts';
import { createViewCamera, type ViewCamera } from '../view-camera.ts';

/** Keeps what is infinitely far just before the far end, in 32-bit floats too (Lengyel 2007, "Projection matrix tricks"). */
const EPSILON = 2 ** -20;

/** A view's camera that sees to infinity: shadow volumes have no end, and may not be cut off behind. */
export function createInfiniteCamera(): ViewCamera {
  const { camera, set } = createViewCamera();
  return {
    camera,
    set: (view: ViewFrame) => {
      set(view);
      const { elements } = camera.projectionMatrix;
      const nearM = (elements[14] ?? 0) / ((elements[10] ?? 0) - 1);
      elements[10] = EPSILON - 1;
      elements[14] = (EPSILON - 2) * nearM;
      camera.projectionMatrixInverse.copy(camera.projectionMatrix).invert();
    },
  };
}
