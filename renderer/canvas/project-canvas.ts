import type { Node, NodeHandle } from '@xyflow/react';
import { subgraphName } from '../../export/graph/document-names.ts';
import type { ExposedPort, GraphNode, NodeLayout, Wire } from '../../export/graph/project.ts';
import type { NodeDefinition } from '../../nodes/kit/definition.ts';
import type { WireType } from '../../nodes/kit/wire-types.ts';
import { nodeTitle } from '../state/editor/node-title.ts';
import { mainType, type NodeShape, nodeShape, PORT_SIZE, portCenter, unknownShape } from '../state/graph/node-shape.ts';
import { valueText } from '../state/params/value-text.ts';
import type { NodeProblem } from '../state/problems/problems.ts';
import { createThumbnailsProjection } from './project-thumbnails.ts';
import { type CanvasWire, createWiresProjection, sameParts as same, type WiresInput } from './project-wires.ts';

/** Content of one node on the canvas. The object is reused until something in it changes. */
export interface NodeData extends Record<string, unknown> {
  /** The name of the node, as `nodeTitle` gives it. */
  readonly title: string;
  readonly typeTitle: string;
  /** Type id of the node. */
  readonly nodeType: string;
  /** Type of its main output. */
  readonly type: WireType | undefined;
  readonly shape: NodeShape;
  /** Current values of the params shown as ports, as text; connected params have none. */
  readonly values: Readonly<Record<string, string>>;
  readonly muted: boolean;
  /** Whether the node is an instance of a subgraph. */
  readonly subgraph: boolean;
  readonly known: boolean;
  readonly expanded: boolean;
  readonly problem: NodeProblem | null;
}

export type CanvasNode = Node<NodeData, 'scrim'>;

export interface CanvasInput extends WiresInput {
  readonly selectedNodes: ReadonlySet<string>;
  readonly expanded: ReadonlySet<string>;
  /** Whether nodes show thumbnails of their layers. */
  readonly hasThumbnail?: boolean;
  /** Positions of dragged nodes, in canvas units. */
  readonly dragged: Readonly<Record<string, { readonly x: number; readonly y: number }>>;
  readonly problems: ReadonlyMap<string, NodeProblem>;
}

export interface CanvasView {
  /** The array is reused until a node changes. */
  readonly nodes: CanvasNode[];
  /** The array is reused until a wire changes. */
  readonly wires: CanvasWire[];
}

interface CachedNode {
  readonly key: readonly unknown[];
  readonly node: CanvasNode;
}

/**
 * Projects the document to the nodes and wires of React Flow. Unchanged nodes and wires are the same objects as before, so that a
 * drag rerenders only the dragged ones.
 */
export function createCanvasProjection(): (input: CanvasInput) => CanvasView {
  let nodes = new Map<string, CachedNode>();
  let shown: CanvasNode[] = [];
  const projectWires = createWiresProjection();
  const wiredPortsOf = memoizeLast(wiredPorts);
  const exposedInputsOf = memoizeLast(exposedInputs);
  const projectThumbnails = createThumbnailsProjection();
  return (input) => {
    const wiredOf = wiredPortsOf(input.graph.wires);
    const exposedOf = exposedInputsOf(input.graph.exposed.inputs);
    const portsOf = (id: string) => withExposed(wiredOf.get(id) ?? NO_PORTS, exposedOf.get(id));
    const heights = projectThumbnails(input, portsOf);
    const nextNodes = new Map<string, CachedNode>();
    for (const [id, node] of Object.entries(input.graph.nodes)) {
      const wired = portsOf(id);
      const expanded = input.expanded.has(id);
      const layout = input.layout.nodes[id];
      const definition = input.library.definition(node.type);
      const selected = input.selectedNodes.has(id);
      const problem = input.problems.get(id) ?? null;
      const key = [
        node,
        definition,
        layout,
        input.dragged[id],
        wired.key,
        selected,
        expanded,
        problem?.severity,
        problem?.text,
        heights.get(id),
        nodeTitle(node, input.library, input.assets ?? {}),
      ];
      const known = nodes.get(id);
      const fresh =
        known && same(known.key, key) ? known : { key, node: canvasNode(id, node, definition, wired, heights, input, known?.node) };
      nextNodes.set(id, fresh);
    }
    nodes = nextNodes;
    const all = [...nodes.values()].map(({ node }) => node);
    if (!same(all, shown)) shown = all;
    return { nodes: shown, wires: projectWires(input) };
  };
}

interface WiredPorts {
  readonly key: string;
  readonly inputs: ReadonlySet<string>;
  readonly outputs: ReadonlySet<string>;
  /** Exposed inputs and params of a node in a subgraph. Those without a wire have a value. */
  readonly exposed: ReadonlySet<string>;
}

const NO_PORTS: WiredPorts = { key: '', inputs: new Set(), outputs: new Set(), exposed: new Set() };

function exposedInputs(exposed: readonly ExposedPort[]): Map<string, ReadonlySet<string>> {
  const ids = new Set(exposed.map(({ node }) => node));
  return new Map([...ids].map((id) => [id, new Set(exposed.filter(({ node }) => node === id).map(({ port }) => port))]));
}

/** Exposed params are shown as ports, where the wires from the border of the subgraph end. */
function withExposed(wired: WiredPorts, exposed: ReadonlySet<string> | undefined): WiredPorts {
  if (exposed === undefined) return wired;
  const inputs = new Set([...wired.inputs, ...exposed]);
  const unwired = new Set([...exposed].filter((port) => !wired.inputs.has(port)));
  return { key: `${wired.key}|${[...exposed].sort()}`, inputs, outputs: wired.outputs, exposed: unwired };
}

function wiredPorts(wires: readonly Wire[]): Map<string, WiredPorts> {
  const sets = new Map<string, { inputs: Set<string>; outputs: Set<string> }>();
  const at = (node: string) => {
    const known = sets.get(node) ?? { inputs: new Set(), outputs: new Set() };
    sets.set(node, known);
    return known;
  };
  for (const { from, to } of wires) {
    at(from.node).outputs.add(from.port);
    at(to.node).inputs.add(to.port);
  }
  return new Map(
    [...sets].map(([id, { inputs, outputs }]) => [
      id,
      { key: `${[...inputs].sort()}|${[...outputs].sort()}`, inputs, outputs, exposed: NO_PORTS.exposed },
    ]),
  );
}

function canvasNode(
  id: string,
  node: GraphNode,
  definition: NodeDefinition | undefined,
  wired: WiredPorts,
  heights: ReadonlyMap<string, number>,
  input: CanvasInput,
  before: CanvasNode | undefined,
): CanvasNode {
  const expanded = input.expanded.has(id);
  const collapsed = input.layout.nodes[id]?.collapsed === true;
  const options = { wired: wired.inputs, expanded, collapsed, thumbnailHeight: heights.get(id) ?? 0 };
  const shape = definition ? nodeShape(definition, node, options) : unknownShape([...wired.inputs], [...wired.outputs]);
  const values: Record<string, string> = {};
  for (const port of shape.ports) {
    if (port.param && (!wired.inputs.has(port.name) || wired.exposed.has(port.name)))
      values[port.name] = valueText(port.param, node.params[port.name]);
  }
  const data: NodeData = {
    title: nodeTitle(node, input.library, input.assets ?? {}),
    typeTitle: definition?.title ?? node.type,
    nodeType: node.type,
    type: definition && mainType(definition),
    shape,
    values,
    muted: node.muted ?? false,
    subgraph: subgraphName(node.type) !== null,
    known: definition !== undefined,
    expanded,
    problem: input.problems.get(id) ?? null,
  };
  const position = input.dragged[id] ?? positionOf(input.layout.nodes[id]);
  return {
    id,
    type: 'scrim',
    position,
    // If only the position changes, React sees the same data and does not rerender the node.
    data: before && sameData(before.data, data) ? before.data : data,
    selected: input.selectedNodes.has(id),
    width: shape.width,
    height: shape.height,
    measured: { width: shape.width, height: shape.height },
    handles: shape.ports.map((port) => handleOf(shape, port)),
    ariaLabel: ariaLabel(data),
  };
}

function ariaLabel({ title, typeTitle, subgraph, muted, problem }: NodeData): string {
  return [
    typeTitle,
    title === typeTitle ? '' : title,
    subgraph ? 'subgraph' : '',
    muted ? 'muted' : '',
    problem ? `${problem.severity}: ${problem.text}` : '',
  ]
    .filter(Boolean)
    .join(', ');
}

function handleOf(shape: NodeShape, port: NodeShape['ports'][number]): NodeHandle {
  const { x, y } = portCenter(shape, port);
  return {
    id: port.name,
    type: port.side === 'input' ? 'target' : 'source',
    position: (port.side === 'input' ? 'left' : 'right') as NodeHandle['position'],
    x: x - PORT_SIZE / 2,
    y: y - PORT_SIZE / 2,
    width: PORT_SIZE,
    height: PORT_SIZE,
  };
}

function positionOf(layout: NodeLayout | undefined): { x: number; y: number } {
  return layout ? { x: layout.x, y: layout.y } : { x: 0, y: 0 };
}

function sameData(a: NodeData, b: NodeData): boolean {
  return JSON.stringify(a) === JSON.stringify(b);
}

/** Memoizes the result for the last argument. */
function memoizeLast<A extends object, R>(work: (argument: A) => R): (argument: A) => R {
  let last: { readonly argument: A; readonly result: R } | null = null;
  return (argument) => {
    if (last?.argument !== argument) last = { argument, result: work(argument) };
    return last.result;
  };
}
