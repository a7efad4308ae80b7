import type { Mesh } from 'three';
import type { TechniqueView } from '../../../../../nodes/kit/technique-view.ts';
import { readsDirections } from './direction-parts.ts';
import { ensureCurvature } from './mesh-curvature.ts';
import { ensureDirections } from './mesh-directions.ts';
import { readsRadial } from './radial-parts.ts';

/** Computes the direction fields and the curvature of meshes once a technique reads them. */
export interface CurvatureNeeds {
  /** A mesh is drawn with a technique: computes what it reads now. */
  add(master: Mesh, technique: TechniqueView): void;
  /** Computes what techniques read since this frame, because values have changed. */
  update(): void;
  /** Forgets the meshes that were not added since the last call. */
  sweep(): void;
}

export function createCurvatureNeeds(): CurvatureNeeds {
  interface Waiting {
    readonly master: Mesh;
    readonly technique: TechniqueView;
    readonly name: 'along' | 'radial';
  }
  /** Meshes whose techniques may read more later. */
  let waiting: Waiting[] = [];
  let added: Waiting[] = [];

  return {
    add: (master, technique) => {
      if (readsDirections(technique.fragment)) {
        const isCurved = isRead(technique, 'along');
        ensureDirections(master, isCurved);
        if (!isCurved) added.push({ master, technique, name: 'along' });
      }
      if (!readsRadial(technique.fragment)) return;
      if (isRead(technique, 'radial')) ensureCurvature(master);
      else added.push({ master, technique, name: 'radial' });
    },
    update: () => {
      for (let i = waiting.length - 1; i >= 0; i--) {
        const one = waiting[i];
        if (!one || !isRead(one.technique, one.name)) continue;
        waiting.splice(i, 1);
        if (one.name === 'along') ensureDirections(one.master, true);
        else ensureCurvature(one.master);
      }
    },
    sweep: () => {
      waiting = added;
      added = [];
    },
  };
}

/** Whether a technique whose text names it reads the direction field (`along`) or the curvature (`radial`) with its current values. */
function isRead({ unread, uniforms }: TechniqueView, name: 'along' | 'radial'): boolean {
  if (!unread) return true;
  for (let i = 0; i < unread.length; i++) {
    const one = unread[i];
    if (one?.name !== name) continue;
    for (let k = 0; k < uniforms.length; k++) {
      const uniform = uniforms[k];
      if (uniform?.name === one.uniform && uniform.kind === 'number' && one.values.includes(uniform.view.value)) return false;
    }
  }
  return true;
}
