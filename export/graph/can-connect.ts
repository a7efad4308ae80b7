import type { NodeLibrary } from '../../nodes/kit/definition.ts';
import type { Diagnostic, DiagnosticCode } from '../../nodes/kit/diagnostics.ts';
import { conversion, WIRE_TYPES } from '../../nodes/kit/wire-types.ts';
import {
  breaksLoops,
  type ConnectableInput,
  createInterfaceLookup,
  type InterfaceLookup,
  inputOf,
  type NodeInterface,
  takesSeveral,
} from './library/node-interface.ts';
import type { Graph, PortAddress, Project, Wire } from './project.ts';
import { getOwn } from './record.ts';
import { printAddress, sameAddress, sameWire } from './wires.ts';

export type Connectable =
  | { readonly ok: true; readonly conversion: 'same' | 'lossless' }
  | { readonly ok: false; readonly reason: Diagnostic };

/**
 * Checks whether a wire can connect an output to an input: both exist, their types convert, the input has room, and no loop closes.
 *
 * @param graphName The graph that holds both nodes.
 * @param from The output.
 * @param to The input, or a param that a wire can drive.
 * @returns How the wire converts its values, or the reason why it cannot be connected as a diagnostic.
 * @example
 * const result = canConnect(project, library, 'main', { node: 'video-a1b2', port: 'layer' }, { node: 'sepia-k7q2', port: 'inputImage' });
 * if (!result.ok) show(result.reason.message);
 */
export function canConnect(project: Project, library: NodeLibrary, graphName: string, from: PortAddress, to: PortAddress): Connectable {
  const graph = getOwn(project.graphs, graphName);
  if (!graph) return refuse('SCR012', to, `Graph “${graphName}” does not exist.`);
  const interfaceOf = createInterfaceLookup(project, library);
  const found = portsOfWire(graph, interfaceOf, { from, to });
  if (!found.ok) return found;
  if (graph.wires.some((wire) => sameWire(wire, { from, to }))) {
    return refuse('SCR016', to, `${printAddress(from)} is already connected to ${printAddress(to)}.`);
  }
  const bound = bindingAgainst(graph, to);
  if (bound !== null) return refuse('SCR019', to, bound);
  const outside = graph.exposed.inputs.find((port) => sameAddress(port, to));
  if (outside && !takesSeveral(found.input)) {
    return refuse('SCR016', to, `${printAddress(to)} is exposed as “${outside.name}”, so its one wire connects there.`);
  }
  const path = pathBetween(graph, interfaceOf, to.node, from.node);
  if (path === null) return { ok: true, conversion: found.conversion };
  const loop = [from.node, ...path].join(' → ');
  return refuse('SCR014', to, `This wire would close a loop: ${loop}. Add a delay to the loop.`);
}

/** The ports at both ends of a wire, or why they cannot be connected. */
export type WirePorts =
  | { readonly ok: true; readonly conversion: 'same' | 'lossless'; readonly input: ConnectableInput }
  | { readonly ok: false; readonly reason: Diagnostic };

/**
 * Looks up the ports of a wire without checking loops or existing wires.
 *
 * @returns The output, the input and the conversion between their types, or the problem as a diagnostic.
 */
export function portsOfWire(graph: Graph, interfaceOf: InterfaceLookup, { from, to }: Wire): WirePorts {
  const fromNode = getOwn(graph.nodes, from.node);
  if (!fromNode) return refuse('SCR012', from, `Node ${from.node} does not exist.`);
  const toNode = getOwn(graph.nodes, to.node);
  if (!toNode) return refuse('SCR012', to, `Node ${to.node} does not exist.`);
  const fromInterface = interfaceOf(fromNode.type);
  if (!fromInterface) return refuse('SCR010', from, `${from.node} has the unknown type ${fromNode.type}.`);
  const toInterface = interfaceOf(toNode.type);
  if (!toInterface) return refuse('SCR010', to, `${to.node} has the unknown type ${toNode.type}.`);
  const output = getOwn(fromInterface.outputs, from.port);
  if (!output) return refuse('SCR012', from, noSuchPort(fromInterface, from, 'output'));
  const input = inputOf(toInterface, to.port);
  if (!input) {
    const fixed = getOwn(toInterface.params, to.port);
    if (!fixed) return refuse('SCR012', to, noSuchPort(toInterface, to, 'input'));
    return refuse('SCR019', to, `“${fixed.label}” of ${to.node} cannot be connected: it is fixed while the project runs.`);
  }
  const converts = conversion(output.type, input.type);
  if (converts !== 'none') return { ok: true, conversion: converts, input };
  const given = WIRE_TYPES[output.type].label;
  const taken = WIRE_TYPES[input.type].label;
  return refuse('SCR013', to, `${printAddress(from)} outputs “${given}”, but ${printAddress(to)} takes “${taken}”.`);
}

/** @returns Why the current binding of the param at `to` excludes a wire, or null if it allows one. */
export function bindingAgainst(graph: Graph, to: PortAddress): string | null {
  const node = getOwn(graph.nodes, to.node);
  const binding = node && getOwn(node.params, to.port);
  if (!binding || 'value' in binding || 'port' in binding) return null;
  const what = 'track' in binding ? 'a keyframe track' : 'an expression';
  return `${printAddress(to)} follows ${what}. Bind it to a value or a port before you connect it.`;
}

function refuse(code: DiagnosticCode, { node, port }: PortAddress, message: string): { readonly ok: false; readonly reason: Diagnostic } {
  return { ok: false, reason: { code, severity: 'error', nodeId: node, port, message } };
}

function noSuchPort(nodeInterface: NodeInterface, { node, port }: PortAddress, side: 'input' | 'output'): string {
  const names =
    side === 'output' ? Object.keys(nodeInterface.outputs) : [...Object.keys(nodeInterface.inputs), ...Object.keys(nodeInterface.params)];
  const other = side === 'output' ? inputOf(nodeInterface, port) !== undefined : getOwn(nodeInterface.outputs, port) !== undefined;
  if (other) return `${node}.${port} is an ${side === 'output' ? 'input' : 'output'}: a wire goes from an output to an input.`;
  return `${node} (${nodeInterface.title}) has no ${side} “${port}”; it has ${names.length === 0 ? 'none' : names.join(', ')}.`;
}

/** @returns The nodes of a path from `start` to `end` within one frame, ends included, or null if there is none. */
function pathBetween(graph: Graph, interfaceOf: InterfaceLookup, start: string, end: string): string[] | null {
  const waits = (id: string): boolean => {
    const node = getOwn(graph.nodes, id);
    return node !== undefined && breaksLoops(node, interfaceOf);
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

/** Successors of each node, cached per list of wires, because a canvas checks every port while a wire is dragged. */
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
