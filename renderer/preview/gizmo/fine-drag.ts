import { FINENESS } from '../../drag-keys.ts';
import type { PagePoint } from './page-point.ts';

/** A drag whose movements count less while it is fine. */
export interface FineDrag {
  /** Where the dragged part goes, for the pointer at a point of the page. */
  move(pointer: PagePoint, fine: boolean): PagePoint;
}

export function createFineDrag(start: PagePoint): FineDrag {
  let [last, reached] = [start, start];
  return {
    move: (pointer, fine) => {
      const share = fine ? 1 / FINENESS : 1;
      reached = { x: reached.x + (pointer.x - last.x) * share, y: reached.y + (pointer.y - last.y) * share };
      last = pointer;
      return reached;
    },
  };
}
