import { createInterfaceLookup, type NodeInterface } from '../../../export/graph/library/node-interface.ts';
import { paramWireType } from '../../../nodes/kit/definition.ts';
import { conversion, WIRE_TYPES, type WireType } from '../../../nodes/kit/wire-types.ts';
import type { WireInHand } from '../editor/canvas-state.ts';
import { type DocumentState, graphOf, nodeOf, titleOf } from '../editor/document.ts';
import type { Editor } from '../editor/editor.ts';
import { addToast } from '../editor/ui.ts';
import { connect, refusalOf } from './edit-graph.ts';

interface Candidate {
  readonly port: string;
  readonly label: string;
  readonly type: WireType;
  /** A wire here would take another one's place. */
  readonly taken?: boolean;
}

/**
 * Which port of a node takes a wire in hand that is let go over the node itself: the first that is not connected, as it is rather
 * than converted. Ports come before values, of which there must be just one: nobody can tell which of several is meant.
 */
export function portOver(editor: Editor, inHand: WireInHand, node: string): Candidate | null {
  const state = editor.document.getState();
  const face = faceOf(state, node);
  if (!face || node === inHand.node) return null;
  const ports = fitting(editor, inHand, node, inHand.side === 'output' ? inputsOf(state, node, face) : outputsOf(face));
  const [best] = [...ports].sort((a, b) => costOf(inHand, a) - costOf(inHand, b));
  if (best) return best;
  const values = inHand.side === 'output' ? fitting(editor, inHand, node, valuesOf(face)) : [];
  return values.length === 1 ? (values[0] ?? null) : null;
}

/** Draws a wire that was let go over a node to the port that takes it, or says why there is none. */
export function dropOnNode(editor: Editor, inHand: WireInHand, node: string | null): void {
  if (node === null || node === inHand.node) return;
  const over = portOver(editor, inHand, node);
  if (over === null) {
    addToast(editor.ui, { tone: 'info', ...whyNot(editor, inHand, node) });
    return;
  }
  const here = { node: inHand.node, port: inHand.port };
  const there = { node, port: over.port };
  if (inHand.side === 'output') connect(editor, here, there, inHand.route);
  else connect(editor, there, here);
}

function whyNot(editor: Editor, inHand: WireInHand, node: string): { readonly text: string; readonly detail?: string } {
  const state = editor.document.getState();
  const title = titleOf(state, node);
  const what = WIRE_TYPES[inHand.type].label.toLowerCase();
  if (inHand.side === 'input') return { text: `${title} gives no ${what}.` };
  const face = faceOf(state, node);
  const several = face !== undefined && fitting(editor, inHand, node, valuesOf(face)).length > 1;
  return several
    ? { text: `${title} has several values that take this.`, detail: 'Let the wire go over the one that you mean.' }
    : { text: `${title} takes no ${what}.` };
}

function faceOf(state: DocumentState, node: string): NodeInterface | undefined {
  return createInterfaceLookup(state.project, state.library)(nodeOf(state, node)?.type ?? '');
}

function fitting(editor: Editor, inHand: WireInHand, node: string, candidates: readonly Candidate[]): readonly Candidate[] {
  const side = inHand.side === 'output' ? 'input' : 'output';
  return candidates.filter(({ port }) => refusalOf(editor, inHand, { node, port, side }) === null);
}

function inputsOf(state: DocumentState, node: string, face: NodeInterface): Candidate[] {
  const { wires } = graphOf(state);
  const isWired = (port: string) => wires.some(({ to }) => to.node === node && to.port === port);
  return Object.entries(face.inputs).map(([port, { label, type, multiple }]) => ({
    port,
    label,
    type,
    taken: multiple !== true && isWired(port),
  }));
}

function outputsOf(face: NodeInterface): Candidate[] {
  return Object.entries(face.outputs).map(([port, { label, type }]) => ({ port, label, type }));
}

function valuesOf(face: NodeInterface): Candidate[] {
  return Object.entries(face.params).flatMap(([port, param]): Candidate[] => {
    const type = paramWireType(param);
    return type === undefined ? [] : [{ port, label: param.label, type }];
  });
}

/** Less is better. */
function costOf({ side, type }: WireInHand, { type: other, taken }: Candidate): number {
  const kind = side === 'output' ? conversion(type, other) : conversion(other, type);
  return (taken === true ? 2 : 0) + (kind === 'same' ? 0 : 1);
}
