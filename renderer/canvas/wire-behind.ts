import type { Place } from '../state/editor/canvas-state.ts';
import type { Editor } from '../state/editor/editor.ts';
import { canInsert } from '../state/graph/insert-on-wire.ts';

/** Sample positions across a node, as fractions of its width; ports are left out. */
const ACROSS = [0.2, 0.35, 0.5, 0.65, 0.8];
/** Sample distance; less than the 18 canvas units of a wire’s hit area at any zoom that shows ports. */
const STEP_PX = 8;

/**
 * Finds a wire behind a dragged node that the node can be inserted into, by hit tests on the page.
 *
 * @param place Top left of the node in client pixels. The DOM lags behind the drag, so it cannot be read from there.
 * @returns Id of the wire, or null.
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
