import type { ObjectList } from '../../kit/scene-lists.ts';
import { MAX_STROKE_CASTERS, type ShadowStrokes } from '../../kit/scene-look.ts';
import { createBoundingCylinders } from '../../kit/three/bounding-cylinders.ts';

/** Strokes of a shadow that get denser toward the objects of lists. */
export interface CasterStrokes {
  readonly strokes: ShadowStrokes;
  /** Finds the places of the objects. Call it once per frame. */
  update(casters: readonly ObjectList[]): void;
}

export function createCasterStrokes(params: Pick<ShadowStrokes, 'spacingPx' | 'turn' | 'contour' | 'contactM'>): CasterStrokes {
  const cylinders = createBoundingCylinders();
  const strokes: ShadowStrokes = {
    ...params,
    count: 0,
    places: new Float32Array(MAX_STROKE_CASTERS * 4),
    heights: new Float32Array(MAX_STROKE_CASTERS),
  };
  return {
    strokes,
    update: (casters) => {
      const found = cylinders.update(casters);
      strokes.count = Math.min(found.length, MAX_STROKE_CASTERS);
      for (let i = 0; i < strokes.count; i++) {
        const cylinder = found[i];
        if (!cylinder) continue;
        strokes.places.set(cylinder.baseWorld, i * 4);
        // The cylinder surrounds the corners of a box; its sides are nearer.
        strokes.places[i * 4 + 3] = cylinder.radiusM * Math.SQRT1_2;
        strokes.heights[i] = cylinder.heightM;
      }
    },
  };
}
