import type { GraphNode } from '../../../export/graph/project.ts';
import { type NodeDefinition, type ParamDefinition, paramWireType } from '../../../nodes/kit/definition.ts';
import type { WireType } from '../../../nodes/kit/wire-types.ts';
import { layerPortOf } from '../editor/layer-names.ts';

/**
 * Width of a node in canvas units. All sizes of nodes and positions of ports are computed from data: React Flow then need not measure the
 * page and can omit invisible nodes, so that 3,000 nodes pan at 60 frames per second.
 */
export const NODE_WIDTH = 184;
export const HEADER_HEIGHT = 30;
export const ROW_HEIGHT = 22;
export const BODY_PADDING = 6;
/** Size of the hit area of a port. The drawn shape has half of it. */
export const PORT_SIZE = 22;
/** Maximum height of a thumbnail with its margin. */
export const THUMBNAIL_HEIGHT = 104;

export interface PortView {
  readonly name: string;
  readonly label: string;
  readonly doc: string;
  readonly type: WireType;
  readonly side: 'input' | 'output';
  /** Row of the port, from 0. An input and an output may share a row. */
  readonly row: number;
  readonly multiple: boolean;
  readonly required: boolean;
  /** Definition of the param, if the port is a param. */
  readonly param: ParamDefinition | null;
}

export interface NodeShape {
  readonly width: number;
  readonly height: number;
  readonly ports: readonly PortView[];
  /** Number of connectable params that are not shown. */
  readonly hiddenParams: number;
  /** Present if only the header is shown. */
  readonly collapsed?: true;
  /** The thumbnail: the output port of its layer, and its height with its margin. Null without one. */
  readonly thumbnail: { readonly port: string; readonly height: number } | null;
}

export interface ShapeOptions {
  /** Names of connected params. */
  readonly wired: ReadonlySet<string>;
  /** Whether all connectable params are shown. */
  readonly expanded: boolean;
  /** Whether only the header is shown. Wires then end at its sides. */
  readonly collapsed?: boolean;
  /** Height of the thumbnail of the first layer, in canvas units; 0 for none. */
  readonly thumbnailHeight?: number;
}

export function nodeShape(
  definition: NodeDefinition,
  node: GraphNode,
  { wired, expanded, collapsed = false, thumbnailHeight = 0 }: ShapeOptions,
): NodeShape {
  const inputs = Object.entries(definition.inputs);
  const outputs = Object.entries(definition.outputs);
  const ports: PortView[] = [];
  inputs.forEach(([name, port], row) => {
    const multiple = port.multiple ?? false;
    ports.push({
      name,
      label: port.label,
      doc: port.doc,
      type: port.type,
      side: 'input',
      row,
      multiple,
      required: port.required,
      param: null,
    });
  });
  outputs.forEach(([name, port], row) => {
    ports.push({
      name,
      label: port.label,
      doc: port.doc,
      type: port.type,
      side: 'output',
      row,
      multiple: true,
      required: false,
      param: null,
    });
  });

  // The params of a value node are its operands, so they are always shown.
  const showAll = expanded || definition.lowering.kind === 'value';
  let row = Math.max(inputs.length, outputs.length);
  let hiddenParams = 0;
  for (const [name, param] of Object.entries(definition.params)) {
    const type = paramWireType(param);
    if (type === undefined) continue;
    const binding = node.params[name];
    const shown = showAll || wired.has(name) || (binding !== undefined && 'port' in binding);
    if (!shown) {
      hiddenParams++;
      continue;
    }
    ports.push({ name, label: param.label, doc: param.doc, type, side: 'input', row, multiple: false, required: false, param });
    row++;
  }
  if (collapsed) return { width: NODE_WIDTH, height: HEADER_HEIGHT, ports, hiddenParams: 0, collapsed, thumbnail: null };
  const rows = Math.max(row, 1);
  const port = thumbnailHeight === 0 ? null : layerPortOf(definition);
  const thumbnail = port === null ? null : { port, height: thumbnailHeight };
  const height = HEADER_HEIGHT + 2 * BODY_PADDING + rows * ROW_HEIGHT + (thumbnail?.height ?? 0);
  return { width: NODE_WIDTH, height, ports, hiddenParams, thumbnail };
}

/** The wire type that colors a node: that of its first output; without outputs, of its first input. */
export function mainType({ inputs, outputs }: Pick<NodeDefinition, 'inputs' | 'outputs'>): WireType | undefined {
  return (Object.values(outputs)[0] ?? Object.values(inputs)[0])?.type;
}

/** Shape of a node of unknown type, with a port for each of its wires. */
export function unknownShape(wiredInputs: readonly string[], wiredOutputs: readonly string[]): NodeShape {
  const port = (name: string, side: 'input' | 'output', row: number): PortView => ({
    name,
    label: name,
    doc: 'A port of an unknown node type.',
    type: 'number',
    side,
    row,
    multiple: true,
    required: false,
    param: null,
  });
  const ports = [
    ...wiredInputs.map((name, row) => port(name, 'input', row)),
    ...wiredOutputs.map((name, row) => port(name, 'output', row)),
  ];
  const rows = Math.max(wiredInputs.length, wiredOutputs.length, 1);
  return { width: NODE_WIDTH, height: HEADER_HEIGHT + 2 * BODY_PADDING + rows * ROW_HEIGHT, ports, hiddenParams: 0, thumbnail: null };
}

/** Center of a port relative to the top left corner of the node. */
export function portCenter(shape: NodeShape, port: PortView): { readonly x: number; readonly y: number } {
  return {
    x: port.side === 'input' ? 0 : shape.width,
    y: shape.collapsed ? HEADER_HEIGHT / 2 : HEADER_HEIGHT + BODY_PADDING + (port.row + 0.5) * ROW_HEIGHT,
  };
}
