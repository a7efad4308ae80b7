import { sequence } from '../../../export/graph/commands/change.ts';
import type { PortAddress } from '../../../export/graph/project.ts';
import { routeOf, wiresThrough } from '../../../export/graph/routes.ts';
import type { Diagnostic } from '../../../nodes/kit/diagnostics.ts';
import { apply } from '../document/apply.ts';
import { graphOf, layoutOf } from '../editor/document.ts';
import type { Editor } from '../editor/editor.ts';
import { itemOf } from '../editor/item-ids.ts';
import { toastDiagnostic } from '../editor/ui.ts';
import { connect, refusalOf, rewire, startWireFrom, type WireEnd } from './edit-graph.ts';
import { replaceSource } from './insert-on-wire.ts';
import { type Branch, branchAt } from './reroutes.ts';

/** A port on the canvas: of a node, or the input or output side of a reroute. */
export type CanvasPort = PortAddress;

/**
 * Why a wire cannot run between two ends; null if it can. A reroute stands for all wires through it.
 *
 * @param start The end at the output.
 */
export function refusalOfEnds(editor: Editor, start: CanvasPort, end: CanvasPort): Diagnostic | null {
  const { from, route } = branchOf(editor, start);
  for (const { wire, rest } of wiresAfter(editor, end)) {
    if (rest.some((reroute) => route.includes(reroute))) {
      const message = 'The wire already runs through this reroute.';
      return { code: 'SCR014', severity: 'error', nodeId: wire.to.node, port: wire.to.port, message };
    }
    const refusal = refusalOf(editor, { ...from, side: 'output' }, { ...wire.to, side: 'input' });
    if (refusal !== null) return refusal;
  }
  return isReroute(end) ? null : refusalOf(editor, { ...from, side: 'output' }, { ...end, side: 'input' });
}

/** A handle under the pointer, as React Flow describes it. */
export interface CanvasHandle {
  readonly nodeId: string;
  readonly id?: string | null;
  readonly type: 'source' | 'target';
}

/** Why a dragged wire cannot be dropped on a port or reroute; null if it can. */
export function refusalOver(editor: Editor, { node, port, side }: WireEnd, { nodeId, id, type }: CanvasHandle): Diagnostic | null {
  const over: WireEnd = { node: nodeId, port: id ?? '', side: type === 'source' ? 'output' : 'input' };
  if (itemOf(nodeId) === null) return refusalOf(editor, { node, port, side }, over);
  return side === 'output' ? refusalOfEnds(editor, { node, port }, over) : refusalOfEnds(editor, over, { node, port });
}

/** Shows why a dropped wire was not connected. */
export function explainRefusal(editor: Editor, draggedWire: WireEnd, over: CanvasHandle): void {
  const reason = refusalOver(editor, draggedWire, over);
  if (reason !== null) toastDiagnostic(editor.ui, reason);
}

/** Connects two ends. A wire from a reroute branches off there. A wire to a reroute replaces the source of all wires through it. */
export function connectPorts(editor: Editor, start: CanvasPort, end: CanvasPort): boolean {
  const { from, route } = branchOf(editor, start);
  if (!isReroute(end)) return connect(editor, from, end, route);
  if (refusalOfEnds(editor, start, end) !== null) return false;
  const { project } = editor.document.getState();
  const steps = wiresAfter(editor, end).map(({ wire, rest }) =>
    replaceSource(editor, wire, { from, to: wire.to, route: [...route, ...rest] }),
  );
  return apply(editor, 'Connect', sequence(project, ...steps));
}

/** Moves one end of the stretch with this id. */
export function reconnectPorts(editor: Editor, stretch: string, start: CanvasPort, end: CanvasPort): boolean {
  if (isReroute(end)) return connectPorts(editor, start, end);
  const { from, route } = branchOf(editor, start);
  return rewire(editor, stretch, from, end, route);
}

/** Starts to drag a wire from a port or reroute. */
export function startWireAt(editor: Editor, { node, port }: CanvasPort, side: 'input' | 'output'): void {
  const branch = branchAt(editor.document.getState(), node);
  if (branch === null) startWireFrom(editor, { node, port }, side);
  else if (side === 'output') startWireFrom(editor, branch.from, side, branch.route);
}

function branchOf(editor: Editor, address: CanvasPort): Branch {
  return branchAt(editor.document.getState(), address.node) ?? { from: address, route: [] };
}

function isReroute({ node }: CanvasPort): boolean {
  return itemOf(node)?.kind === 'reroute';
}

/** The wires through a reroute, each with its route from there on; empty for a port. */
function wiresAfter(editor: Editor, { node }: CanvasPort) {
  const item = itemOf(node);
  if (item?.kind !== 'reroute') return [];
  const state = editor.document.getState();
  const layout = layoutOf(state);
  return wiresThrough(graphOf(state), layout, item.id).map((wire) => {
    const route = routeOf(layout, wire);
    return { wire, rest: route.slice(route.indexOf(item.id)) };
  });
}
