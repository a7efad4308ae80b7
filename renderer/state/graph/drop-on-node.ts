import { createInterfaceLookup, type NodeInterface } from '../../../export/graph/library/node-interface.ts';
import { paramWireType } from '../../../nodes/kit/definition.ts';
import { conversion, WIRE_TYPES, type WireType } from '../../../nodes/kit/wire-types.ts';
import type { DraggedWire } from '../editor/canvas-state.ts';
import { type DocumentState, graphOf, nodeOf, titleOf } from '../editor/document.ts';
import type { Editor } from '../editor/editor.ts';
import { addToast } from '../editor/ui.ts';
import { connect, refusalOf } from './edit-graph.ts';

interface Candidate {
  readonly port: string;
  readonly label: string;
  readonly type: WireType;
  /** Whether the port already has a wire, which would be replaced. */
  readonly taken?: boolean;
}

/**
 * The port that a wire dropped on a node connects to: unconnected ports first, then those of the same type. A param is chosen only if
 * no input fits, and only if no other param does or it has the name of the output, such as `text`.
 */
export function portOver(editor: Editor, draggedWire: DraggedWire, node: string): Candidate | null {
  const state = editor.document.getState();
  const nodeInterface = interfaceOf(state, node);
  if (!nodeInterface || node === draggedWire.node) return null;
  const ports = fitting(
    editor,
    draggedWire,
    node,
    draggedWire.side === 'output' ? inputsOf(state, node, nodeInterface) : outputsOf(nodeInterface),
  );
  const [best] = [...ports].sort((a, b) => costOf(draggedWire, a) - costOf(draggedWire, b));
  if (best) return best;
  const values = draggedWire.side === 'output' ? fitting(editor, draggedWire, node, valuesOf(nodeInterface)) : [];
  const chosen = values.length === 1 ? values[0] : values.find(({ port }) => port === draggedWire.port);
  return chosen ?? null;
}

/** Connects a wire that was dropped on a node, or shows why no port fits. */
export function dropOnNode(editor: Editor, draggedWire: DraggedWire, node: string | null): void {
  if (node === null || node === draggedWire.node) return;
  const over = portOver(editor, draggedWire, node);
  if (over === null) {
    addToast(editor.ui, { tone: 'info', ...explainMiss(editor, draggedWire, node) });
    return;
  }
  const here = { node: draggedWire.node, port: draggedWire.port };
  const there = { node, port: over.port };
  if (draggedWire.side === 'output') connect(editor, here, there, draggedWire.route);
  else connect(editor, there, here);
}

function explainMiss(editor: Editor, draggedWire: DraggedWire, node: string): { readonly text: string; readonly detail?: string } {
  const state = editor.document.getState();
  const title = titleOf(state, node);
  const what = WIRE_TYPES[draggedWire.type].label.toLowerCase();
  if (draggedWire.side === 'input') return { text: `${title} has no ${what} output.` };
  const nodeInterface = interfaceOf(state, node);
  const several = nodeInterface !== undefined && fitting(editor, draggedWire, node, valuesOf(nodeInterface)).length > 1;
  return several
    ? { text: `${title} has several parameters of this type.`, detail: 'Drop the wire on the port of one of them.' }
    : { text: `${title} has no ${what} input.` };
}

function interfaceOf(state: DocumentState, node: string): NodeInterface | undefined {
  return createInterfaceLookup(state.project, state.library)(nodeOf(state, node)?.type ?? '');
}

function fitting(editor: Editor, draggedWire: DraggedWire, node: string, candidates: readonly Candidate[]): readonly Candidate[] {
  const side = draggedWire.side === 'output' ? 'input' : 'output';
  return candidates.filter(({ port }) => refusalOf(editor, draggedWire, { node, port, side }) === null);
}

function inputsOf(state: DocumentState, node: string, nodeInterface: NodeInterface): Candidate[] {
  const { wires } = graphOf(state);
  const isWired = (port: string) => wires.some(({ to }) => to.node === node && to.port === port);
  return Object.entries(nodeInterface.inputs).map(([port, { label, type, multiple }]) => ({
    port,
    label,
    type,
    taken: multiple !== true && isWired(port),
  }));
}

function outputsOf(nodeInterface: NodeInterface): Candidate[] {
  return Object.entries(nodeInterface.outputs).map(([port, { label, type }]) => ({ port, label, type }));
}

function valuesOf(nodeInterface: NodeInterface): Candidate[] {
  return Object.entries(nodeInterface.params).flatMap(([port, param]): Candidate[] => {
    const type = paramWireType(param);
    return type === undefined ? [] : [{ port, label: param.label, type }];
  });
}

/** Rank of a port; lower is better. */
function costOf({ side, type }: DraggedWire, { type: other, taken }: Candidate): number {
  const kind = side === 'output' ? conversion(type, other) : conversion(other, type);
  return (taken === true ? 2 : 0) + (kind === 'same' ? 0 : 1);
}
