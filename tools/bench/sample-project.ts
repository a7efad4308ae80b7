import { newProject } from '../../export/graph/new-project.ts';
import { type GraphNode, MAIN_GRAPH, type Project, type Wire } from '../../export/graph/project.ts';
import { DEFINITIONS, SHADERS } from '../../nodes/generated/definitions.gen.ts';
import type { NodeDefinition, NodeLibrary } from '../../nodes/kit/definition.ts';

const byType = new Map<string, NodeDefinition>(DEFINITIONS.map((definition) => [definition.type, definition]));

export const LIBRARY: NodeLibrary = {
  definition: (type) => byType.get(type),
  shader: (name) => SHADERS[name],
  types: () => byType.keys(),
};

/** Typical filters: pointwise ones, one with a neighborhood, and one with two passes. */
const FILTERS = ['filter/sepia', 'filter/threshold', 'filter/sobel-edges', 'filter/color-temperature', 'filter/gaussian-blur'];

/**
 * A camera feed through a chain of filters to the Output.
 *
 * @param nodeCount Total number of nodes, at least two.
 */
export function chainProject(nodeCount: number): Project {
  const nodes: Record<string, GraphNode> = { 'video-x0': { type: 'source/camera-video', version: 1, params: {} } };
  const wires: Wire[] = [];
  let from = { node: 'video-x0', port: 'layer' };
  for (let i = 1; i < nodeCount - 1; i++) {
    const node = `filter-x${i}`;
    nodes[node] = { type: FILTERS[i % FILTERS.length] ?? '', version: 1, params: {} };
    wires.push({ from, to: { node, port: 'inputImage' } });
    from = { node, port: 'layer' };
  }
  nodes['screen-x0'] = { type: 'output/screen', version: 1, params: {} };
  wires.push({ from, to: { node: 'screen-x0', port: 'layer' } });
  return { ...newProject('Chain'), graphs: { [MAIN_GRAPH]: { nodes, wires, exposed: { inputs: [], outputs: [] } } } };
}
