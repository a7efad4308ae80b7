import type { Place } from '../state/canvas.ts';
import { itemOf } from '../state/item-ids.ts';

/** The node that is seen at a place in client pixels; frames, notes and reroutes are none. */
export function nodeAt({ x, y }: Place): string | null {
  const id = document.elementFromPoint(x, y)?.closest('.react-flow__node')?.getAttribute('data-id') ?? null;
  return id === null || itemOf(id) !== null ? null : id;
}
