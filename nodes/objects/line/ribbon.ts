import { BufferAttribute, BufferGeometry, Matrix4, Sphere, Vector3 } from 'three';
import type { SessionFrame } from '../../kit/session.ts';
import { writeViewerPosition } from '../../kit/viewer.ts';

/**
 * The geometry of a flat line that faces the viewer and is equally wide everywhere in the image.
 *
 * Its corners lie in planes parallel to the image, so that the width in pixels is exact also far from the center. three's `Line2` is not
 * used: it has a shader of its own, to which Scrim's occlusion, scene layers and fog do not apply, and it would make pages larger.
 */
export interface Ribbon {
  readonly geometry: BufferGeometry;
  /**
   * Writes the corners of the ribbon for the views of a frame, in world space.
   *
   * @returns False if no part of the line is in front of the viewer.
   */
  lay(from: ArrayLike<number>, to: ArrayLike<number>, widthPx: number, frame: SessionFrame): boolean;
}

/** A line that is shorter in the image counts as having no direction, pixels. */
const LEAST_PX = 1e-3;

export function createRibbon(): Ribbon {
  const corners = new BufferAttribute(new Float32Array(12), 3);
  const geometry = new BufferGeometry();
  geometry.setAttribute('position', corners);
  geometry.setIndex([0, 1, 2, 2, 1, 3]);
  geometry.boundingSphere = new Sphere();
  const eye = new Float64Array(3);
  const worldFromView = new Matrix4();
  const viewFromWorld = new Matrix4();
  const start = new Vector3();
  const end = new Vector3();
  const corner = new Vector3();

  /** Moves an end that is behind the near plane onto that plane; returns false if both ends are behind it. */
  function clip(nearM: number): boolean {
    const [a, b] = [-start.z - nearM, -end.z - nearM];
    if (a < 0 && b < 0) return false;
    if (a < 0) start.lerp(end, a / (a - b));
    else if (b < 0) end.lerp(start, b / (b - a));
    return true;
  }

  return {
    geometry,
    lay: (from, to, widthPx, frame) => {
      const view = frame.viewCount > 0 ? frame.views[0] : undefined;
      if (!view || !writeViewerPosition(eye, frame)) return false;
      // In the middle between two eyes, whose images are parallel.
      worldFromView.fromArray(view.worldFromView).setPosition(eye[0] ?? 0, eye[1] ?? 0, eye[2] ?? 0);
      viewFromWorld.copy(worldFromView).invert();
      start.set(from[12] ?? 0, from[13] ?? 0, from[14] ?? 0).applyMatrix4(viewFromWorld);
      end.set(to[12] ?? 0, to[13] ?? 0, to[14] ?? 0).applyMatrix4(viewFromWorld);
      if (!clip(view.nearM)) return false;
      // Pixels of a meter at a depth of one meter.
      const focalX = ((view.clipFromView[0] ?? 1) * view.viewport.widthPx) / 2;
      const focalY = ((view.clipFromView[5] ?? 1) * view.viewport.heightPx) / 2;
      const alongX = focalX * (end.x / -end.z - start.x / -start.z);
      const alongY = focalY * (end.y / -end.z - start.y / -start.z);
      const length = Math.hypot(alongX, alongY);
      const [acrossX, acrossY] = length > LEAST_PX ? [-alongY / length, alongX / length] : [1, 0];
      for (let i = 0; i < 4; i++) {
        const at = i < 2 ? start : end;
        const halfPx = (i % 2 === 0 ? widthPx : -widthPx) / 2;
        corner.set(at.x + (acrossX * halfPx * -at.z) / focalX, at.y + (acrossY * halfPx * -at.z) / focalY, at.z);
        corner.applyMatrix4(worldFromView);
        corners.setXYZ(i, corner.x, corner.y, corner.z);
      }
      corners.needsUpdate = true;
      // A change of the attribute alone leaves it.
      geometry.computeBoundingSphere();
      return true;
    },
  };
}
