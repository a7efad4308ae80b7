import { subgraphName } from '../../../export/graph/document-names.ts';
import type { GraphNode, Project } from '../../../export/graph/project.ts';
import { getOwn } from '../../../export/graph/record.ts';
import type { Handle, NodeDefinition } from '../../../nodes/kit/definition.ts';
import type { GizmoMode } from '../../preview-protocol.ts';
import { type DocumentState, graphOf, nodeOf } from './document.ts';
import { nodePath } from './layer-names.ts';

/** The params of one node of the open graph that a gizmo changes. */
export interface GizmoTarget {
  readonly node: string;
  readonly title: string;
  /** Id in the program of the node that owns the params. For a subgraph it is the node inside. */
  readonly program: string;
  /** Param names in the program, by handle. */
  readonly handles: Readonly<Partial<Record<Handle, string>>>;
  /** Param names in the open graph, by name in the program. */
  readonly names: Readonly<Record<string, string>>;
  /** The node has no transform: a drag first adds a Transform after it, whose params these are. */
  readonly adds?: true;
}

/** `reason`: why there is no gizmo, as text for the user; null if the selection has no objects to transform. */
export type GizmoTargetResult = { readonly target: GizmoTarget } | { readonly target: null; readonly reason: string | null };

/** Type of the node that a drag of an object without transform adds. */
export const TRANSFORM = 'objects/transform';

const HANDLES: Readonly<Record<GizmoMode, readonly Handle[]>> = {
  move: ['position'],
  rotate: ['rotation', 'aim', 'azimuth', 'elevation'],
  scale: ['scale'],
};

const PARTICIPLES: Readonly<Record<GizmoMode, string>> = { move: 'moved', rotate: 'rotated', scale: 'scaled' };

/**
 * The gizmo target of the selected node: the node itself, or the nearest node after it that transforms its objects, as a Transform
 * does for a model; without one, a Transform that a drag adds. If the wires branch, `chain` selects the branch: nodes of the program
 * that the clicked object passed through.
 */
export function gizmoTargetOf(
  state: DocumentState,
  selected: string | null,
  chain: readonly string[],
  mode: GizmoMode,
  lamp = 1,
): GizmoTargetResult {
  if (selected === null) return { target: null, reason: null };
  if (mode === 'rotate' && nodeOf(state, selected)?.type === LAMPS) return lampTarget(state, selected, lamp);
  let hasTransform = false;
  let hasMuted = false;
  for (const id of nodesBehind(state, selected, chain)) {
    const node = nodeOf(state, id);
    const definition = node && state.library.definition(node.type);
    if (!node || !definition) break;
    hasTransform ||= id === selected ? isPlaced(definition) : true;
    if (!HANDLES[mode].some((handle) => paramOf(definition, handle) !== undefined)) continue;
    if (node.muted) {
      hasMuted = true;
      continue;
    }
    const driven = HANDLES[mode].map((handle) => drivenBy(state, id, node, definition, handle)).find((reason) => reason !== null);
    return driven === undefined ? { target: makeTarget(state, id, node, definition, mode) } : { target: null, reason: driven };
  }
  const title = state.library.definition(nodeOf(state, selected)?.type ?? '')?.title;
  if (!hasTransform || title === undefined) return { target: null, reason: null };
  const added = hasMuted ? null : addedTarget(state, selected, mode);
  if (added) return { target: added };
  return { target: null, reason: `${title} cannot be ${PARTICIPLES[mode]}. Connect its objects to a Transform.` };
}

/** Categories of nodes that create virtual objects. The room decides where those of `world/` are. */
const CREATORS = /^(source|objects)\//;
/** Category of nodes that move objects by simulation. The pointer throws these. */
const SIMULATION = /^physics\//;

/** A Transform that a drag adds after a node that creates objects; null if they are not connected, or if a simulation moves them. */
function addedTarget(state: DocumentState, node: string, mode: GizmoMode): GizmoTarget | null {
  const typeOf = (id: string) => nodeOf(state, id)?.type ?? '';
  const definition = state.library.definition(TRANSFORM);
  const inputs = Object.values(state.library.definition(typeOf(node))?.inputs ?? {});
  if (!definition || !CREATORS.test(typeOf(node)) || inputs.some(({ type }) => type === 'objects')) return null;
  if (!graphOf(state).wires.some(({ from }) => from.node === node && carriesObjects(state, from))) return null;
  if ([...nodesBehind(state, node, [])].some((id) => SIMULATION.test(typeOf(id)))) return null;
  const params = HANDLES[mode].flatMap((handle) => {
    const name = paramOf(definition, handle);
    return name === undefined ? [] : [[handle, name] as const];
  });
  const names = Object.fromEntries(params.map(([, name]) => [name, name]));
  return { node, title: definition.title, program: nodePath(state, node), handles: Object.fromEntries(params), names, adds: true };
}

const LAMPS = 'light/from-panorama';

/** The gizmo target for a pinned lamp of a Lights from panorama node: the two params that hold the azimuth and elevation of the lamp. */
function lampTarget(state: DocumentState, node: string, lamp: number): GizmoTargetResult {
  const params = nodeOf(state, node)?.params ?? {};
  const pinned = getOwn(params, `lamp${lamp}Pinned`);
  if (!pinned || !('value' in pinned) || pinned.value !== true) {
    return { target: null, reason: `Lamp ${lamp} is not pinned. Pin it in the inspector to rotate it.` };
  }
  const handles = { azimuth: `lamp${lamp}AzimuthRad`, elevation: `lamp${lamp}ElevationRad` };
  for (const name of Object.values(handles)) {
    const binding = getOwn(params, name);
    const isWired = graphOf(state).wires.some(({ to }) => to.node === node && to.port === name);
    if (isWired || (binding && 'expression' in binding)) {
      return { target: null, reason: `The direction of lamp ${lamp} is connected. Reset it to use the gizmo.` };
    }
  }
  const names = Object.fromEntries(Object.values(handles).map((name) => [name, name]));
  return { target: { node, title: `lamp ${lamp}`, program: nodePath(state, node), handles, names } };
}

/** Whether a node has a transform or outputs objects. */
function isPlaced(definition: NodeDefinition): boolean {
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

function* nodesBehind(state: DocumentState, from: string, chain: readonly string[]): Generator<string> {
  const { wires } = graphOf(state);
  const passed = new Set<string>();
  let at: string | undefined = from;
  while (at !== undefined && !passed.has(at)) {
    passed.add(at);
    yield at;
    const next: string[] = wires.flatMap(({ from: source, to }) => (source.node === at && carriesObjects(state, source) ? [to.node] : []));
    const inChain = next.find((node) => chain.some((id) => isWithin(id, nodePath(state, node))));
    at = inChain ?? next[0];
  }
}

/**
 * Whether a node is another node or lies inside it.
 *
 * @param id Path of a node of the program, with the subgraphs that it lies in.
 * @param path Path of a node or of an instance of a subgraph.
 */
export function isWithin(id: string, path: string): boolean {
  return id === path || id.startsWith(`${path}/`);
}

/** Whether a wire from this output carries objects. */
export function carriesObjects(state: DocumentState, { node, port }: { readonly node: string; readonly port: string }): boolean {
  const definition = state.library.definition(nodeOf(state, node)?.type ?? '');
  return getOwn(definition?.outputs ?? {}, port)?.type === 'objects';
}

/**
 * Why the gizmo cannot set the param of a handle; null if it can. Keyframes are allowed: as in the inspector, an edit sets the
 * keyframe at the current time.
 */
function drivenBy(state: DocumentState, id: string, node: GraphNode, definition: NodeDefinition, handle: Handle): string | null {
  const name = paramOf(definition, handle);
  const param = name === undefined ? undefined : definition.params[name];
  if (name === undefined || param === undefined) return null;
  const what = `“${param.label}” of ${definition.title}`;
  if (graphOf(state).wires.some(({ to }) => to.node === id && to.port === name))
    return `${what} is connected. Disconnect it to use the gizmo.`;
  const binding = getOwn(node.params, name);
  return binding !== undefined && 'expression' in binding ? `${what} has an expression. Reset it to use the gizmo.` : null;
}

function makeTarget(state: DocumentState, node: string, { type }: GraphNode, definition: NodeDefinition, mode: GizmoMode): GizmoTarget {
  const handles: Partial<Record<Handle, string>> = {};
  const names: Record<string, string> = {};
  let program = nodePath(state, node);
  // Handles of the mode come first. All handles must belong to the same node, because other nodes of a subgraph have other local
  // spaces.
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

/** Follows an exposed param into the subgraphs to the node that owns it. */
function innermost(project: Project, type: string, path: string, name: string): { readonly program: string; readonly param: string } {
  const subgraph = subgraphName(type);
  const graph = subgraph === null ? undefined : getOwn(project.graphs, subgraph);
  const exposed = graph?.exposed.inputs.find((input) => input.name === name);
  const node = exposed && getOwn(graph?.nodes ?? {}, exposed.node);
  if (!exposed || !node) return { program: path, param: name };
  return innermost(project, node.type, `${path}/${exposed.node}`, exposed.port);
}
