import type { NodeDefinition, Renamed, SavedParams } from '../../../nodes/kit/definition.ts';
import { isObject } from '../json/shape-reader.ts';
import type { Graph, GraphNode, PortAddress } from '../project.ts';

type Names = Readonly<Record<string, Renamed>>;

/** Renames saved params and converts their numbers, also in tracks and expressions, to the new unit. Adds earlier defaults that have changed. */
export function renameParams(params: SavedParams, names: Names): SavedParams {
  const defaults = Object.entries(names).flatMap(([name, { to, was }]) =>
    was === undefined || Object.hasOwn(params, name) ? [] : [[to, was] as const],
  );
  const saved = Object.fromEntries(
    Object.entries(params).map(([name, saved]) => {
      const renamed = Object.hasOwn(names, name) ? names[name] : undefined;
      return renamed ? [renamed.to, scaled(saved, renamed.times)] : [name, saved];
    }),
  );
  return { ...saved, ...Object.fromEntries(defaults) };
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

/** The name of a port after all migrations from the node's version on. */
export function renamedPort(port: string, { version }: GraphNode, { renamed = [] }: NodeDefinition): Renamed {
  let now: Renamed = { to: port, times: 1 };
  for (const names of renamed.slice(version - 1)) {
    const next = Object.hasOwn(names, now.to) ? names[now.to] : undefined;
    if (next) now = { to: next.to, times: now.times * next.times };
  }
  return now;
}

/** Renames ports in the wires and exposed inputs of a graph. */
export function renamePorts(graph: Graph, portOf: (address: PortAddress) => string): Graph {
  const address = (at: PortAddress): PortAddress => ({ ...at, port: portOf(at) });
  return {
    ...graph,
    wires: graph.wires.map(({ from, to }) => ({ from, to: address(to) })),
    exposed: { ...graph.exposed, inputs: graph.exposed.inputs.map((input) => ({ ...input, ...address(input) })) },
  };
}
