import { sequence } from '../../../export/graph/commands/change.ts';
import { putReroute, setRoutes } from '../../../export/graph/commands/route-commands.ts';
import { makeLayoutId } from '../../../export/graph/document-names.ts';
import type { Graph, GraphLayout, PortAddress, Wire } from '../../../export/graph/project.ts';
import { getOwn } from '../../../export/graph/record.ts';
import { routeOf, type Stretch, stretchesOf, wiresThrough } from '../../../export/graph/routes.ts';
import { printWire } from '../../../export/graph/wires.ts';
import { apply } from '../document/apply.ts';
import type { Place } from '../editor/canvas-state.ts';
import { graphOf, layoutOf, type OpenGraph, titleOf } from '../editor/document.ts';
import type { Editor } from '../editor/editor.ts';
import { itemId, itemOf } from '../editor/item-ids.ts';
import { type Selection, selectOnly } from '../editor/selection.ts';
import { portPlace } from './arrange.ts';

/** By the wires of a graph, which never change: gestures look up several stretches for each move of the pointer. */
const known = new WeakMap<Graph['wires'], { readonly routes: GraphLayout['routes']; readonly stretches: ReadonlyMap<string, Stretch> }>();

/** The stretch of wire with this id on the canvas. The last stretch has the id of its wire. */
export function findStretch(state: OpenGraph, id: string): Stretch | undefined {
  const { wires } = graphOf(state);
  const { routes } = layoutOf(state);
  let found = known.get(wires);
  if (found?.routes !== routes) {
    found = { routes, stretches: stretchesOf({ wires }, { routes }) };
    known.set(wires, found);
  }
  return found.stretches.get(id);
}

/** Ids of the wires that share a stretch. */
export function wiresOfStretch(state: OpenGraph, id: string): readonly string[] {
  return findStretch(state, id)?.wires.map(printWire) ?? [];
}

/** Adds a reroute to all wires of a stretch and selects it. Returns its id, or null if the stretch does not exist. */
export function addReroute(editor: Editor, stretch: string, place: Place): string | null {
  const state = editor.document.getState();
  const { project, graph } = state;
  const at = findStretch(state, stretch);
  if (!at) return null;
  const id = makeLayoutId(project, graph, 'reroute', editor.random);
  const layout = layoutOf(state);
  const routes = at.wires.map((wire) => [printWire(wire), [...at.before, id, ...routeOf(layout, wire).slice(at.before.length)]]);
  const change = sequence(
    project,
    (before) => putReroute(before, { graph, id, reroute: place }),
    (before) => setRoutes(before, { graph, routes: Object.fromEntries(routes) }),
  );
  if (!apply(editor, 'Add reroute', change)) return null;
  selectOnly(editor.selection, [], [], [itemId('reroute', id)]);
  return id;
}

/** The selected wire if nothing else is selected; else null. */
export function soleWire({ nodes, wires, items }: Selection): string | null {
  const [only] = nodes.size + items.size === 0 && wires.size === 1 ? wires : [];
  return only ?? null;
}

/** Adds a reroute in the middle of the longest stretch of the selected wire. */
export function addRerouteToSelected(editor: Editor): boolean {
  const state = editor.document.getState();
  const wire = soleWire(editor.selection.getState());
  let longest: { readonly id: string; readonly lengthPx: number; readonly middle: Place } | null = null;
  for (const [id, stretch] of stretchesOf(graphOf(state), layoutOf(state))) {
    const [from, to] = endsOf(editor, stretch);
    if (!from || !to || !stretch.wires.some((other) => printWire(other) === wire)) continue;
    const lengthPx = Math.hypot(to.x - from.x, to.y - from.y);
    if (longest === null || lengthPx > longest.lengthPx) {
      longest = { id, lengthPx, middle: { x: (from.x + to.x) / 2, y: (from.y + to.y) / 2 } };
    }
  }
  return longest !== null && addReroute(editor, longest.id, longest.middle) !== null;
}

function endsOf(editor: Editor, { source, wires, before, to }: Stretch): readonly [Place | undefined, Place | undefined] {
  const { reroutes } = layoutOf(editor.document.getState());
  const last = before.at(-1);
  return [
    last === undefined ? portPlace(editor, source, 'output') : getOwn(reroutes, last),
    to === null ? portPlace(editor, wires[0].to, 'input') : getOwn(reroutes, to),
  ];
}

export interface Branch {
  /** The output that the wires of the reroute come from. */
  readonly from: PortAddress;
  /** The reroutes from that output up to this reroute, included. */
  readonly route: readonly string[];
}

/** Source and route of a wire that starts from a reroute; null if there is no such reroute. */
export function branchAt(state: OpenGraph, canvasId: string): Branch | null {
  const item = itemOf(canvasId);
  if (item?.kind !== 'reroute') return null;
  const layout = layoutOf(state);
  const [wire] = wiresThrough(graphOf(state), layout, item.id);
  if (!wire) return null;
  const route = routeOf(layout, wire);
  return { from: wire.from, route: route.slice(0, route.indexOf(item.id) + 1) };
}

/** Accessible name of a reroute. */
export function rerouteWords(state: OpenGraph, wires: readonly Wire[]): string {
  const [first, ...more] = wires;
  if (!first) return 'Reroute';
  const from = titleOf(state, first.from.node);
  return more.length === 0
    ? `Reroute of the wire from ${from} to ${titleOf(state, first.to.node)}`
    : `Reroute of ${wires.length} wires from ${from}`;
}
