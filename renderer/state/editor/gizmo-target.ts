import { subgraphName } from '../../../export/graph/document-names.ts';
import type { GraphNode, Project } from '../../../export/graph/project.ts';
import { getOwn } from '../../../export/graph/record.ts';
import type { Handle, NodeDefinition } from '../../../nodes/kit/definition.ts';
import type { GizmoMode } from '../../preview-protocol.ts';
import { type DocumentState, graphOf, nodeOf } from './document.ts';
import { nodePath } from './layer-names.ts';

/** What a gizmo changes: params of one node of the open graph. */
export interface GizmoTarget {
  readonly node: string;
  readonly title: string;
  /** What the program calls the node that the params are of in the end: of a subgraph the one inside. */
  readonly program: string;
  /** Params by their names in the program. */
  readonly handles: Readonly<Partial<Record<Handle, string>>>;
  /** Names in the open graph, by those in the program. */
  readonly names: Readonly<Record<string, string>>;
}

/** `reason`: why there is no gizmo, as text for the user; null where nobody would expect one. */
export type GizmoTargetResult = { readonly target: GizmoTarget } | { readonly target: null; readonly reason: string | null };

const HANDLES: Readonly<Record<GizmoMode, readonly Handle[]>> = {
  move: ['position'],
  rotate: ['rotation', 'aim', 'azimuth', 'elevation'],
  scale: ['scale'],
};

const CANNOT: Readonly<Record<GizmoMode, string>> = { move: 'be moved', rotate: 'be turned', scale: 'change its size' };

/**
 * What a gizmo changes of the selected node: its own params, or those of the nearest node behind it that its objects go through, as a
 * model is moved by its Transform. `way`: nodes of the program to go through, where wires part.
 */
export function gizmoTargetOf(state: DocumentState, selected: string | null, way: readonly string[], mode: GizmoMode): GizmoTargetResult {
  if (selected === null) return { target: null, reason: null };
  let placesSomething = false;
  for (const id of nodesBehind(state, selected, way)) {
    const node = nodeOf(state, id);
    const definition = node && state.library.definition(node.type);
    if (!node || !definition) break;
    placesSomething ||= id === selected ? places(definition) : true;
    if (!HANDLES[mode].some((handle) => paramOf(definition, handle) !== undefined) || node.muted) continue;
    const driven = HANDLES[mode].map((handle) => drivenBy(state, id, node, definition, handle)).find((reason) => reason !== null);
    return driven === undefined ? { target: makeTarget(state, id, node, definition, mode) } : { target: null, reason: driven };
  }
  const title = state.library.definition(nodeOf(state, selected)?.type ?? '')?.title;
  if (!placesSomething || title === undefined) return { target: null, reason: null };
  return { target: null, reason: `${title} cannot ${CANNOT[mode]} by itself. Wire its objects through a Transform.` };
}

/** Whether a node has a place, or makes things that have one. */
function places(definition: NodeDefinition): boolean {
  return (
    Object.values(definition.params).some((param) => 'handle' in param && param.handle !== undefined) ||
    Object.values(definition.outputs).some(({ type }) => type === 'objects')
  );
}

function paramOf({ params }: NodeDefinition, handle: Handle): string | undefined {
  return Object.keys(params).find((name) => {
    const param = params[name];
    return param !== undefined && 'handle' in param && param.handle === handle && param.stage === 'uniform';
  });
}

function* nodesBehind(state: DocumentState, from: string, way: readonly string[]): Generator<string> {
  const { wires } = graphOf(state);
  const passed = new Set<string>();
  let at: string | undefined = from;
  while (at !== undefined && !passed.has(at)) {
    passed.add(at);
    yield at;
    const next: string[] = wires.flatMap(({ from: source, to }) => (source.node === at && carriesObjects(state, source) ? [to.node] : []));
    const onWay = next.find((node) => way.some((id) => isOnWay(id, nodePath(state, node))));
    at = onWay ?? next[0];
  }
}

/** A subgraph is on the way where something inside it is. */
export function isOnWay(id: string, path: string): boolean {
  return id === path || id.startsWith(`${path}/`);
}

function carriesObjects(state: DocumentState, { node, port }: { readonly node: string; readonly port: string }): boolean {
  const definition = state.library.definition(nodeOf(state, node)?.type ?? '');
  return getOwn(definition?.outputs ?? {}, port)?.type === 'objects';
}

/** Keyframes are no hindrance: as in the inspector, a change sets the key at the time that is shown. */
function drivenBy(state: DocumentState, id: string, node: GraphNode, definition: NodeDefinition, handle: Handle): string | null {
  const name = paramOf(definition, handle);
  const param = name === undefined ? undefined : definition.params[name];
  if (name === undefined || param === undefined) return null;
  const what = `“${param.label}” of ${definition.title}`;
  if (graphOf(state).wires.some(({ to }) => to.node === id && to.port === name)) return `${what} comes by a wire.`;
  const binding = getOwn(node.params, name);
  return binding !== undefined && 'expression' in binding ? `${what} follows an expression.` : null;
}

function makeTarget(state: DocumentState, node: string, { type }: GraphNode, definition: NodeDefinition, mode: GizmoMode): GizmoTarget {
  const handles: Partial<Record<Handle, string>> = {};
  const names: Record<string, string> = {};
  let program = nodePath(state, node);
  // Those of the mode first: what is inside another node of a subgraph is of another frame.
  const all = [...HANDLES[mode], ...Object.values(HANDLES).flat()];
  for (const handle of all) {
    const name = paramOf(definition, handle);
    if (name === undefined) continue;
    const inner = innermost(state.project, type, nodePath(state, node), name);
    if (Object.keys(names).length === 0) program = inner.program;
    if (inner.program !== program) continue;
    handles[handle] = inner.param;
    names[inner.param] = name;
  }
  return { node, title: definition.title, program, handles, names };
}

/** Follows a param into the subgraphs that show it. */
function innermost(project: Project, type: string, path: string, name: string): { readonly program: string; readonly param: string } {
  const subgraph = subgraphName(type);
  const graph = subgraph === null ? undefined : getOwn(project.graphs, subgraph);
  const exposed = graph?.exposed.inputs.find((input) => input.name === name);
  const node = exposed && getOwn(graph?.nodes ?? {}, exposed.node);
  if (!exposed || !node) return { program: path, param: name };
  return innermost(project, node.type, `${path}/${exposed.node}`, exposed.port);
}
