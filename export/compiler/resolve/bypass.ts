import { topologicalOrder } from '../../graph/topology.ts';
import { type FlatGraph, type FlatNode, portKey, type Source } from '../flat-graph.ts';
import { dropReplaced } from './drop-replaced.ts';
import type { Draft, DraftNode } from './flatten.ts';

/**
 * Removes muted nodes. A wire from an output of a muted node gets the source of its first connected input of the same type: all sources at
 * ports that take several wires, else the first.
 */
export function bypassMuted({ nodes, shown }: Draft): Pick<FlatGraph, 'nodes' | 'replacements'> {
  const passed = passedSources(nodes);
  const flat = new Map<string, FlatNode>();
  for (const { id, definition, muted, unfused, inputs, bindings } of nodes.values()) {
    if (muted) continue;
    const muteBlocked = new Map<string, string>();
    const kept = new Map<string, readonly Source[]>();
    for (const [port, sources] of inputs) {
      const through = passThrough(sources, passed);
      const several = definition.inputs[port]?.multiple === true;
      if (through.length > 0) kept.set(port, several ? through : through.slice(0, 1));
      else muteBlocked.set(port, sources[0]?.node ?? '');
    }
    flat.set(id, dropReplaced({ id, definition, unfused, inputs: kept, bindings, muteBlocked }));
  }
  const replacements = new Map<string, Source>();
  for (const [key, sources] of [...passed, ...[...shown].map(([key, source]) => [key, [source]] as const)]) {
    const [first] = passThrough(sources, passed);
    if (first) replacements.set(key, first);
  }
  return { nodes: flat, replacements };
}

type Passed = ReadonlyMap<string, readonly Source[]>;

/**
 * Finds the replacement of each output of a muted node. Muted nodes are visited in topological order, so that chains of muted nodes need no
 * recursion.
 */
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

/** The sources of the first connected input that has the type of the output. */
function sourcesLike({ definition, inputs }: DraftNode, output: string): readonly Source[] {
  const type = definition.outputs[output]?.type;
  const input = Object.keys(definition.inputs).find((name) => definition.inputs[name]?.type === type && inputs.has(name));
  return input === undefined ? [] : (inputs.get(input) ?? []);
}

/**
 * Replaces sources at muted nodes by what those pass through. Each result is listed once, because two muted nodes may pass the same source
 * through.
 */
function passThrough(sources: readonly Source[], passed: Passed): readonly Source[] {
  const through = new Map<string, Source>();
  for (const source of sources) {
    for (const end of passed.get(portKey(source)) ?? [source]) through.set(portKey(end), end);
  }
  return [...through.values()];
}
