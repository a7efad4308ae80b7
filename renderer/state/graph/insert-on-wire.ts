import { type Change, sequence } from '../../../export/graph/commands/change.ts';
import { moveNodes } from '../../../export/graph/commands/layout-commands.ts';
import { addNode } from '../../../export/graph/commands/node-commands.ts';
import { setRoutes } from '../../../export/graph/commands/route-commands.ts';
import { connect, disconnect, reorderWires } from '../../../export/graph/commands/wire-commands.ts';
import { makeNodeId } from '../../../export/graph/document-names.ts';
import { inputOf } from '../../../export/graph/library/node-interface.ts';
import type { PortAddress, Project, Wire } from '../../../export/graph/project.ts';
import { getOwn } from '../../../export/graph/record.ts';
import { routeOf, type Stretch } from '../../../export/graph/routes.ts';
import { printWire, sameAddress } from '../../../export/graph/wires.ts';
import type { NodeDefinition } from '../../../nodes/kit/definition.ts';
import { hasErrors } from '../../../nodes/kit/diagnostics.ts';
import { conversion, type WireType } from '../../../nodes/kit/wire-types.ts';
import { apply } from '../document/apply.ts';
import type { DraggedWire, Place } from '../editor/canvas-state.ts';
import { graphOf, layoutOf, nodeOf, titleOf } from '../editor/document.ts';
import type { Editor } from '../editor/editor.ts';
import { selectOnly } from '../editor/selection.ts';
import { fitEncodings } from './fit-encodings.ts';
import { placeFreely } from './free-places.ts';
import { placesAfterInsert } from './insert-spacing.ts';
import { fittingPort } from './palette-search.ts';
import { findStretch } from './reroutes.ts';

export interface WireTypes {
  readonly from: WireType;
  /** Types of the inputs at the other end, one per wire. */
  readonly to: readonly WireType[];
}

/** The wire types at the ends of a stretch; null if one is unknown. */
export function wireTypes(editor: Editor, stretch: string): WireTypes | null {
  const state = editor.document.getState();
  const at = findStretch(state, stretch);
  const definitionAt = (node: string) => state.library.definition(nodeOf(state, node)?.type ?? '');
  const from = at && getOwn(definitionAt(at.source.node)?.outputs ?? {}, at.source.port)?.type;
  const to = (at?.wires ?? []).flatMap(({ to: { node, port } }): WireType | [] => {
    const definition = definitionAt(node);
    return (definition && inputOf(definition, port)?.type) ?? [];
  });
  return from === undefined || to.length === 0 || to.length < (at?.wires.length ?? 0) ? null : { from, to };
}

/**
 * The input and output by which a node of this type is inserted into a wire; null if none fit. An optional input does not fit if the node
 * has required inputs, such as the layer of a Scene: the Scene only shows it behind glass and does not pass it on.
 */
export function portsThrough(
  definition: NodeDefinition,
  { from, to }: WireTypes,
): { readonly input: string; readonly output: string } | null {
  const input = fittingPort(definition, { type: from, side: 'output' });
  const output = Object.entries(definition.outputs).find(([, { type }]) => to.every((target) => conversion(type, target) !== 'none'))?.[0];
  if (input === null || output === undefined) return null;
  const { required } = definition.inputs[input] ?? {};
  if (required === false && Object.values(definition.inputs).some((other) => other.required)) return null;
  return { input, output };
}

/** Whether a node dropped on a wire is inserted into it: it has no wires yet, and its ports fit. */
export function canInsert(editor: Editor, node: string, stretch: string): boolean {
  const state = editor.document.getState();
  const isFree = graphOf(state).wires.every(({ from, to }) => from.node !== node && to.node !== node);
  const definition = state.library.definition(nodeOf(state, node)?.type ?? '');
  const types = wireTypes(editor, stretch);
  return isFree && definition !== undefined && types !== null && portsThrough(definition, types) !== null;
}

/** What is inserted into a wire: ports of its definition, and where they are in the graph. */
export interface Inserted {
  readonly definition: NodeDefinition;
  readonly portOf: (port: string) => PortAddress | null;
}

/** Inserts a node into a stretch. The wires keep their order at their ports and their reroutes. */
export function insertOnWire(editor: Editor, node: string, stretch: string): (project: Project) => Change {
  const { library, graph } = editor.document.getState();
  return (project) => {
    const definition = library.definition(getOwn(project.graphs[graph]?.nodes ?? {}, node)?.type ?? '');
    return definition ? insertPorts(editor, { definition, portOf: (port) => ({ node, port }) }, stretch)(project) : sequence(project);
  };
}

/** Inserts the nodes of a recipe, or one node, into a stretch. */
export function insertPorts(editor: Editor, { definition, portOf }: Inserted, stretch: string): (project: Project) => Change {
  const at = findStretch(editor.document.getState(), stretch);
  const types = wireTypes(editor, stretch);
  const ports = types && portsThrough(definition, types);
  const [input, output] = ports ? [portOf(ports.input), portOf(ports.output)] : [null, null];
  return (project) =>
    at && input && output
      ? sequence(project, ...replaceWires(editor, at, output), connectAlong(editor, { from: at.source, to: input, route: at.before }))
      : sequence(project);
}

/** Moves an inserted node to the middle of its wire, and the nodes after it to the right as far as needed. */
export function spaceOnWire(editor: Editor, node: string, stretch: string): (project: Project) => Change {
  const state = editor.document.getState();
  const at = findStretch(state, stretch);
  const places = layoutOf(state).nodes;
  const [source, target] = [at?.source.node, at?.wires[0]?.to.node].map((id) => getOwn(places, id ?? ''));
  return (project) => {
    if (!at || !source || !target) return sequence(project);
    const middle = { x: (source.x + target.x) / 2, y: (source.y + target.y) / 2 };
    return moveNodes(project, { graph: state.graph, positions: placesAfterInsert(state, node, middle, at) });
  };
}

/** A wire with its reroutes. */
interface RoutedWire extends Wire {
  readonly route: readonly string[];
}

/** Connects a wire and sets its reroutes. */
function connectAlong(editor: Editor, { from, to, route }: RoutedWire): (project: Project) => Change {
  const { library, graph } = editor.document.getState();
  return (project) =>
    sequence(
      project,
      (before) => connect(before, { library, graph, from, to }),
      (before) => setRoutes(before, { graph, routes: { [printWire({ from, to })]: route } }),
    );
}

/** Commands that connect the wires of a stretch to another source. The reroutes before the stretch are dropped, those after it stay. */
function replaceWires(editor: Editor, { wires, before: passed }: Stretch, from: PortAddress): ((project: Project) => Change)[] {
  const layout = layoutOf(editor.document.getState());
  return wires.map((wire) => replaceSource(editor, wire, { from, to: wire.to, route: routeOf(layout, wire).slice(passed.length) }));
}

/** Replaces a wire by one to the same port, at the same position in its order. */
export function replaceSource(editor: Editor, wire: Wire, led: RoutedWire): (project: Project) => Change {
  const { graph } = editor.document.getState();
  return (project) => {
    const sources = (project.graphs[graph]?.wires ?? []).filter(({ to }) => sameAddress(to, wire.to)).map(({ from }) => from);
    const inOrder = sources.map((from) => (sameAddress(from, wire.from) ? led.from : from));
    return sequence(
      project,
      (before) => disconnect(before, { graph, wires: [wire] }),
      connectAlong(editor, led),
      (before) => reorderWires(before, { graph, to: wire.to, from: inOrder }),
    );
  };
}

/** Drops a node on a wire: moves it, makes room, and inserts it. One undo step. */
export function dropOnWire(editor: Editor, node: string, place: Place, stretch: string): boolean {
  const state = editor.document.getState();
  const { project, graph } = state;
  const at = findStretch(state, stretch);
  const positions = at ? placesAfterInsert(state, node, place, at) : { [node]: place };
  const change = sequence(
    project,
    (before) => moveNodes(before, { graph, positions }),
    insertOnWire(editor, node, stretch),
    fitEncodings(editor),
  );
  if (hasErrors(change.diagnostics)) return apply(editor, 'Move', moveNodes(project, { graph, positions: { [node]: place } }));
  return apply(editor, `Insert ${titleOf(state, node)}`, change);
}

const OVER = 'operator/over';

/** Whether dropping a dragged wire on another one composites the layers: both carry layers. */
export function canCompositeOver(editor: Editor, draggedWire: DraggedWire, stretch: string): boolean {
  const state = editor.document.getState();
  const at = findStretch(state, stretch);
  const types = wireTypes(editor, stretch);
  const isLayer = draggedWire.side === 'output' && [draggedWire.type, types?.from, ...(types?.to ?? [])].every((type) => type === 'layer');
  return isLayer && at !== undefined && at.source.node !== draggedWire.node && state.library.definition(OVER) !== undefined;
}

/**
 * Composites a layer over the layer of a wire: inserts an Alpha over node into the wire. Returns the node id, or null if that failed.
 */
export function compositeOver(editor: Editor, { node, port, route = [] }: DraggedWire, stretch: string, place: Place): string | null {
  const state = editor.document.getState();
  const { project, library, graph } = state;
  const at = findStretch(state, stretch);
  if (!at) return null;
  const id = makeNodeId(project, OVER, editor.random);
  const change = sequence(
    project,
    (before) => addNode(before, { library, graph, id, type: OVER, ...place }),
    ...replaceWires(editor, at, { node: id, port: 'layer' }),
    connectAlong(editor, { from: at.source, to: { node: id, port: 'bottom' }, route: at.before }),
    connectAlong(editor, { from: { node, port }, to: { node: id, port: 'top' }, route }),
    fitEncodings(editor, [{ from: { node, port }, to: { node: id, port: 'top' } }]),
    placeFreely(project, { library, graph, hasThumbnail: editor.preferences.getState().thumbnails }),
  );
  if (!apply(editor, `Composite ${titleOf(state, node)}`, change)) return null;
  selectOnly(editor.selection, [id]);
  return id;
}
