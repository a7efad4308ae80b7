import {
  type InputPort,
  type NodeDefinition,
  type NodeLibrary,
  type OutputPort,
  type ParamDefinition,
  paramWireType,
} from '../../../nodes/kit/definition.ts';
import type { ValueType, WireType } from '../../../nodes/kit/wire-types.ts';
import { subgraphName } from '../names.ts';
import { own } from '../own.ts';
import type { Graph, GraphNode, PortAddress, Project } from '../project.ts';
import { boundValue, misfit } from './param-value.ts';

/** What the graph around a node sees of it: for a library's node its definition, for a subgraph what it exposes. */
export type NodeFace = Pick<NodeDefinition, 'type' | 'version' | 'title' | 'doc' | 'inputs' | 'outputs' | 'params' | 'delay'>;

/** Looks up node types of the library and `graph/NAME`; undefined where there is none. Remembers what it made. */
export type FaceLookup = (type: string) => NodeFace | undefined;

export function createFaceLookup(project: Pick<Project, 'graphs'>, library: NodeLibrary): FaceLookup {
  const graphFaces = new Map<string, NodeFace | undefined>();
  return (type) => {
    const name = subgraphName(type);
    if (name === null) return library.definition(type);
    if (!graphFaces.has(type)) {
      const graph = own(project.graphs, name);
      graphFaces.set(type, graph && faceOfGraph(project, library, name, graph));
    }
    return graphFaces.get(type);
  };
}

/** What a wire can go into: a port proper, or a param that can be wired. */
export type InputFace =
  | { readonly kind: 'port'; readonly type: WireType; readonly port: InputPort }
  | { readonly kind: 'param'; readonly type: ValueType; readonly param: ParamDefinition };

export function inputOf(face: NodeFace, name: string): InputFace | undefined {
  const port = own(face.inputs, name);
  if (port) return { kind: 'port', type: port.type, port };
  const param = own(face.params, name);
  const type = param && paramWireType(param);
  return param && type && { kind: 'param', type, param };
}

/**
 * Whether wires into the node may close a loop, because it gives what it took in an earlier frame. A subgraph never does, whatever
 * is in it: outside, nobody sees which of its ports wait.
 */
export function breaksLoops({ type, muted }: GraphNode, faceOf: FaceLookup): boolean {
  return muted !== true && faceOf(type)?.delay === true;
}

export function takesSeveral(input: InputFace): boolean {
  return input.kind === 'port' && input.port.multiple === true;
}

function faceOfGraph(project: Pick<Project, 'graphs'>, library: NodeLibrary, name: string, graph: Graph): NodeFace {
  const inputs: Record<string, InputPort> = {};
  const outputs: Record<string, OutputPort> = {};
  const params: Record<string, ParamDefinition> = {};
  for (const { name: outside, node, port } of graph.exposed.inputs) {
    const end = innermost(project, library, name, { node, port }, 'inputs');
    const input = end && own(end.definition.inputs, end.port);
    const param = end && own(end.definition.params, end.port);
    if (input) inputs[outside] = isWired(graph, { node, port }) ? { ...input, required: false } : input;
    else if (param) params[outside] = withDefault(param, end);
  }
  for (const { name: outside, node, port } of graph.exposed.outputs) {
    const end = innermost(project, library, name, { node, port }, 'outputs');
    const output = end && own(end.definition.outputs, end.port);
    if (output) outputs[outside] = output;
  }
  return { type: `graph/${name}`, version: 1, title: name, doc: `The subgraph "${name}" of this project.`, inputs, outputs, params };
}

/** A port of a library's node, and the node. */
interface PortEnd {
  readonly definition: NodeDefinition;
  readonly port: string;
  readonly binding: ReturnType<typeof boundValue>;
}

/** Follows an exposed port into subgraphs within subgraphs, to the library's node that has it. */
function innermost(
  project: Pick<Project, 'graphs'>,
  library: NodeLibrary,
  graphName: string,
  start: PortAddress,
  side: 'inputs' | 'outputs',
): PortEnd | undefined {
  let graph = own(project.graphs, graphName);
  let at: PortAddress = start;
  const depthLimit = Object.keys(project.graphs).length;
  for (let depth = 0; depth <= depthLimit && graph; depth++) {
    const node = own(graph.nodes, at.node);
    if (!node) return undefined;
    const inner = subgraphName(node.type);
    if (inner === null) {
      const definition = library.definition(node.type);
      const binding = own(node.params, at.port);
      return definition && { definition, port: at.port, binding: binding && boundValue(binding) };
    }
    graph = own(project.graphs, inner);
    const next = graph?.exposed[side].find((exposed) => exposed.name === at.port);
    if (!next) return undefined;
    at = next;
  }
  return undefined;
}

/** Outside, a param begins with the value it has inside. */
function withDefault(param: ParamDefinition, { binding }: PortEnd): ParamDefinition {
  if (binding === undefined || misfit(param, binding) !== null) return param;
  return { ...param, default: binding } as ParamDefinition;
}

function isWired(graph: Graph, { node, port }: PortAddress): boolean {
  return graph.wires.some((wire) => wire.to.node === node && wire.to.port === port);
}
