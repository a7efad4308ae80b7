import { canConnect } from '../../../export/graph/can-connect.ts';
import { type Change, sequence, unchanged } from '../../../export/graph/commands/change.ts';
import { changeType } from '../../../export/graph/commands/change-type.ts';
import { moveNodes, setCollapsed } from '../../../export/graph/commands/layout-commands.ts';
import { addNode, removeNodes, setMuted, setUnfused } from '../../../export/graph/commands/node-commands.ts';
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
import { diagnosticWithTitles } from '../document/message-titles.ts';
import { type DraggedWire, type Place, startWire } from '../editor/canvas-state.ts';
import { graphOf, layoutOf, nodeOf, titleOf } from '../editor/document.ts';
import type { Editor } from '../editor/editor.ts';
import { itemIds } from '../editor/item-ids.ts';
import { selectOnly } from '../editor/selection.ts';
import { type AddedRecipe, addRecipe } from './add-recipe.ts';
import { autoConnect } from './auto-connect.ts';
import { fitEncodings } from './fit-encodings.ts';
import { placeFreely } from './free-places.ts';
import { insertOnWire, insertPorts, spaceOnWire } from './insert-on-wire.ts';
import { removeItems } from './layout-items.ts';
import type { PaletteEntry } from './palette-search.ts';
import { recipeOfEntry } from './recipes.ts';

/** One end of a wire and its side of the node. */
export interface WireEnd extends PortAddress {
  readonly side: 'input' | 'output';
}

/** Why a wire cannot connect two ports; null if it can. An existing wire of the input would be replaced. */
export function refusalOf(editor: Editor, start: WireEnd, end: WireEnd): Diagnostic | null {
  const { project, library, graph } = editor.document.getState();
  if (start.side === end.side) {
    const message = `Both ports are ${start.side}s. Connect an output to an input.`;
    return { code: 'SCR012', severity: 'error', nodeId: end.node, port: end.port, message };
  }
  const [from, to] = start.side === 'output' ? [start, end] : [end, start];
  const result = canConnect(project, library, graph, addressOf(from), addressOf(to));
  return result.ok ? null : diagnosticWithTitles(editor.document.getState(), result.reason);
}

/**
 * Connects two ports.
 *
 * @param route Reroutes of the wire.
 */
export function connect(editor: Editor, from: PortAddress, to: PortAddress, route: readonly string[] = []): boolean {
  const { project, library, graph } = editor.document.getState();
  const change = sequence(
    project,
    (before) => connectCommand(before, { library, graph, from, to }),
    (before) => lead(before, { graph, from, to, route }),
    fitEncodings(editor, [{ from, to }]),
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
      fitEncodings(editor, [{ from, to }]),
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
 * Adds a node type or recipe, connects it to the dragged wire or inserts it into a wire, adds required sources, and selects it. The new
 * nodes cover no others. One undo step.
 */
export function addNodeFromPalette(
  editor: Editor,
  entry: PaletteEntry,
  place: Place,
  draggedWire: DraggedWire | null,
  throughWire: string | null = null,
): string | null {
  const { id, change } = additionOf(editor, entry, place, draggedWire, throughWire);
  if (!apply(editor, `Add ${entry.definition.title}`, change)) return null;
  selectOnly(editor.selection, [id]);
  return id;
}

interface Addition {
  /** The new node that is selected. */
  readonly id: string;
  readonly change: Change;
  /** Null for node types. */
  readonly recipe: AddedRecipe | null;
}

/** What `addNodeFromPalette` applies. */
export function additionOf(
  editor: Editor,
  { definition, port }: PaletteEntry,
  place: Place,
  draggedWire: DraggedWire | null,
  throughWire: string | null,
): Addition {
  const { project, library, graph } = editor.document.getState();
  const { random } = editor;
  const recipe = recipeOfEntry(editor, definition.type);
  const added = recipe && addRecipe(recipe, { library, graph, random, project, ...place });
  const id = added?.main ?? makeNodeId(project, definition.type, random);
  const change = sequence(
    project,
    (before) => added?.change(before) ?? addNode(before, { library, graph, id, type: definition.type, ...place }),
    (before) => {
      if (throughWire !== null)
        return (added ? insertPorts(editor, { ...added, definition }, throughWire) : insertOnWire(editor, id, throughWire))(before);
      if (draggedWire === null || port === null) return unchanged(before);
      const here = added ? (added.portOf(port) ?? { node: id, port }) : { node: id, port };
      const there = { node: draggedWire.node, port: draggedWire.port };
      const ends = draggedWire.side === 'output' ? { from: there, to: here } : { from: here, to: there };
      return sequence(
        before,
        (p) => connectCommand(p, { library, graph, ...ends }),
        (p) => lead(p, { graph, ...ends, route: draggedWire.route ?? [] }),
      );
    },
    ...(added?.ids ?? [id]).map((node) => autoConnect(node, { library, graph, random })),
    (before) => added?.light(before) ?? unchanged(before),
    fitEncodings(editor),
    (before) =>
      throughWire === null
        ? unchanged(before)
        : along(before, { graph, ids: added?.ids ?? [id], main: id }, spaceOnWire(editor, id, throughWire)),
    placeFreely(project, { library, graph, hasThumbnail: editor.preferences.getState().thumbnails }),
  );
  return { id, change, recipe: added ?? null };
}

interface Moved {
  readonly graph: string;
  readonly ids: readonly string[];
  /** The one of `ids` that a change moves. */
  readonly main: string;
}

/** A change that moves one of several nodes, and moves the others along. */
function along(project: Project, { graph, ids, main }: Moved, move: (project: Project) => Change): Change {
  const placeIn = ({ layout }: Project, id: string) => getOwn(layout[graph]?.nodes ?? {}, id) ?? { x: 0, y: 0 };
  const from = placeIn(project, main);
  return sequence(project, move, (before) => {
    const to = placeIn(before, main);
    const others = ids.filter((id) => id !== main).map((id) => [id, placeIn(before, id)] as const);
    const positions = Object.fromEntries(others.map(([id, { x, y }]) => [id, { x: x + to.x - from.x, y: y + to.y - from.y }]));
    return moveNodes(before, { graph, positions });
  });
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

/** Mutes the selected nodes, or unmutes them if all are muted. */
export function toggleMuted(editor: Editor): boolean {
  const state = editor.document.getState();
  const ids = [...editor.selection.getState().nodes];
  if (ids.length === 0) return false;
  const muted = !ids.every((id) => graphOf(state).nodes[id]?.muted === true);
  return apply(editor, muted ? 'Mute' : 'Unmute', setMuted(state.project, { graph: state.graph, nodes: ids, muted }));
}

/** Turns the fusion of the selected nodes' passes off, or on if it is off for all of them. */
export function toggleUnfused(editor: Editor): boolean {
  const state = editor.document.getState();
  const ids = [...editor.selection.getState().nodes];
  if (ids.length === 0) return false;
  const unfused = !ids.every((id) => graphOf(state).nodes[id]?.unfused === true);
  const label = unfused ? 'Do not fuse passes' : 'Fuse passes';
  return apply(editor, label, setUnfused(state.project, { graph: state.graph, nodes: ids, unfused }));
}

/** Changes the type of a node. Wires that fit the new type stay. */
export function swapType(editor: Editor, node: string, type: string): boolean {
  const state = editor.document.getState();
  const { project, library, graph } = state;
  const title = library.definition(type)?.title ?? type;
  return apply(editor, `Change ${titleOf(state, node)} to ${title}`, changeType(project, { library, graph, node, type }));
}

/** Collapses the selected nodes to their headers, or expands them if all are collapsed. */
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

/**
 * Starts to drag a wire from a port.
 *
 * @param route Reroutes that the wire already runs through.
 */
export function startWireFrom(editor: Editor, { node, port }: PortAddress, side: 'input' | 'output', route: readonly string[] = []): void {
  const type = typeOfPort(editor, { node, port, side });
  if (type !== null) startWire(editor.canvas, { node, port, side, type, ...(route.length === 0 ? {} : { route }) });
}

function typeOfPort(editor: Editor, { node, port, side }: WireEnd): WireType | null {
  const state = editor.document.getState();
  const type = nodeOf(state, node)?.type;
  const nodeInterface = type === undefined ? undefined : createInterfaceLookup(state.project, state.library)(type);
  if (!nodeInterface) return null;
  return (side === 'output' ? getOwn(nodeInterface.outputs, port)?.type : inputOf(nodeInterface, port)?.type) ?? null;
}

function findWires(editor: Editor, ids: Iterable<string>): Wire[] {
  const wanted = new Set(ids);
  return graphOf(editor.document.getState()).wires.filter((wire) => wanted.has(printWire(wire)));
}

function addressOf({ node, port }: PortAddress): PortAddress {
  return { node, port };
}
