import { topologicalOrder } from '../../graph/topology.ts';
import { type FlatGraph, type FlatNode, portKey, type Source } from '../flat-graph.ts';
import type { Draft, DraftNode } from './flatten.ts';

/**
 * Takes muted nodes out: what was wired to an output of theirs gets what comes into their first wired input of the same type; all of
 * it where several wires go, the first where one does.
 */
export function bypassMuted({ nodes, shown }: Draft): Pick<FlatGraph, 'nodes' | 'standIns'> {
  const passed = passedSources(nodes);
  const flat = new Map<string, FlatNode>();
  for (const { id, definition, muted, inputs, bindings } of nodes.values()) {
    if (muted) continue;
    const cutOff = new Map<string, string>();
    const kept = new Map<string, readonly Source[]>();
    for (const [port, sources] of inputs) {
      const through = passThrough(sources, passed);
      const several = definition.inputs[port]?.multiple === true;
      if (through.length > 0) kept.set(port, several ? through : through.slice(0, 1));
      else cutOff.set(port, sources[0]?.node ?? '');
    }
    flat.set(id, { id, definition, inputs: kept, bindings, cutOff });
  }
  const standIns = new Map<string, Source>();
  for (const [key, sources] of [...passed, ...[...shown].map(([key, source]) => [key, [source]] as const)]) {
    const [first] = passThrough(sources, passed);
    if (first) standIns.set(key, first);
  }
  return { nodes: flat, standIns };
}

type Passed = ReadonlyMap<string, readonly Source[]>;

/** For each output of a muted node, what stands in for it. In topological order, so that a chain of muted nodes needs no recursion. */
function passedSources(nodes: ReadonlyMap<string, DraftNode>): Passed {
  const muted = [...nodes.values()].filter((node) => node.muted);
  const passed = new Map<string, readonly Source[]>();
  if (muted.length === 0) return passed;
  const followers = new Map<string, string[]>(muted.map(({ id }) => [id, []]));
  for (const node of muted) {
    for (const sources of node.inputs.values()) for (const source of sources) followers.get(source.node)?.push(node.id);
  }
  for (const id of topologicalOrder(followers.keys(), (node) => followers.get(node) ?? []).order) {
    const node = nodes.get(id);
    if (!node) continue;
    for (const port of Object.keys(node.definition.outputs)) {
      passed.set(portKey({ node: id, port }), passThrough(sourcesLike(node, port), passed));
    }
  }
  return passed;
}

/** What is wired to the first input of the output's type that has wires. */
function sourcesLike({ definition, inputs }: DraftNode, output: string): readonly Source[] {
  const type = definition.outputs[output]?.type;
  const input = Object.keys(definition.inputs).find((name) => definition.inputs[name]?.type === type && inputs.has(name));
  return input === undefined ? [] : (inputs.get(input) ?? []);
}

/** Each source once: two muted nodes side by side may let the same one through. */
function passThrough(sources: readonly Source[], passed: Passed): readonly Source[] {
  const through = new Map<string, Source>();
  for (const source of sources) {
    for (const end of passed.get(portKey(source)) ?? [source]) through.set(portKey(end), end);
  }
  return [...through.values()];
}
