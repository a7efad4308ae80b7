import type { PortAddress, Wire } from './project.ts';
import { compareText } from './record.ts';

const ID = '[a-z0-9-]+';
const PORT = '[A-Za-z0-9_]+';
const WIRE = new RegExp(`^(${ID})\\.(${PORT}) -> (${ID})\\.(${PORT})$`);

/**
 * Parses `video-a1b2.layer -> sepia-k7q2.inputImage`; returns null if the text is not a wire.
 *
 * @example
 * parseWire('video-a1b2.layer -> sepia-k7q2.inputImage')?.to; // { node: 'sepia-k7q2', port: 'inputImage' }
 * parseWire('video-a1b2.layer'); // null
 */
export function parseWire(text: string): Wire | null {
  const [, fromNode, fromPort, toNode, toPort] = WIRE.exec(text) ?? [];
  if (fromNode === undefined || fromPort === undefined || toNode === undefined || toPort === undefined) return null;
  return { from: { node: fromNode, port: fromPort }, to: { node: toNode, port: toPort } };
}

/**
 * Prints a wire as `video-a1b2.layer -> sepia-k7q2.inputImage`, as in `project.scrim.json`.
 *
 * @example
 * printWire({ from: { node: 'video-a1b2', port: 'layer' }, to: { node: 'sepia-k7q2', port: 'inputImage' } });
 * // 'video-a1b2.layer -> sepia-k7q2.inputImage'
 */
export function printWire({ from, to }: Wire): string {
  return `${printAddress(from)} -> ${printAddress(to)}`;
}

export function printAddress({ node, port }: PortAddress): string {
  return `${node}.${port}`;
}

/**
 * Whether both addresses are of the same port of the same node.
 *
 * @example
 * sameAddress({ node: 'sepia-k7q2', port: 'layer' }, { node: 'sepia-k7q2', port: 'inputImage' }); // false
 */
export function sameAddress(a: PortAddress, b: PortAddress): boolean {
  return a.node === b.node && a.port === b.port;
}

export function sameWire(a: Wire, b: Wire): boolean {
  return sameAddress(a.from, b.from) && sameAddress(a.to, b.to);
}

/** Sorts wires in document order: by target node and port, keeping their order within one port. */
export function sortWires(wires: readonly Wire[]): readonly Wire[] {
  return [...wires].sort(compareTargets);
}

/** Adds a wire as the last one of its port. */
export function insertWire(wires: readonly Wire[], wire: Wire): readonly Wire[] {
  let end = wires.length;
  while (end > 0 && compareTargets(wires[end - 1] as Wire, wire) > 0) end--;
  return [...wires.slice(0, end), wire, ...wires.slice(end)];
}

function compareTargets(a: Wire, b: Wire): number {
  return compareText(a.to.node, b.to.node) || compareText(a.to.port, b.to.port);
}
