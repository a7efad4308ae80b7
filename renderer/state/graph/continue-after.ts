import { printWire } from '../../../export/graph/wires.ts';
import type { NodeDefinition } from '../../../nodes/kit/definition.ts';
import type { DraggedWire, Place } from '../editor/canvas-state.ts';
import { graphOf, layoutOf, nodeOf } from '../editor/document.ts';
import type { Editor } from '../editor/editor.ts';
import { portsThrough, wireTypes } from './insert-on-wire.ts';
import { fittingPort } from './palette-search.ts';

/** How a new node continues the selected one: in its only wire, or by a wire of its own. */
export type Continuation =
  | { readonly wire: string; readonly place: Place }
  | { readonly end: DraggedWire; readonly port: string; readonly place: Place };

const STEP_PX = 280;

/**
 * How a new node of this type continues a node. The first output that fits decides: its only wire, if the new node fits into it, else a new
 * wire. Params are not connected. Null if no output fits an input.
 */
export function continuationOf(editor: Editor, node: string, definition: NodeDefinition): Continuation | null {
  const state = editor.document.getState();
  const outputs = state.library.definition(nodeOf(state, node)?.type ?? '')?.outputs ?? {};
  const { x, y } = layoutOf(state).nodes[node] ?? { x: 0, y: 0 };
  const place = { x: x + STEP_PX, y };
  for (const [port, { type }] of Object.entries(outputs)) {
    const wires = graphOf(state).wires.filter(({ from }) => from.node === node && from.port === port);
    const [only] = wires.length === 1 ? wires : [];
    const types = only ? wireTypes(editor, printWire(only)) : null;
    if (only && types && portsThrough(definition, types)) return { wire: printWire(only), place };
    const input = fittingPort(definition, { type, side: 'output' });
    const declared = input === null ? undefined : definition.inputs[input];
    // An optional layer of a node that needs others, such as that of a Scene, is not what the node continues.
    const isMain = declared !== undefined && (declared.required || Object.values(definition.inputs).every(({ required }) => !required));
    if (input !== null && isMain) return { end: { node, port, side: 'output', type }, port: input, place };
  }
  return null;
}
