import type { Node, NodeHandle } from '@xyflow/react';
import { subgraphType } from '../../export/graph/document-names.ts';
import { inputOf } from '../../export/graph/library/node-interface.ts';
import { type ExposedPort, type Graph, type GraphLayout, MAIN_GRAPH } from '../../export/graph/project.ts';
import type { NodeDefinition, NodeLibrary } from '../../nodes/kit/definition.ts';
import type { WireType } from '../../nodes/kit/wire-types.ts';
import type { Place } from '../state/editor/canvas-state.ts';
import { borderId } from '../state/editor/item-ids.ts';
import { BODY_PADDING, HEADER_HEIGHT, PORT_SIZE, ROW_HEIGHT } from '../state/graph/node-shape.ts';
import type { PortSide } from '../state/graph/subgraphs.ts';
import type { CanvasNode } from './project-canvas.ts';
import { type CanvasWire, sameParts } from './project-wires.ts';

/** Handle from which a wire exposes the port that it is dragged to. Port names contain no plus sign. */
export const NEW_PORT = '+';

const WIDTH = 136;
/** Distance to the nodes, in canvas units. */
const GAP = 104;

export interface BorderPort {
  readonly name: string;
  readonly label: string;
  readonly type: WireType;
}

export interface BorderData extends Record<string, unknown> {
  readonly side: PortSide;
  readonly ports: readonly BorderPort[];
}

/**
 * One border of an open subgraph: the ports that its instances have on this side. It is drawn, but not stored as a node; the layout keeps
 * its place once it was moved.
 */
export type BorderNode = Node<BorderData, 'border'>;

export interface BordersInput {
  /** Name of the open graph. */
  readonly name: string;
  readonly graph: Graph;
  readonly library: NodeLibrary;
  readonly nodes: readonly CanvasNode[];
  readonly layout: Pick<GraphLayout, 'borders'>;
  /** Canvas ids of selected items. */
  readonly selected: ReadonlySet<string>;
  /** Positions during a drag, in canvas units. */
  readonly dragged: Readonly<Record<string, Place>>;
}

export interface BordersView {
  readonly nodes: readonly BorderNode[];
  /** Wires between the borders and the exposed ports. */
  readonly wires: readonly CanvasWire[];
}

const NONE: BordersView = { nodes: [], wires: [] };

/** The distance of a port's row from the top of its border, in canvas units. */
export function borderRowTop(row: number): number {
  return HEADER_HEIGHT + BODY_PADDING + row * ROW_HEIGHT;
}

/** Projects the exposed ports of an open subgraph to a border on each side of its nodes. The main graph has none. */
export function createBordersProjection(): (input: BordersInput) => BordersView {
  let seen: readonly unknown[] = [];
  let view = NONE;
  return (input) => {
    const { name, graph, library, nodes, layout, selected, dragged } = input;
    const own = [borderId('inputs'), borderId('outputs')].flatMap((id) => [selected.has(id), dragged[id]]);
    const now = [name, graph.exposed, library, nodes, layout.borders, ...own];
    if (sameParts(now, seen)) return view;
    seen = now;
    view = name === MAIN_GRAPH || nodes.length === 0 ? NONE : projectBorders(input);
    return view;
  };
}

function projectBorders({ name, graph, library, nodes, layout, selected, dragged }: BordersInput): BordersView {
  const lefts = nodes.map(({ position }) => position.x);
  const rights = nodes.map(({ position, width = 0 }) => position.x + width);
  const tops = nodes.map(({ position }) => position.y);
  const bottoms = nodes.map(({ position, height = 0 }) => position.y + height);
  const middle = (Math.min(...tops) + Math.max(...bottoms)) / 2;
  const definition = library.definition(subgraphType(name));
  const border = (side: PortSide, x: number): BorderNode => {
    const ports = graph.exposed[side].map((exposed) => borderPort(definition, side, exposed.name));
    const height = borderRowTop(ports.length + 1) + BODY_PADDING;
    return {
      id: borderId(side),
      type: 'border',
      position: dragged[borderId(side)] ?? layout.borders?.[side] ?? { x, y: middle - height / 2 },
      width: WIDTH,
      height,
      measured: { width: WIDTH, height },
      data: { side, ports },
      selected: selected.has(borderId(side)),
      handles: [...ports.map((port) => port.name), NEW_PORT].map((port, row) => handleAt(side, port, row)),
      ariaLabel: side === 'inputs' ? 'Inputs of the subgraph' : 'Outputs of the subgraph',
    };
  };
  const inputs = border('inputs', Math.min(...lefts) - GAP - WIDTH);
  const outputs = border('outputs', Math.max(...rights) + GAP);
  const wires = [inputs, outputs].flatMap(({ data: { side, ports } }) =>
    ports.flatMap((port, row) => {
      const exposed = graph.exposed[side][row];
      return exposed && graph.nodes[exposed.node] ? [borderWire(side, port, exposed)] : [];
    }),
  );
  return { nodes: [inputs, outputs], wires };
}

function borderPort(definition: NodeDefinition | undefined, side: PortSide, name: string): BorderPort {
  const input = side === 'inputs' && definition ? inputOf(definition, name) : undefined;
  const output = side === 'outputs' ? definition?.outputs[name] : undefined;
  const label = output?.label ?? definition?.inputs[name]?.label ?? definition?.params[name]?.label ?? name;
  return { name, label, type: (input ?? output)?.type ?? 'number' };
}

function handleAt(side: PortSide, id: string, row: number): NodeHandle {
  const isInput = side === 'inputs';
  return {
    id,
    type: isInput ? 'source' : 'target',
    position: (isInput ? 'right' : 'left') as NodeHandle['position'],
    x: (isInput ? WIDTH : 0) - PORT_SIZE / 2,
    y: borderRowTop(row) + (ROW_HEIGHT - PORT_SIZE) / 2,
    width: PORT_SIZE,
    height: PORT_SIZE,
  };
}

function borderWire(side: PortSide, { name, label, type }: BorderPort, exposed: ExposedPort): CanvasWire {
  const [outer, inner] = [
    { node: borderId(side), port: name },
    { node: exposed.node, port: exposed.port },
  ];
  const [from, to] = side === 'inputs' ? [outer, inner] : [inner, outer];
  return {
    id: `${borderId(side)}.${name}`,
    type: 'scrim',
    source: from.node,
    sourceHandle: from.port,
    target: to.node,
    targetHandle: to.port,
    data: { from: type, to: type, order: null, under: false, lit: false, scene: false },
    selectable: false,
    focusable: false,
    reconnectable: false,
    ariaLabel: `${side === 'inputs' ? 'Input' : 'Output'} ${label} of the subgraph`,
  };
}
