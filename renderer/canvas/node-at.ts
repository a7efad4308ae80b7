import type { Place } from '../state/editor/canvas-state.ts';
import { itemOf } from '../state/editor/item-ids.ts';

/** Id of the topmost node at a place in client pixels; null if there is none. Frames, notes and reroutes do not count. */
export function nodeAt({ x, y }: Place): string | null {
  const id = document.elementFromPoint(x, y)?.closest('.react-flow__node')?.getAttribute('data-id') ?? null;
  return id === null || itemOf(id) !== null ? null : id;
}
