import { subgraphName } from '../../../export/graph/document-names.ts';
import { replacedParams } from '../../../export/graph/library/replaced-params.ts';
import type { GraphNode, Project } from '../../../export/graph/project.ts';
import { getOwn } from '../../../export/graph/record.ts';
import type { NodeDefinition, ParamDefinition } from '../../../nodes/kit/definition.ts';
import { type Handle, type HandleAxes, IMAGE_HANDLES } from '../../../nodes/kit/handles.ts';
import type { GizmoMode } from '../../preview-protocol.ts';
import { type DocumentState, graphOf, nodeOf, titleOf } from './document.ts';
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
  /** The axes that the gizmo shows, as in `xz`. */
  readonly axes: string;
  /** The gizmo is in the image: it has all its parts in every mode. */
  readonly inImage?: true;
  /** The node has no transform: a drag first adds a Transform after it, whose params these are. */
  readonly adds?: true;
}

/** `reason`: why there is no gizmo, as text for the user; null if the selection has no objects to transform. */
export type GizmoTargetResult = { readonly target: GizmoTarget } | { readonly target: null; readonly reason: string | null };

/** Type of the node that a drag of an object without transform adds. */
export const TRANSFORM = 'objects/transform';

const HANDLES: Readonly<Record<GizmoMode, readonly Handle[]>> = {
  move: ['position', 'step', 'radius'],
  rotate: ['rotation', 'aim', 'azimuth', 'elevation', 'turn'],
  scale: ['scale'],
};

/** Handles that arrange the copies of a node. They do not move the nodes before it. */
const ARRANGING: ReadonlySet<Handle> = new Set(['step', 'radius', 'turn']);

const ALL_AXES = 'xyz';
/** The axes of handles that do not have all of them. */
const DEFAULT_AXES: Readonly<Partial<Record<Handle, string>>> = { radius: 'z', turn: 'y' };

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
  const inImage = imageTarget(state, selected);
  if (inImage) return inImage;
  let hasTransform = false;
  let hasMuted = false;
  for (const id of nodesBehind(state, selected, chain)) {
    const node = nodeOf(state, id);
    const definition = node && state.library.definition(node.type);
    if (!node || !definition) break;
    hasTransform ||= id === selected ? isPlaced(definition) : true;
    const own = handleParams(state, id, node, definition, HANDLES[mode]);
    const held = id === selected ? own : own.filter(({ handle }) => !ARRANGING.has(handle));
    if (held.length === 0) continue;
    if (node.muted) {
      hasMuted = true;
      continue;
    }
    const driven = held.map((param) => drivenBy(state, id, node, definition, param)).find((reason) => reason !== null);
    return driven === undefined ? { target: makeTarget(state, id, node, definition, held) } : { target: null, reason: driven };
  }
  const definition = state.library.definition(nodeOf(state, selected)?.type ?? '');
  if (!hasTransform || definition === undefined) return { target: null, reason: null };
  const added = hasMuted ? null : addedTarget(state, selected, mode);
  if (added) return { target: added };
  const fixed = `${titleOf(state, selected)} cannot be ${PARTICIPLES[mode]}.`;
  return { target: null, reason: hasObjects(definition) ? `${fixed} Connect its objects to a Transform.` : fixed };
}

/** The gizmo target of a node with handles in its image; null if it has none. */
function imageTarget(state: DocumentState, id: string): GizmoTargetResult | null {
  const node = nodeOf(state, id);
  const definition = node && state.library.definition(node.type);
  if (!node || !definition) return null;
  const all = handleParams(state, id, node, definition, IMAGE_HANDLES);
  if (all.length === 0) return null;
  if (node.muted) return { target: null, reason: `${titleOf(state, id)} is muted. Unmute it to use the gizmo.` };
  const free = all.filter((param) => drivenBy(state, id, node, definition, param) === null);
  // Without the point or the corners there is no place for the rest.
  const isPlace = ({ handle }: HandleParam) => handle === 'center' || handle === 'low' || handle === 'high';
  const fixed = free.length === 0 ? all[0] : all.find((param) => isPlace(param) && !free.includes(param));
  if (fixed) return { target: null, reason: drivenBy(state, id, node, definition, fixed) };
  // The sides of a shape lie along its angle, which the gizmo does not know while something else sets it.
  const turned = all.find((param) => param.handle === 'angle' && !free.includes(param));
  const held = turned ? free.filter(({ handle }) => handle !== 'size' && handle !== 'feather') : free;
  if (turned && held.length === 0) return { target: null, reason: drivenBy(state, id, node, definition, turned) };
  return { target: { ...makeTarget(state, id, node, definition, held), inImage: true } };
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
  const entries = Object.entries(definition.params);
  const params = HANDLES[mode].flatMap((handle) => {
    const [name] = entries.find(([, param]) => handleOf(param) === handle) ?? [];
    return name === undefined ? [] : [[handle, name] as const];
  });
  const names = Object.fromEntries(params.map(([, name]) => [name, name]));
  const handles = Object.fromEntries(params);
  return { node, title: definition.title, program: nodePath(state, node), handles, names, axes: ALL_AXES, adds: true };
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
  return { target: { node, title: `lamp ${lamp}`, program: nodePath(state, node), handles, names, axes: ALL_AXES } };
}

/** Whether a node has a transform or outputs objects. */
function isPlaced(definition: NodeDefinition): boolean {
  return Object.values(definition.params).some((param) => handleOf(param) !== undefined) || hasObjects(definition);
}

function hasObjects({ outputs }: NodeDefinition): boolean {
  return Object.values(outputs).some(({ type }) => type === 'objects');
}

function handleOf(param: ParamDefinition): Handle | undefined {
  return param.stage === 'uniform' && 'handle' in param ? param.handle : undefined;
}

/** Whether a node arranges copies by params with handles. */
export function arrangesCopies({ params }: Pick<NodeDefinition, 'params'>): boolean {
  return Object.values(params).some((param) => ARRANGING.has(handleOf(param) ?? 'position'));
}

/** A param with a handle, as its node is now. */
interface HandleParam {
  readonly handle: Handle;
  readonly name: string;
  readonly axes: string;
  readonly inner: Innermost;
}

/** The params of a node that have these handles, in the order of the handles. */
function handleParams(
  state: DocumentState,
  id: string,
  node: GraphNode,
  { params }: NodeDefinition,
  handles: readonly Handle[],
): HandleParam[] {
  return handles.flatMap((handle) => {
    for (const [name, param] of Object.entries(params)) {
      if (handleOf(param) !== handle) continue;
      const inner = innermost(state.project, node, nodePath(state, id), name);
      const by = 'handleAxes' in param ? param.handleAxes : undefined;
      const axes = by === undefined ? (DEFAULT_AXES[handle] ?? ALL_AXES) : axesNow(state, inner.node, by);
      if (axes !== undefined) return [{ handle, name, axes, inner }];
    }
    return [];
  });
}

/** The axes for the value that a choice has; undefined if there is no handle for it. */
function axesNow({ library }: DocumentState, node: GraphNode, { param, axes }: HandleAxes): string | undefined {
  const binding = getOwn(node.params, param);
  const definition = library.definition(node.type)?.params[param];
  const value = binding && 'value' in binding ? binding.value : definition && 'default' in definition ? definition.default : '';
  return getOwn(axes, String(value));
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
function drivenBy(state: DocumentState, id: string, node: GraphNode, definition: NodeDefinition, { name }: HandleParam): string | null {
  const what = `“${definition.params[name]?.label}” of ${titleOf(state, id)}`;
  const isConnected = (port: string) => graphOf(state).wires.some(({ to }) => to.node === id && to.port === port);
  if (isConnected(name)) return `${what} is connected. Disconnect it to use the gizmo.`;
  const input = definition.inputs[replacedParams(definition, isConnected).get(name) ?? ''];
  if (input) return `${what} comes from the input “${input.label}”. Disconnect it to use the gizmo.`;
  const binding = getOwn(node.params, name);
  return binding !== undefined && 'expression' in binding ? `${what} has an expression. Reset it to use the gizmo.` : null;
}

/** @param held The params that the gizmo changes, of which there is at least one. */
function makeTarget(
  state: DocumentState,
  id: string,
  node: GraphNode,
  definition: NodeDefinition,
  held: readonly HandleParam[],
): GizmoTarget {
  const handles: Partial<Record<Handle, string>> = {};
  const names: Record<string, string> = {};
  const [first] = held;
  const program = first?.inner.program ?? nodePath(state, id);
  // All handles must belong to the same node, because other nodes of a subgraph have other local spaces.
  for (const { handle, name, inner } of [...held, ...handleParams(state, id, node, definition, Object.values(HANDLES).flat())]) {
    if (inner.program !== program) continue;
    handles[handle] = inner.param;
    names[inner.param] = name;
  }
  const arranged = first && ARRANGING.has(first.handle) ? definition.params[first.name] : undefined;
  const name = titleOf(state, id);
  const title = arranged ? `“${arranged.label}” of ${name}` : name;
  return { node: id, title, program, handles, names, axes: first?.axes ?? ALL_AXES };
}

interface Innermost {
  readonly program: string;
  readonly param: string;
  readonly node: GraphNode;
}

/** Follows an exposed param into the subgraphs to the node that owns it. */
function innermost(project: Project, node: GraphNode, path: string, name: string): Innermost {
  const subgraph = subgraphName(node.type);
  const graph = subgraph === null ? undefined : getOwn(project.graphs, subgraph);
  const exposed = graph?.exposed.inputs.find((input) => input.name === name);
  const inside = exposed && getOwn(graph?.nodes ?? {}, exposed.node);
  if (!exposed || !inside) return { program: path, param: name, node };
  return innermost(project, inside, `${path}/${exposed.node}`, exposed.port);
}
