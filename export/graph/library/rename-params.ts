import type { NodeDefinition, Renamed, SavedParams } from '../../../nodes/kit/definition.ts';
import { isObject } from '../json/shape-reader.ts';
import type { Graph, GraphNode, PortAddress } from '../project.ts';

type Names = Readonly<Record<string, Renamed>>;

/** Saved params under their new names, with numbers, those of tracks and expressions too, in their new measure. */
export function renameParams(params: SavedParams, names: Names): SavedParams {
  return Object.fromEntries(
    Object.entries(params).map(([name, saved]) => {
      const renamed = Object.hasOwn(names, name) ? names[name] : undefined;
      return renamed ? [renamed.to, scaled(saved, renamed.times)] : [name, saved];
    }),
  );
}

function scaled(saved: unknown, times: number): unknown {
  if (times === 1) return saved;
  if (typeof saved === 'number') return saved * times;
  if (Array.isArray(saved)) return saved.map((item) => scaled(item, times));
  if (!isObject(saved)) return saved;
  if (typeof saved.expression === 'string') return { expression: `(${saved.expression}) * ${times}` };
  if ('port' in saved) return { port: scaled(saved.port, times) };
  const { track } = saved;
  if (!isObject(track) || !Array.isArray(track.keys)) return saved;
  const keys = track.keys.map((key: unknown) => (isObject(key) ? { ...key, value: scaled(key.value, times) } : key));
  return { track: { ...track, keys } };
}

/** What all steps from the node's version on make of a port's name. */
export function renamedPort(port: string, { version }: GraphNode, { renamed = [] }: NodeDefinition): Renamed {
  let now: Renamed = { to: port, times: 1 };
  for (const names of renamed.slice(version - 1)) {
    const next = Object.hasOwn(names, now.to) ? names[now.to] : undefined;
    if (next) now = { to: next.to, times: now.times * next.times };
  }
  return now;
}

/** The graph with its wires and what it shows of its nodes' inputs under the ports' new names. */
export function renamePorts(graph: Graph, portOf: (address: PortAddress) => string): Graph {
  const address = (at: PortAddress): PortAddress => ({ ...at, port: portOf(at) });
  return {
    ...graph,
    wires: graph.wires.map(({ from, to }) => ({ from, to: address(to) })),
    exposed: { ...graph.exposed, inputs: graph.exposed.inputs.map((input) => ({ ...input, ...address(input) })) },
  };
}
