import type { Place } from '../state/canvas.ts';
import type { Editor } from '../state/editor.ts';
import { canInsert } from '../state/insert-on-wire.ts';

/** Where on a node a wire may lie, as parts of its width: on it, but not on its ports. */
const ACROSS = [0.2, 0.35, 0.5, 0.65, 0.8];
/** A wire can be hit 18 canvas units across; finer than that at any zoom that shows ports. */
const STEP_PX = 8;

/**
 * The wire that runs behind a node at a place, top left in client pixels, and that it can go into; or null. Asks the page what is
 * where. The place is handed over because the page draws a drag later than it is told of.
 */
export function wireBehind(editor: Editor, node: string, place: Place): string | null {
  const box = document.querySelector(`.react-flow__node[data-id="${CSS.escape(node)}"]`)?.getBoundingClientRect();
  if (!box) return null;
  const seen = new Set<string>();
  for (let y = place.y + STEP_PX / 2; y < place.y + box.height; y += STEP_PX) {
    for (const across of ACROSS) {
      for (const element of document.elementsFromPoint(place.x + across * box.width, y)) {
        const id = element.closest('.react-flow__edge')?.getAttribute('data-id');
        if (id === null || id === undefined || seen.has(id)) continue;
        seen.add(id);
        if (canInsert(editor, node, id)) return id;
      }
    }
  }
  return null;
}
