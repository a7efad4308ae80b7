import type { LayerEncoding, NodeLibrary } from '../../nodes/kit/definition.ts';
import { subgraphName } from './document-names.ts';
import { type EncodedNode, neededEncoding, outputEncoding } from './layer-encoding.ts';
import { createInterfaceLookup } from './library/node-interface.ts';
import { boundValue } from './library/param-value.ts';
import type { Graph, GraphNode, PortAddress, Project, Wire } from './project.ts';
import { getOwn } from './record.ts';
import { topologicalOrder } from './topology.ts';
import { printAddress, sameAddress } from './wires.ts';

/** The encodings of the layers in a graph (ADR 38), for the canvas and for connecting. Create another after a change. */
export interface EncodingLookup {
  /** Encoding of an output; null if it is no layer. */
  outputOf(from: PortAddress): LayerEncoding | null;
  /** The encoding that the layer of a wire must be converted to; null if it fits. `among` is passed to `neededEncoding`. */
  conversionOf(wire: Wire, among: 'earlier' | 'others'): LayerEncoding | null;
}

/** Encodings of the layer outputs of a graph, by `printAddress`. */
type Encodings = ReadonlyMap<string, LayerEncoding>;

/** A graph with its wires by target, because large graphs have thousands. */
interface Inside {
  readonly graph: Graph;
  readonly sources: ReadonlyMap<string, PortAddress>;
  readonly encodings: Map<string, LayerEncoding>;
  readonly outside: Outside;
}

/** Encoding of the layer that a subgraph gets at an inner port from outside; null if it gets none. */
type Outside = (inner: PortAddress) => LayerEncoding | null;

/**
 * Creates the lookup. While a subgraph is edited, its exposed inputs count as not connected.
 *
 * @example
 * const lookup = createEncodingLookup(project, library, 'main');
 * lookup.outputOf({ node: 'video-a1b2', port: 'layer' }); // 'display'
 */
export function createEncodingLookup(project: Pick<Project, 'graphs'>, library: NodeLibrary, graphName: string): EncodingLookup {
  const interfaceOf = createInterfaceLookup(project, library);

  function inside(graph: Graph, outside: Outside): Inside {
    const followers = new Map<string, string[]>();
    const sources = new Map<string, PortAddress>();
    for (const { from, to } of graph.wires) {
      const list = followers.get(from.node);
      if (list) list.push(to.node);
      else followers.set(from.node, [to.node]);
      sources.set(printAddress(to), from);
    }
    const encodings = new Map<string, LayerEncoding>();
    const made: Inside = { graph, sources, encodings, outside };
    const { order, left } = topologicalOrder(Object.keys(graph.nodes), (id) => followers.get(id) ?? []);
    // Loops run through delays, which output display layers whatever they read.
    for (const id of [...order, ...left]) {
      const node = getOwn(graph.nodes, id);
      const encoded = node && encodedNode(made, id, node);
      if (!node || !encoded) continue;
      for (const [port, { type }] of Object.entries(encoded.definition.outputs)) {
        if (type === 'layer') encodings.set(printAddress({ node: id, port }), encodingOf(node, encoded, port));
      }
    }
    return made;
  }

  function encodedNode({ sources, encodings, outside }: Inside, id: string, node: GraphNode): EncodedNode | null {
    const definition = interfaceOf(node.type);
    if (!definition) return null;
    return {
      definition,
      paramValue: (name) => {
        const binding = getOwn(node.params, name);
        return (binding && boundValue(binding)) ?? getOwn(definition.params, name)?.default;
      },
      encodingAt: (port) => {
        const to = { node: id, port };
        const from = sources.get(printAddress(to));
        return from ? (encodings.get(printAddress(from)) ?? 'display') : outside(to);
      },
    };
  }

  function encodingOf(node: GraphNode, encoded: EncodedNode, port: string): LayerEncoding {
    const { definition, encodingAt } = encoded;
    if (node.muted === true) {
      const first = Object.keys(definition.inputs).find((name) => definition.inputs[name]?.type === 'layer');
      return (first !== undefined && encodingAt(first)) || 'display';
    }
    const inner = getOwn(project.graphs, subgraphName(node.type) ?? '');
    if (!inner) return outputEncoding(encoded, port);
    const exposed = inner.exposed.outputs.find(({ name }) => name === port);
    const outside: Outside = (to) => {
      const input = inner.exposed.inputs.find((candidate) => sameAddress(candidate, to));
      return input ? encodingAt(input.name) : null;
    };
    return (exposed && inside(inner, outside).encodings.get(printAddress(exposed))) ?? 'display';
  }

  const nothing: Outside = () => null;
  const graph = getOwn(project.graphs, graphName);
  const open = graph && inside(graph, nothing);
  const encodings: Encodings = open?.encodings ?? new Map();
  return {
    outputOf: (from) => encodings.get(printAddress(from)) ?? null,
    conversionOf: ({ from, to }, among) => {
      const given = encodings.get(printAddress(from));
      const node = open && getOwn(open.graph.nodes, to.node);
      const encoded = open && node && encodedNode(open, to.node, node);
      if (given === undefined || !encoded || getOwn(encoded.definition.inputs, to.port)?.type !== 'layer') return null;
      const needed = neededEncoding(encoded, to.port, among);
      return needed === given ? null : needed;
    },
  };
}
