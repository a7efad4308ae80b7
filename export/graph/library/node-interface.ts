import {
  type InputPort,
  type NodeDefinition,
  type NodeLibrary,
  type OutputPort,
  type ParamDefinition,
  paramWireType,
} from '../../../nodes/kit/definition.ts';
import type { ValueType, WireType } from '../../../nodes/kit/wire-types.ts';
import { subgraphName } from '../document-names.ts';
import type { Graph, GraphNode, PortAddress, Project } from '../project.ts';
import { getOwn } from '../record.ts';
import { boundValue, misfit } from './param-value.ts';

/** Ports and params of a node type: those of its definition, or those that a subgraph exposes. */
export type NodeInterface = Pick<NodeDefinition, 'type' | 'version' | 'title' | 'doc' | 'inputs' | 'outputs' | 'params' | 'delay'>;

/** Returns the interface of a node type of the library or of `graph/NAME`; undefined for unknown types. Caches its results. */
export type InterfaceLookup = (type: string) => NodeInterface | undefined;

/**
 * Creates a lookup for the current graphs of a project; create another after a change.
 *
 * @example
 * const interfaceOf = createInterfaceLookup(project, library);
 * interfaceOf('graph/glow')?.title; // 'glow'
 */
export function createInterfaceLookup(project: Pick<Project, 'graphs'>, library: NodeLibrary): InterfaceLookup {
  const subgraphInterfaces = new Map<string, NodeInterface | undefined>();
  return (type) => {
    const name = subgraphName(type);
    if (name === null) return library.definition(type);
    if (!subgraphInterfaces.has(type)) {
      const graph = getOwn(project.graphs, name);
      subgraphInterfaces.set(type, graph && interfaceOfGraph(project, library, name, graph));
    }
    return subgraphInterfaces.get(type);
  };
}

/** An input that takes wires: a port, or a param that can be a port. */
export type ConnectableInput =
  | { readonly kind: 'port'; readonly type: WireType; readonly port: InputPort }
  | { readonly kind: 'param'; readonly type: ValueType; readonly param: ParamDefinition };

/**
 * @returns The input or connectable param with this name, or undefined.
 *
 * @example
 * inputOf(sepia, 'inputImage')?.kind; // 'port'
 * inputOf(sepia, 'layer'); // undefined: an output
 */
export function inputOf(nodeInterface: NodeInterface, name: string): ConnectableInput | undefined {
  const port = getOwn(nodeInterface.inputs, name);
  if (port) return { kind: 'port', type: port.type, port };
  const param = getOwn(nodeInterface.params, name);
  const type = param && paramWireType(param);
  return param && type && { kind: 'param', type, param };
}

/**
 * Whether wires into the node may close a loop, because a delay outputs values of an earlier frame. Subgraphs never do, because their
 * interface does not tell which ports are delayed.
 */
export function breaksLoops({ type, muted }: GraphNode, interfaceOf: InterfaceLookup): boolean {
  return muted !== true && interfaceOf(type)?.delay === true;
}

/** Whether several wires can be connected to the input. */
export function takesSeveral(input: ConnectableInput): boolean {
  return input.kind === 'port' && input.port.multiple === true;
}

function interfaceOfGraph(project: Pick<Project, 'graphs'>, library: NodeLibrary, name: string, graph: Graph): NodeInterface {
  const inputs: Record<string, InputPort> = {};
  const outputs: Record<string, OutputPort> = {};
  const params: Record<string, ParamDefinition> = {};
  for (const { name: outside, node, port } of graph.exposed.inputs) {
    const end = innermost(project, library, name, { node, port }, 'inputs');
    const input = end && getOwn(end.definition.inputs, end.port);
    const param = end && getOwn(end.definition.params, end.port);
    if (input) inputs[outside] = portOf(input, isWired(graph, { node, port }));
    else if (param) params[outside] = withDefault(param, end);
  }
  for (const { name: outside, node, port } of graph.exposed.outputs) {
    const end = innermost(project, library, name, { node, port }, 'outputs');
    const output = end && getOwn(end.definition.outputs, end.port);
    if (output) outputs[outside] = output;
  }
  return { type: `graph/${name}`, version: 1, title: name, doc: `The subgraph “${name}” of this project.`, inputs, outputs, params };
}

/** An input as the instances of a subgraph have it. The params that it replaces are inside. */
function portOf({ replaces: _, ...input }: InputPort, isWired: boolean): InputPort {
  return isWired ? { ...input, required: false } : input;
}

/** A port of a node of the library, with the node. */
interface PortEnd {
  readonly definition: NodeDefinition;
  readonly port: string;
  readonly binding: ReturnType<typeof boundValue>;
}

/** Follows an exposed port through nested subgraphs to the node of the library that has it. */
function innermost(
  project: Pick<Project, 'graphs'>,
  library: NodeLibrary,
  graphName: string,
  start: PortAddress,
  side: 'inputs' | 'outputs',
): PortEnd | undefined {
  let graph = getOwn(project.graphs, graphName);
  let at: PortAddress = start;
  const depthLimit = Object.keys(project.graphs).length;
  for (let depth = 0; depth <= depthLimit && graph; depth++) {
    const node = getOwn(graph.nodes, at.node);
    if (!node) return undefined;
    const inner = subgraphName(node.type);
    if (inner === null) {
      const definition = library.definition(node.type);
      const binding = getOwn(node.params, at.port);
      return definition && { definition, port: at.port, binding: binding && boundValue(binding) };
    }
    graph = getOwn(project.graphs, inner);
    const next = graph?.exposed[side].find((exposed) => exposed.name === at.port);
    if (!next) return undefined;
    at = next;
  }
  return undefined;
}

/** The definition of an exposed param, with the value of the inner param as its default. */
function withDefault(param: ParamDefinition, { binding }: PortEnd): ParamDefinition {
  if (binding === undefined || misfit(param, binding) !== null) return param;
  return { ...param, default: binding } as ParamDefinition;
}

function isWired(graph: Graph, { node, port }: PortAddress): boolean {
  return graph.wires.some((wire) => wire.to.node === node && wire.to.port === port);
}
