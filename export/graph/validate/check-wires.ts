import { bindingAgainst, portsOfWire } from '../connect.ts';
import { breaksLoops, inputOf, takesSeveral } from '../library/faces.ts';
import { own } from '../own.ts';
import type { ExposedPort, Wire } from '../project.ts';
import { findCycles } from '../topology.ts';
import { printAddress, printWire } from '../wires.ts';
import { type GraphCheck, reportError, reportUnfinished } from './context.ts';

/** Ends, types and counts of all wires. */
export function checkWires(check: GraphCheck): void {
  const byTarget = new Map<string, Wire[]>();
  for (const wire of check.graph.wires) {
    const target = printAddress(wire.to);
    const wires = byTarget.get(target);
    if (wires) wires.push(wire);
    else byTarget.set(target, [wire]);
    checkEnds(check, wire);
  }
  for (const wires of byTarget.values()) if (wires.length > 1) checkSeveral(check, wires);
}

function checkEnds(check: GraphCheck, wire: Wire): void {
  const ports = portsOfWire(check.graph, check.faceOf, wire);
  if (!ports.ok) {
    // Unknown types are told once, at the node.
    if (ports.reason.code === 'SCR010') return;
    const { code, message, nodeId, port } = ports.reason;
    const place = { ...(nodeId === undefined ? {} : { nodeId }), ...(port === undefined ? {} : { port }) };
    reportError(check, code, place, `${message} The wire is ${printWire(wire)}.`, 'Delete the wire.');
    return;
  }
  const bound = bindingAgainst(check.graph, wire.to);
  if (bound !== null) reportError(check, 'SCR019', { nodeId: wire.to.node, port: wire.to.port }, bound);
}

function checkSeveral(check: GraphCheck, wires: readonly Wire[]): void {
  const [{ to }] = wires as [Wire];
  const node = own(check.graph.nodes, to.node);
  const face = node && check.faceOf(node.type);
  const input = face && inputOf(face, to.port);
  if (!input) return;
  const place = { nodeId: to.node, port: to.port };
  if (!takesSeveral(input)) {
    const sources = wires.map(({ from }) => printAddress(from)).join(', ');
    reportError(
      check,
      'SCR016',
      place,
      `${printAddress(to)} takes one wire but has ${wires.length}: from ${sources}.`,
      'Keep one of them.',
    );
    return;
  }
  const seen = new Set<string>();
  for (const { from } of wires) {
    const source = printAddress(from);
    if (seen.has(source))
      reportError(check, 'SCR016', place, `${source} is wired to ${printAddress(to)} twice.`, 'Keep one of the two wires.');
    seen.add(source);
  }
}

/** A loop has to wait somewhere for the next frame. A muted delay waits for nothing. */
export function checkCycles(check: GraphCheck): void {
  const { nodes, wires } = check.graph;
  const successors = new Map<string, string[]>(Object.keys(nodes).map((id) => [id, []]));
  for (const { from, to } of wires) {
    const node = own(nodes, to.node);
    if (node && !breaksLoops(node, check.faceOf)) successors.get(from.node)?.push(to.node);
  }
  for (const cycle of findCycles(successors.keys(), (id) => successors.get(id) ?? [])) {
    const [first = ''] = cycle;
    const loop = [...cycle, first].join(' → ');
    reportError(check, 'SCR014', { nodeId: first }, `Wires form a loop: ${loop}.`, 'Delete one of its wires, or put a delay into it.');
  }
}

/** Required ports: wired, or shown outside for others to wire. */
export function checkRequiredInputs(check: GraphCheck): void {
  const filled = new Set<string>();
  for (const { to } of check.graph.wires) filled.add(printAddress(to));
  for (const exposed of check.graph.exposed.inputs) filled.add(printAddress(exposed));
  for (const [nodeId, node] of Object.entries(check.graph.nodes)) {
    // A bypassed node reads nothing but what it lets through.
    if (node.muted === true) continue;
    for (const [port, { required, label }] of Object.entries(check.faceOf(node.type)?.inputs ?? {})) {
      if (!required || filled.has(printAddress({ node: nodeId, port }))) continue;
      const message = `${nodeId} needs a wire into “${label}”.`;
      reportUnfinished(check, 'SCR015', { nodeId, port }, message, 'Wire it, or mute or delete the node.');
    }
  }
}

/** What a subgraph shows outside: each name once, each port once, all of them there. */
export function checkExposed(check: GraphCheck): void {
  for (const side of ['inputs', 'outputs'] as const) {
    const names = new Set<string>();
    const ports = new Set<string>();
    for (const exposed of check.graph.exposed[side]) {
      const place = { nodeId: exposed.node, port: exposed.port };
      const address = printAddress(exposed);
      if (names.has(exposed.name)) reportError(check, 'SCR012', place, `Two ${side} are shown outside as “${exposed.name}”.`);
      if (ports.has(address)) reportError(check, 'SCR012', place, `${address} is shown outside twice.`);
      names.add(exposed.name);
      ports.add(address);
      if (!isThere(check, side, exposed)) {
        reportError(check, 'SCR012', place, `“${exposed.name}” stands for ${address}, but there are no such ${side}.`, 'Stop showing it.');
      } else if (side === 'inputs' && isFull(check, exposed)) {
        reportError(
          check,
          'SCR016',
          place,
          `${address} is shown outside as “${exposed.name}”, but wired inside.`,
          'Delete the wire inside.',
        );
      }
    }
  }
}

/** Takes one wire and has it already, so that one from outside would be the second. */
function isFull({ graph, faceOf }: GraphCheck, { node: id, port }: ExposedPort): boolean {
  const node = own(graph.nodes, id);
  const face = node && faceOf(node.type);
  const input = face && inputOf(face, port);
  if (!input || takesSeveral(input)) return false;
  return graph.wires.some(({ to }) => to.node === id && to.port === port);
}

function isThere({ graph, faceOf }: GraphCheck, side: 'inputs' | 'outputs', { node: id, port }: ExposedPort): boolean {
  const node = own(graph.nodes, id);
  if (!node) return false;
  const face = faceOf(node.type);
  // Unknown types are told once, at the node.
  if (!face) return true;
  return own<unknown>(face[side], port) !== undefined || (side === 'inputs' && own(face.params, port) !== undefined);
}
