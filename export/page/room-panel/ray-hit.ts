import { type PanelLayout, PX_PER_M } from './panel-layout.ts';

/** Intersection of a ray with the plane of the panel. */
export interface RayHit {
  /** Whether the ray meets the plane from the front. False if it points away or comes from behind. */
  hits: boolean;
  /** Position in pixels of the panel, origin at the top left; it may be outside the panel. */
  x: number;
  y: number;
  /** Distance along the ray, meters. */
  distanceM: number;
}

export function createRayHit(): RayHit {
  return { hits: false, x: 0, y: 0, distanceM: 0 };
}

/** Intersects a ray with the panel. `worldFromRay` is rigid; the ray points along its −z axis. */
export function castRay(out: RayHit, worldFromRay: Float32Array, worldFromPanel: Float32Array, layout: PanelLayout): void {
  const at = (m: Float32Array, i: number): number => m[i] ?? 0;
  // Origin and direction of the ray in the axes of the panel.
  let originX = 0;
  let originY = 0;
  let originZ = 0;
  let alongX = 0;
  let alongY = 0;
  let alongZ = 0;
  for (let row = 0; row < 3; row++) {
    const origin = at(worldFromRay, 12 + row) - at(worldFromPanel, 12 + row);
    const along = -at(worldFromRay, 8 + row);
    originX += origin * at(worldFromPanel, row);
    originY += origin * at(worldFromPanel, 4 + row);
    originZ += origin * at(worldFromPanel, 8 + row);
    alongX += along * at(worldFromPanel, row);
    alongY += along * at(worldFromPanel, 4 + row);
    alongZ += along * at(worldFromPanel, 8 + row);
  }
  out.hits = originZ > 0 && alongZ < -1e-4;
  if (!out.hits) return;
  out.distanceM = -originZ / alongZ;
  out.x = layout.widthPx / 2 + (originX + out.distanceM * alongX) * PX_PER_M;
  out.y = layout.heightPx / 2 - (originY + out.distanceM * alongY) * PX_PER_M;
}
