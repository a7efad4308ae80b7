import { subgraphType } from '../../../export/graph/document-names.ts';
import type { PortAddress } from '../../../export/graph/project.ts';
import { getOwn } from '../../../export/graph/record.ts';
import { sameAddress } from '../../../export/graph/wires.ts';
import type { NodeDefinition } from '../../../nodes/kit/definition.ts';
import { type DocumentState, graphOf, nodeOf } from './document.ts';
import { nodeTitle } from './node-title.ts';

/** The first output of type `layer`; null if there is none. */
export function layerPortOf(definition: NodeDefinition | undefined): string | null {
  return Object.entries(definition?.outputs ?? {}).find(([, { type }]) => type === 'layer')?.[0] ?? null;
}

/** Name of a layer of the open graph in the program: `outer/inner.port`. For a subgraph with several instances, that of the first. */
export function layerName(state: Pick<DocumentState, 'project' | 'graph' | 'trail'>, node: string, port: string): string {
  return `${nodePath(state, node)}.${port}`;
}

/** Id of a node of the open graph in the program: `outer/inner`. */
export function nodePath(state: Pick<DocumentState, 'project' | 'graph' | 'trail'>, node: string): string {
  const names = [...state.trail, state.graph];
  const path = names.slice(1).map((inner, depth) => {
    const nodes = getOwn(state.project.graphs, names[depth] ?? '')?.nodes ?? {};
    return Object.keys(nodes).find((id) => nodes[id]?.type === subgraphType(inner)) ?? inner;
  });
  return [...path, node].join('/');
}

/** Label of a layer: the name of its node, and the port if the node outputs several layers. */
export function layerTitle(state: DocumentState, layer: string | null): string {
  if (layer === null) return 'Output';
  const id = layer.slice(layer.lastIndexOf('/') + 1, layer.lastIndexOf('.'));
  const port = layer.slice(layer.lastIndexOf('.') + 1);
  for (const graph of Object.values(state.project.graphs)) {
    const node = getOwn(graph.nodes, id);
    if (!node) continue;
    const title = nodeTitle(node, state.library, state.project.assets);
    const { outputs = {} } = state.library.definition(node.type) ?? {};
    const several = Object.values(outputs).filter(({ type }) => type === 'layer').length > 1;
    return several ? `${title} · ${getOwn(outputs, port)?.label ?? port}` : title;
  }
  return id;
}

/** The layer at a port: that of an output, or that of the output connected to an input. Null if there is none. */
export function layerAt(state: DocumentState, { node, port }: PortAddress, side: 'input' | 'output'): string | null {
  const from = side === 'output' ? { node, port } : graphOf(state).wires.find(({ to }) => sameAddress(to, { node, port }))?.from;
  const definition = from && state.library.definition(nodeOf(state, from.node)?.type ?? '');
  return from && getOwn(definition?.outputs ?? {}, from.port)?.type === 'layer' ? layerName(state, from.node, from.port) : null;
}
