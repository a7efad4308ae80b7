import type { Place } from '../state/editor/canvas-state.ts';
import type { Editor } from '../state/editor/editor.ts';
import { canInsert } from '../state/graph/insert-on-wire.ts';
import { nearestWire } from './nearest-wire.ts';

/** Part of a node at either side that holds its ports, as a fraction of its width. Wires that only pass there are not meant. */
const PORTS = 0.2;

/**
 * Finds the wire behind or near a dragged node that the node can be inserted into.
 *
 * @param place Top left of the node in client pixels. The DOM lags behind the drag, so it cannot be read from there.
 * @returns Id of the wire, or null.
 */
export function wireBehind(editor: Editor, node: string, place: Place): string | null {
  const drawn = document.querySelector(`.react-flow__node[data-id="${CSS.escape(node)}"]`)?.getBoundingClientRect();
  if (!drawn) return null;
  const inner = { x: place.x + PORTS * drawn.width, y: place.y, width: (1 - 2 * PORTS) * drawn.width, height: drawn.height };
  return nearestWire(inner, (id) => canInsert(editor, node, id));
}
