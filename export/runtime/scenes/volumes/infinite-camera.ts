import type { ViewFrame } from '../../../../nodes/kit/session.ts';
import { createViewCamera, type ViewCamera } from '../view-camera.ts';

/** Keeps points at infinity in front of the far plane, also in 32-bit floats (Lengyel 2007, “Projection matrix tricks”). */
const EPSILON = 2 ** -20;

/** A camera with an infinite far plane, because shadow volumes are infinite and must not be clipped. */
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
