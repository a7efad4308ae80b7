import { canConnect } from '../../../export/graph/can-connect.ts';
import { sequence, unchanged } from '../../../export/graph/commands/change.ts';
import { changeType } from '../../../export/graph/commands/change-type.ts';
import { setCollapsed } from '../../../export/graph/commands/layout-commands.ts';
import { addNode, removeNodes, setMuted } from '../../../export/graph/commands/node-commands.ts';
import { setRoutes } from '../../../export/graph/commands/route-commands.ts';
import { connect as connectCommand, disconnect, reorderWires as reorderCommand } from '../../../export/graph/commands/wire-commands.ts';
import { makeNodeId } from '../../../export/graph/document-names.ts';
import { createInterfaceLookup, inputOf } from '../../../export/graph/library/node-interface.ts';
import type { PortAddress, Project, Wire } from '../../../export/graph/project.ts';
import { getOwn } from '../../../export/graph/record.ts';
import { routeOf } from '../../../export/graph/routes.ts';
import { printWire } from '../../../export/graph/wires.ts';
import type { Diagnostic } from '../../../nodes/kit/diagnostics.ts';
import type { WireType } from '../../../nodes/kit/wire-types.ts';
import { apply } from '../document/apply.ts';
import { inPlainWords } from '../document/plain-words.ts';
import { type Place, takeWire, type WireInHand } from '../editor/canvas-state.ts';
import { graphOf, layoutOf, nodeOf, titleOf } from '../editor/document.ts';
import type { Editor } from '../editor/editor.ts';
import { itemIds } from '../editor/item-ids.ts';
import { selectOnly } from '../editor/selection.ts';
import { autoConnect } from './auto-connect.ts';
import { insertOnWire } from './insert-on-wire.ts';
import { removeItems } from './layout-items.ts';
import type { PaletteEntry } from './palette-search.ts';
import { addRecipe, recipesOf } from './recipes.ts';

/** One end of a wire, and which side of its node it is on where that is known. */
export interface WireEnd extends PortAddress {
  readonly side: 'input' | 'output';
}

/** Why a wire cannot run between two ports, or null where it can. Replacing the wire of a port that takes one is no obstacle. */
export function refusalOf(editor: Editor, start: WireEnd, end: WireEnd): Diagnostic | null {
  const { project, library, graph } = editor.document.getState();
  if (start.side === end.side) {
    const message = `Both are ${start.side}s: a wire goes from an output to an input.`;
    return { code: 'SCR012', severity: 'error', nodeId: end.node, port: end.port, message };
  }
  const [from, to] = start.side === 'output' ? [start, end] : [end, start];
  const result = canConnect(project, library, graph, addressOf(from), addressOf(to));
  return result.ok ? null : inPlainWords(editor.document.getState(), result.reason);
}

/** `route`: the reroutes that the wire is led through. */
export function connect(editor: Editor, from: PortAddress, to: PortAddress, route: readonly string[] = []): boolean {
  const { project, library, graph } = editor.document.getState();
  const change = sequence(
    project,
    (before) => connectCommand(before, { library, graph, from, to }),
    (before) => lead(before, { graph, from, to, route }),
  );
  return apply(editor, 'Connect', change);
}

/** Moves one end of a wire. */
export function rewire(editor: Editor, wireId: string, from: PortAddress, to: PortAddress, route: readonly string[] = []): boolean {
  const { project, library, graph } = editor.document.getState();
  const old = findWires(editor, [wireId]);
  if (printWire({ from, to }) === wireId && sameOrder(route, routeOf(layoutOf(editor.document.getState()), { from, to }))) return false;
  return apply(
    editor,
    'Move wire',
    sequence(
      project,
      (before) => disconnect(before, { graph, wires: old }),
      (before) => connectCommand(before, { library, graph, from, to }),
      (before) => lead(before, { graph, from, to, route }),
    ),
  );
}

interface LeadOptions extends Wire {
  readonly graph: string;
  readonly route: readonly string[];
}

function lead(project: Project, { graph, from, to, route }: LeadOptions) {
  return route.length === 0 ? unchanged(project) : setRoutes(project, { graph, routes: { [printWire({ from, to })]: route } });
}

function sameOrder(a: readonly string[], b: readonly string[]): boolean {
  return a.length === b.length && a.every((id, i) => id === b[i]);
}

export function removeWires(editor: Editor, ids: readonly string[]): boolean {
  const { project, graph } = editor.document.getState();
  return apply(editor, 'Disconnect', disconnect(project, { graph, wires: findWires(editor, ids) }));
}

export function reorderWires(editor: Editor, to: PortAddress, from: readonly PortAddress[]): boolean {
  const { project, graph } = editor.document.getState();
  return apply(editor, 'Reorder wires', reorderCommand(project, { graph, to, from }));
}

/**
 * Adds the chosen type or combination at a place, wires what was in hand or leads a wire through it, gives it what it cannot do without,
 * and selects it; all one step.
 */
export function addNodeFromPalette(
  editor: Editor,
  { definition, port }: PaletteEntry,
  place: Place,
  inHand: WireInHand | null,
  throughWire: string | null = null,
): string | null {
  const { project, library, graph } = editor.document.getState();
  const { random } = editor;
  const combination = recipesOf(library).find((known) => known.definition.type === definition.type);
  const combined = combination && addRecipe(combination, { library, graph, random, project, ...place });
  const id = combined?.main ?? makeNodeId(project, definition.type, random);
  const change = sequence(
    project,
    (before) => combined?.change(before) ?? addNode(before, { library, graph, id, type: definition.type, ...place }),
    (before) => {
      if (throughWire !== null) return insertOnWire(editor, id, throughWire)(before);
      if (inHand === null || port === null) return unchanged(before);
      const here = combined ? (combined.portOf(port) ?? { node: id, port }) : { node: id, port };
      const there = { node: inHand.node, port: inHand.port };
      const ends = inHand.side === 'output' ? { from: there, to: here } : { from: here, to: there };
      return sequence(
        before,
        (p) => connectCommand(p, { library, graph, ...ends }),
        (p) => lead(p, { graph, ...ends, route: inHand.route ?? [] }),
      );
    },
    ...(combined?.ids ?? [id]).map((node) => autoConnect(node, { library, graph, random })),
  );
  if (!apply(editor, `Add ${definition.title}`, change)) return null;
  selectOnly(editor.selection, [id]);
  return id;
}

export function deleteSelection(editor: Editor): boolean {
  const { project, library, graph } = editor.document.getState();
  const { nodes, wires, items } = editor.selection.getState();
  if (nodes.size + wires.size + items.size === 0) return false;
  const gone = findWires(editor, wires);
  return apply(
    editor,
    'Delete',
    sequence(
      project,
      (before) => disconnect(before, { graph, wires: gone }),
      (before) => removeNodes(before, { library, graph, nodes: [...nodes] }),
      removeItems(editor, items),
    ),
  );
}

/** Mutes the selected nodes, or unmutes them where all are muted. */
export function toggleMuted(editor: Editor): boolean {
  const state = editor.document.getState();
  const ids = [...editor.selection.getState().nodes];
  if (ids.length === 0) return false;
  const muted = !ids.every((id) => graphOf(state).nodes[id]?.muted === true);
  return apply(editor, muted ? 'Mute' : 'Unmute', setMuted(state.project, { graph: state.graph, nodes: ids, muted }));
}

/** Makes another kind of node of one; its wires stay where they fit. */
export function swapType(editor: Editor, node: string, type: string): boolean {
  const state = editor.document.getState();
  const { project, library, graph } = state;
  const title = library.definition(type)?.title ?? type;
  return apply(editor, `Change ${titleOf(state, node)} to ${title}`, changeType(project, { library, graph, node, type }));
}

/** Shows the heads of the selected nodes alone, or all of them again where all are so. */
export function toggleCollapsed(editor: Editor): boolean {
  const state = editor.document.getState();
  const nodes = [...editor.selection.getState().nodes];
  if (nodes.length === 0) return false;
  const places = layoutOf(state).nodes;
  const collapsed = !nodes.every((id) => getOwn(places, id)?.collapsed === true);
  return apply(editor, collapsed ? 'Collapse' : 'Expand', setCollapsed(state.project, { graph: state.graph, nodes, collapsed }));
}

export function selectAll(editor: Editor): void {
  const state = editor.document.getState();
  const { nodes, wires } = graphOf(state);
  selectOnly(editor.selection, Object.keys(nodes), wires.map(printWire), itemIds(layoutOf(state)));
}

/** Begins to draw a wire from a port, through reroutes. */
export function takeWireFrom(editor: Editor, { node, port }: PortAddress, side: 'input' | 'output', route: readonly string[] = []): void {
  const type = typeOfPort(editor, { node, port, side });
  if (type !== null) takeWire(editor.canvas, { node, port, side, type, ...(route.length === 0 ? {} : { route }) });
}

function typeOfPort(editor: Editor, { node, port, side }: WireEnd): WireType | null {
  const state = editor.document.getState();
  const type = nodeOf(state, node)?.type;
  const face = type === undefined ? undefined : createInterfaceLookup(state.project, state.library)(type);
  if (!face) return null;
  return (side === 'output' ? getOwn(face.outputs, port)?.type : inputOf(face, port)?.type) ?? null;
}

function findWires(editor: Editor, ids: Iterable<string>): Wire[] {
  const wanted = new Set(ids);
  return graphOf(editor.document.getState()).wires.filter((wire) => wanted.has(printWire(wire)));
}

function addressOf({ node, port }: PortAddress): PortAddress {
  return { node, port };
}
