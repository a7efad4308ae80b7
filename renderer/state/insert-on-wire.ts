import { type Change, inTurn } from '../../export/graph/commands/change.ts';
import { moveNodes } from '../../export/graph/commands/layout.ts';
import { addNode } from '../../export/graph/commands/nodes.ts';
import { connect, disconnect, reorderWires } from '../../export/graph/commands/wires.ts';
import { makeNodeId } from '../../export/graph/names.ts';
import { own } from '../../export/graph/own.ts';
import type { Project, Wire } from '../../export/graph/project.ts';
import { printWire, sameAddress } from '../../export/graph/wires.ts';
import type { NodeDefinition } from '../../nodes/kit/definition.ts';
import { hasErrors } from '../../nodes/kit/diagnostics.ts';
import { conversion, type WireType } from '../../nodes/kit/wire-types.ts';
import { fittingPort } from '../canvas/palette-search.ts';
import { apply } from './apply.ts';
import type { Place, WireInHand } from './canvas.ts';
import { graphOf, nodeOf, titleOf } from './document.ts';
import type { Editor } from './editor.ts';
import { selectOnly } from './selection.ts';

/** The types at both ends of a wire of the open graph, or null where one is unknown. */
export function wireTypes(editor: Editor, wireId: string): { readonly from: WireType; readonly to: WireType } | null {
  const state = editor.document.getState();
  const wire = wireOf(editor, wireId);
  const source = wire && state.library.definition(nodeOf(state, wire.from.node)?.type ?? '');
  const target = wire && state.library.definition(nodeOf(state, wire.to.node)?.type ?? '');
  const from = source && own(source.outputs, wire.from.port)?.type;
  const to = target && own(target.inputs, wire.to.port)?.type;
  const param = target && own(target.params, wire.to.port);
  const taken = to ?? (param && param.type !== 'asset' ? (param.type === 'choice' ? 'number' : param.type) : undefined);
  return from === undefined || taken === undefined ? null : { from, to: taken };
}

/** The ports through which a wire can go, or null where it cannot go through such a node. */
export function portsThrough(
  definition: NodeDefinition,
  { from, to }: { readonly from: WireType; readonly to: WireType },
): { readonly input: string; readonly output: string } | null {
  const input = fittingPort(definition, { type: from, side: 'output' });
  const output = Object.entries(definition.outputs).find(([, { type }]) => conversion(type, to) !== 'none')?.[0];
  return input === null || output === undefined ? null : { input, output };
}

/** Whether a node that is let go over a wire goes into it: one that nothing is wired to yet, and that the wire can go through. */
export function canInsert(editor: Editor, node: string, wireId: string): boolean {
  const state = editor.document.getState();
  const isFree = graphOf(state).wires.every(({ from, to }) => from.node !== node && to.node !== node);
  const definition = state.library.definition(nodeOf(state, node)?.type ?? '');
  const types = wireTypes(editor, wireId);
  return isFree && definition !== undefined && types !== null && portsThrough(definition, types) !== null;
}

/** Leads a wire through a node, which stays at its place among the wires of its port. */
export function leadThrough(editor: Editor, node: string, wireId: string): (project: Project) => Change {
  const { library, graph } = editor.document.getState();
  const wire = wireOf(editor, wireId);
  const types = wireTypes(editor, wireId);
  return (project) => {
    const definition = library.definition(own(project.graphs[graph]?.nodes ?? {}, node)?.type ?? '');
    const ports = definition && types ? portsThrough(definition, types) : null;
    if (!wire || !ports) return inTurn(project);
    const output = { node, port: ports.output };
    const sources = (project.graphs[graph]?.wires ?? []).filter(({ to }) => sameAddress(to, wire.to)).map(({ from }) => from);
    const inOrder = sources.map((from) => (sameAddress(from, wire.from) ? output : from));
    return inTurn(
      project,
      (before) => disconnect(before, { graph, wires: [wire] }),
      (before) => connect(before, { library, graph, from: wire.from, to: { node, port: ports.input } }),
      (before) => connect(before, { library, graph, from: output, to: wire.to }),
      (before) => reorderWires(before, { graph, to: wire.to, from: inOrder }),
    );
  };
}

/** A node dragged onto a wire: its new place and both wires are one step. */
export function dropOnWire(editor: Editor, node: string, place: Place, wireId: string): boolean {
  const { project, graph } = editor.document.getState();
  const move = (before: Project) => moveNodes(before, { graph, positions: { [node]: place } });
  const change = inTurn(project, move, leadThrough(editor, node, wireId));
  if (hasErrors(change.diagnostics)) return apply(editor, 'Move', move(project));
  return apply(editor, `Insert ${titleOf(editor.document.getState(), node)}`, change);
}

const OVER = 'operator/over';

/** Whether a wire in hand may be let go over another one: a layer over a layer. */
export function canLayOver(editor: Editor, inHand: WireInHand, wireId: string): boolean {
  const wire = wireOf(editor, wireId);
  const types = wireTypes(editor, wireId);
  const { library } = editor.document.getState();
  const isLayer = inHand.side === 'output' && inHand.type === 'layer' && types?.from === 'layer' && types.to === 'layer';
  return isLayer && wire !== undefined && wire.from.node !== inHand.node && library.definition(OVER) !== undefined;
}

/** A layer let go over a layer's wire is laid over what runs there, by an Over that goes into the wire. The node, or null. */
export function layOver(editor: Editor, { node, port }: WireInHand, wireId: string, place: Place): string | null {
  const state = editor.document.getState();
  const { project, library, graph } = state;
  const wire = wireOf(editor, wireId);
  if (!wire) return null;
  const id = makeNodeId(project, OVER, editor.random);
  const sources = graphOf(state)
    .wires.filter(({ to }) => sameAddress(to, wire.to))
    .map(({ from }) => from);
  const output = { node: id, port: 'layer' };
  const inOrder = sources.map((from) => (sameAddress(from, wire.from) ? output : from));
  const change = inTurn(
    project,
    (before) => addNode(before, { library, graph, id, type: OVER, ...place }),
    (before) => disconnect(before, { graph, wires: [wire] }),
    (before) => connect(before, { library, graph, from: wire.from, to: { node: id, port: 'bottom' } }),
    (before) => connect(before, { library, graph, from: { node, port }, to: { node: id, port: 'top' } }),
    (before) => connect(before, { library, graph, from: output, to: wire.to }),
    (before) => reorderWires(before, { graph, to: wire.to, from: inOrder }),
  );
  if (!apply(editor, `Lay ${titleOf(state, node)} over`, change)) return null;
  selectOnly(editor.selection, [id]);
  return id;
}

function wireOf(editor: Editor, wireId: string): Wire | undefined {
  return graphOf(editor.document.getState()).wires.find((wire) => printWire(wire) === wireId);
}
