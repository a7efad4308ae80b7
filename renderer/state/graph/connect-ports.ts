import { sequence } from '../../../export/graph/commands/change.ts';
import type { PortAddress } from '../../../export/graph/project.ts';
import { routeOf, wiresThrough } from '../../../export/graph/routes.ts';
import type { Diagnostic } from '../../../nodes/kit/diagnostics.ts';
import { apply } from '../document/apply.ts';
import { graphOf, layoutOf } from '../editor/document.ts';
import type { Editor } from '../editor/editor.ts';
import { itemOf } from '../editor/item-ids.ts';
import { toastDiagnostic } from '../editor/ui.ts';
import { connect, refusalOf, rewire, takeWireFrom, type WireEnd } from './edit-graph.ts';
import { replaceSource } from './insert-on-wire.ts';
import { type Branch, branchAt } from './reroutes.ts';

/** What the canvas calls a port: of a node, or the one side of a reroute that wires come to or leave from. */
export type CanvasPort = PortAddress;

/** Why a wire cannot run between two ends, from the output's on, or null where it can. */
export function refusalOfEnds(editor: Editor, start: CanvasPort, end: CanvasPort): Diagnostic | null {
  const { from, route } = branchOf(editor, start);
  for (const { wire, rest } of wiresAfter(editor, end)) {
    if (rest.some((reroute) => route.includes(reroute))) {
      const message = 'The wire comes from there already.';
      return { code: 'SCR014', severity: 'error', nodeId: wire.to.node, port: wire.to.port, message };
    }
    const refusal = refusalOf(editor, { ...from, side: 'output' }, { ...wire.to, side: 'input' });
    if (refusal !== null) return refusal;
  }
  return isReroute(end) ? null : refusalOf(editor, { ...from, side: 'output' }, { ...end, side: 'input' });
}

/** As the canvas calls what is under the pointer. */
export interface CanvasHandle {
  readonly nodeId: string;
  readonly id?: string | null;
  readonly type: 'source' | 'target';
}

/** Why a wire in hand cannot be let go over a port or a reroute, or null where it can. */
export function refusalOver(editor: Editor, { node, port, side }: WireEnd, { nodeId, id, type }: CanvasHandle): Diagnostic | null {
  const over: WireEnd = { node: nodeId, port: id ?? '', side: type === 'source' ? 'output' : 'input' };
  if (itemOf(nodeId) === null) return refusalOf(editor, { node, port, side }, over);
  return side === 'output' ? refusalOfEnds(editor, { node, port }, over) : refusalOfEnds(editor, over, { node, port });
}

/** Says why a wire that was let go there was not drawn. */
export function explainRefusal(editor: Editor, inHand: WireEnd, over: CanvasHandle): void {
  const reason = refusalOver(editor, inHand, over);
  if (reason !== null) toastDiagnostic(editor.ui, reason);
}

/** Draws a wire. One that starts at a reroute comes from there; one that ends at a reroute brings all wires after it something else. */
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

/** Moves one end of what is drawn under an id. */
export function reconnectPorts(editor: Editor, stretch: string, start: CanvasPort, end: CanvasPort): boolean {
  if (isReroute(end)) return connectPorts(editor, start, end);
  const { from, route } = branchOf(editor, start);
  return rewire(editor, stretch, from, end, route);
}

/** Begins to draw a wire from a port or a reroute. */
export function startWireAt(editor: Editor, { node, port }: CanvasPort, side: 'input' | 'output'): void {
  const branch = branchAt(editor.document.getState(), node);
  if (branch === null) takeWireFrom(editor, { node, port }, side);
  else if (side === 'output') takeWireFrom(editor, branch.from, side, branch.route);
}

function branchOf(editor: Editor, address: CanvasPort): Branch {
  return branchAt(editor.document.getState(), address.node) ?? { from: address, route: [] };
}

function isReroute({ node }: CanvasPort): boolean {
  return itemOf(node)?.kind === 'reroute';
}

/** The wires that are led through a reroute, with their ways from it on; none for a port. */
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
