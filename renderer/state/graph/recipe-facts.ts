import type { Graph, PortAddress } from '../../../export/graph/project.ts';
import { getOwn } from '../../../export/graph/record.ts';
import type { NodeDefinition, NodeLibrary } from '../../../nodes/kit/definition.ts';
import type { WireType } from '../../../nodes/kit/wire-types.ts';

/** What adding a recipe must know about its nodes. */
export interface RecipeFacts {
  /** Names of the exposed inputs that take lights: all of the graph, or a new one. */
  readonly lit: readonly string[];
  /** Whether the objects that it gives already have their place in the room. */
  readonly isPlaced: boolean;
  /** Whether the layer that it gives is a shadow, which belongs below the objects that cast it. */
  readonly isShadow: boolean;
}

/** Types that place objects, beside those with a pose or with a param for the position. */
const PLACING: readonly string[] = ['objects/phantom', 'objects/place'];

/** Derives the facts from the exposed ports and from the nodes that give the outputs. */
export function factsOf(graph: Graph, library: NodeLibrary): RecipeFacts {
  const { inputs, outputs } = graph.exposed;
  const definitionOf = (node: string) => library.definition(getOwn(graph.nodes, node)?.type ?? '');
  const outputsOf = (type: WireType) => outputs.filter(({ node, port }) => getOwn(definitionOf(node)?.outputs ?? {}, port)?.type === type);
  /** Whether the test holds for the node or for one before it, along wires of this type. */
  const isBehind = (from: PortAddress, type: WireType, holds: (definition: NodeDefinition) => boolean): boolean => {
    const reached = new Set([from.node]);
    for (const node of reached) {
      const definition = definitionOf(node);
      if (definition && holds(definition)) return true;
      for (const wire of graph.wires)
        if (wire.to.node === node && getOwn(definition?.inputs ?? {}, wire.to.port)?.type === type) reached.add(wire.from.node);
    }
    return false;
  };
  const objects = outputsOf('objects');
  const layers = outputsOf('layer');
  return {
    lit: inputs.filter(({ node, port }) => getOwn(definitionOf(node)?.inputs ?? {}, port)?.type === 'lights').map(({ name }) => name),
    isPlaced: objects.length > 0 && objects.every((from) => isBehind(from, 'objects', places)),
    isShadow: layers.some((from) => isBehind(from, 'layer', ({ type }) => type === 'layer/shadow')),
  };
}

function places({ type, inputs, params }: NodeDefinition): boolean {
  const hasPose = Object.values(inputs).some((port) => port.type === 'pose');
  const hasPosition = Object.values(params).some((param) => 'handle' in param && param.handle === 'position');
  return hasPose || hasPosition || PLACING.includes(type);
}
