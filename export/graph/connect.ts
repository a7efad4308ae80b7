import type { NodeLibrary } from '../../nodes/kit/definition.ts';
import type { Diagnostic, DiagnosticCode } from '../../nodes/kit/diagnostics.ts';
import { conversion, WIRE_TYPES } from '../../nodes/kit/wire-types.ts';
import { breaksLoops, createFaceLookup, type FaceLookup, type InputFace, inputOf, type NodeFace, takesSeveral } from './library/faces.ts';
import { own } from './own.ts';
import type { Graph, PortAddress, Project, Wire } from './project.ts';
import { printAddress, sameAddress, sameWire } from './wires.ts';

export type Connectable =
  | { readonly ok: true; readonly conversion: 'same' | 'lossless' }
  | { readonly ok: false; readonly reason: Diagnostic };

/** Whether a wire may be drawn from an output to an input, and what it does; if not, why, in words for the person who draws it. */
export function canConnect(project: Project, library: NodeLibrary, graphName: string, from: PortAddress, to: PortAddress): Connectable {
  const graph = own(project.graphs, graphName);
  if (!graph) return refuse('SCR012', to, `There is no graph "${graphName}".`);
  const faceOf = createFaceLookup(project, library);
  const found = portsOfWire(graph, faceOf, { from, to });
  if (!found.ok) return found;
  if (graph.wires.some((wire) => sameWire(wire, { from, to }))) {
    return refuse('SCR016', to, `${printAddress(from)} is wired to ${printAddress(to)} already.`);
  }
  const bound = bindingAgainst(graph, to);
  if (bound !== null) return refuse('SCR019', to, bound);
  const outside = graph.exposed.inputs.find((port) => sameAddress(port, to));
  if (outside && !takesSeveral(found.input)) {
    return refuse('SCR016', to, `${printAddress(to)} is shown outside as “${outside.name}”, and takes its one wire there.`);
  }
  const path = pathBetween(graph, faceOf, to.node, from.node);
  if (path === null) return { ok: true, conversion: found.conversion };
  const loop = [from.node, ...path].join(' → ');
  return refuse('SCR014', to, `This wire would close a loop: ${loop}. A loop needs a delay in it: nothing can depend on itself at once.`);
}

/** Both ends of a wire that could be: the right way round, and of types that convert. */
export type WirePorts =
  | { readonly ok: true; readonly conversion: 'same' | 'lossless'; readonly input: InputFace }
  | { readonly ok: false; readonly reason: Diagnostic };

export function portsOfWire(graph: Graph, faceOf: FaceLookup, { from, to }: Wire): WirePorts {
  const fromNode = own(graph.nodes, from.node);
  if (!fromNode) return refuse('SCR012', from, `There is no node ${from.node}.`);
  const toNode = own(graph.nodes, to.node);
  if (!toNode) return refuse('SCR012', to, `There is no node ${to.node}.`);
  const fromFace = faceOf(fromNode.type);
  if (!fromFace) return refuse('SCR010', from, `${from.node} is of the unknown type ${fromNode.type}.`);
  const toFace = faceOf(toNode.type);
  if (!toFace) return refuse('SCR010', to, `${to.node} is of the unknown type ${toNode.type}.`);
  const output = own(fromFace.outputs, from.port);
  if (!output) return refuse('SCR012', from, noSuchPort(fromFace, from, 'output'));
  const input = inputOf(toFace, to.port);
  if (!input) {
    const fixed = own(toFace.params, to.port);
    if (!fixed) return refuse('SCR012', to, noSuchPort(toFace, to, 'input'));
    return refuse('SCR019', to, `${fixed.label} of ${to.node} cannot be wired: it is fixed while the project runs.`);
  }
  const converts = conversion(output.type, input.type);
  if (converts !== 'none') return { ok: true, conversion: converts, input };
  const given = WIRE_TYPES[output.type].label;
  const taken = WIRE_TYPES[input.type].label;
  return refuse('SCR013', to, `${printAddress(from)} gives “${given}”, but ${printAddress(to)} takes “${taken}”.`);
}

/** Why the param at `to` takes no wire as it is bound now, or null. */
export function bindingAgainst(graph: Graph, to: PortAddress): string | null {
  const node = own(graph.nodes, to.node);
  const binding = node && own(node.params, to.port);
  if (!binding || 'value' in binding || 'port' in binding) return null;
  const what = 'track' in binding ? 'a keyframe track' : 'an expression';
  return `${printAddress(to)} follows ${what}. Bind it to a value or a port before wiring it.`;
}

function refuse(code: DiagnosticCode, { node, port }: PortAddress, message: string): { readonly ok: false; readonly reason: Diagnostic } {
  return { ok: false, reason: { code, severity: 'error', nodeId: node, port, message } };
}

function noSuchPort(face: NodeFace, { node, port }: PortAddress, side: 'input' | 'output'): string {
  const names = side === 'output' ? Object.keys(face.outputs) : [...Object.keys(face.inputs), ...Object.keys(face.params)];
  const other = side === 'output' ? inputOf(face, port) !== undefined : own(face.outputs, port) !== undefined;
  if (other) return `${node}.${port} is an ${side === 'output' ? 'input' : 'output'}: a wire goes from an output to an input.`;
  return `${node} (${face.title}) has no ${side} "${port}"; it has ${names.length === 0 ? 'none' : names.join(', ')}.`;
}

/** Nodes on the way from one node to another within a frame, ends included, or null where there is no way. */
function pathBetween(graph: Graph, faceOf: FaceLookup, start: string, end: string): string[] | null {
  const waits = (id: string): boolean => {
    const node = own(graph.nodes, id);
    return node !== undefined && breaksLoops(node, faceOf);
  };
  if (waits(start)) return null;
  const cameFrom = new Map<string, string | null>([[start, null]]);
  const next = followers(graph.wires);
  for (const node of cameFrom.keys()) {
    if (node === end) return backwards(cameFrom, end);
    for (const follower of next.get(node) ?? []) if (!cameFrom.has(follower) && !waits(follower)) cameFrom.set(follower, node);
  }
  return null;
}

function backwards(cameFrom: ReadonlyMap<string, string | null>, end: string): string[] {
  const path: string[] = [];
  for (let node: string | null | undefined = end; node !== null && node !== undefined; node = cameFrom.get(node)) path.push(node);
  return path.reverse();
}

/** Kept for as long as the wires: a canvas asks about every port while a wire is dragged. */
const followersOf = new WeakMap<readonly Wire[], ReadonlyMap<string, readonly string[]>>();

function followers(wires: readonly Wire[]): ReadonlyMap<string, readonly string[]> {
  const known = followersOf.get(wires);
  if (known) return known;
  const made = new Map<string, string[]>();
  for (const { from, to } of wires) {
    const list = made.get(from.node);
    if (list) list.push(to.node);
    else made.set(from.node, [to.node]);
  }
  followersOf.set(wires, made);
  return made;
}
