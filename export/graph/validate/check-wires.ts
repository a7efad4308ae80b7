import { bindingAgainst, portsOfWire } from '../can-connect.ts';
import { breaksLoops, inputOf, takesSeveral } from '../library/node-interface.ts';
import type { ExposedPort, Wire } from '../project.ts';
import { getOwn } from '../record.ts';
import { findCycles } from '../topology.ts';
import { printAddress, printWire } from '../wires.ts';
import { type GraphCheck, reportError, reportUnfinished } from './context.ts';

/** Checks ends, types and number of all wires. */
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
  const ports = portsOfWire(check.graph, check.interfaceOf, wire);
  if (!ports.ok) {
    // Unknown types are reported once, at the node.
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
  const node = getOwn(check.graph.nodes, to.node);
  const nodeInterface = node && check.interfaceOf(node.type);
  const input = nodeInterface && inputOf(nodeInterface, to.port);
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
      reportError(check, 'SCR016', place, `${source} is connected to ${printAddress(to)} twice.`, 'Keep one of the two wires.');
    seen.add(source);
  }
}

/** Reports loops of wires without a delay. A muted delay does not count. */
export function checkCycles(check: GraphCheck): void {
  const { nodes, wires } = check.graph;
  const successors = new Map<string, string[]>(Object.keys(nodes).map((id) => [id, []]));
  for (const { from, to } of wires) {
    const node = getOwn(nodes, to.node);
    if (node && !breaksLoops(node, check.interfaceOf)) successors.get(from.node)?.push(to.node);
  }
  for (const cycle of findCycles(successors.keys(), (id) => successors.get(id) ?? [])) {
    const [first = ''] = cycle;
    const loop = [...cycle, first].join(' → ');
    reportError(check, 'SCR014', { nodeId: first }, `Wires form a loop: ${loop}.`, 'Delete one of its wires, or add a delay.');
  }
}

/** Required inputs must be connected or exposed. */
export function checkRequiredInputs(check: GraphCheck): void {
  const filled = new Set<string>();
  for (const { to } of check.graph.wires) filled.add(printAddress(to));
  for (const exposed of check.graph.exposed.inputs) filled.add(printAddress(exposed));
  for (const [nodeId, node] of Object.entries(check.graph.nodes)) {
    // A bypassed node reads only the input that passes through.
    if (node.muted === true) continue;
    for (const [port, { required, label }] of Object.entries(check.interfaceOf(node.type)?.inputs ?? {})) {
      if (!required || filled.has(printAddress({ node: nodeId, port }))) continue;
      const message = `Input “${label}” of ${nodeId} is not connected.`;
      reportUnfinished(check, 'SCR015', { nodeId, port }, message, 'Connect it, or mute or delete the node.');
    }
  }
}

/** Exposed ports must exist, and each name and port must occur once. */
export function checkExposed(check: GraphCheck): void {
  for (const side of ['inputs', 'outputs'] as const) {
    const names = new Set<string>();
    const ports = new Set<string>();
    for (const exposed of check.graph.exposed[side]) {
      const place = { nodeId: exposed.node, port: exposed.port };
      const address = printAddress(exposed);
      if (names.has(exposed.name)) reportError(check, 'SCR012', place, `Two ${side} are exposed as “${exposed.name}”.`);
      if (ports.has(address)) reportError(check, 'SCR012', place, `${address} is exposed twice.`);
      names.add(exposed.name);
      ports.add(address);
      if (!isThere(check, side, exposed)) {
        reportError(
          check,
          'SCR012',
          place,
          `“${exposed.name}” exposes ${address}, which does not exist among the ${side}.`,
          'Stop exposing it.',
        );
      } else if (side === 'inputs' && isFull(check, exposed)) {
        reportError(
          check,
          'SCR016',
          place,
          `${address} is exposed as “${exposed.name}” but connected inside.`,
          'Disconnect it inside the subgraph.',
        );
      }
    }
  }
}

/** Whether the port takes one wire and is connected inside. */
function isFull({ graph, interfaceOf }: GraphCheck, { node: id, port }: ExposedPort): boolean {
  const node = getOwn(graph.nodes, id);
  const nodeInterface = node && interfaceOf(node.type);
  const input = nodeInterface && inputOf(nodeInterface, port);
  if (!input || takesSeveral(input)) return false;
  return graph.wires.some(({ to }) => to.node === id && to.port === port);
}

function isThere({ graph, interfaceOf }: GraphCheck, side: 'inputs' | 'outputs', { node: id, port }: ExposedPort): boolean {
  const node = getOwn(graph.nodes, id);
  if (!node) return false;
  const nodeInterface = interfaceOf(node.type);
  // Unknown types are reported once, at the node.
  if (!nodeInterface) return true;
  return (
    getOwn<unknown>(nodeInterface[side], port) !== undefined || (side === 'inputs' && getOwn(nodeInterface.params, port) !== undefined)
  );
}
