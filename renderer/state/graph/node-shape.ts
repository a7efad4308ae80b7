import type { GraphNode } from '../../../export/graph/project.ts';
import { type NodeDefinition, type ParamDefinition, paramWireType } from '../../../nodes/kit/definition.ts';
import type { WireType } from '../../../nodes/kit/wire-types.ts';
import { layerPortOf } from '../editor/layer-names.ts';

/**
 * How large a node is drawn and where its ports are, from data alone. React Flow is handed these numbers instead of measuring
 * the page: it can then leave out what is not on screen, and 3,000 nodes pan at 60 frames per second.
 */
export const NODE_WIDTH = 184;
export const HEADER_HEIGHT = 30;
export const ROW_HEIGHT = 22;
export const BODY_PADDING = 6;
/** What the pointer can hit of a port; the drawn shape is half of it. */
export const PORT_SIZE = 22;
/** What a node's picture adds to its height. */
export const PICTURE_HEIGHT = 104;

export interface PortView {
  readonly name: string;
  readonly label: string;
  readonly doc: string;
  readonly type: WireType;
  readonly side: 'input' | 'output';
  /** Line in the body, from 0; an input and an output may share one. */
  readonly row: number;
  readonly multiple: boolean;
  readonly required: boolean;
  /** For a param shown as a port: its definition. */
  readonly param: ParamDefinition | null;
}

export interface NodeShape {
  readonly width: number;
  readonly height: number;
  readonly ports: readonly PortView[];
  /** Params that could be wired and are not shown. */
  readonly hiddenParams: number;
  /** Nothing of it is shown but its head. */
  readonly collapsed?: true;
  /** The layer whose picture stands below the ports. */
  readonly picture: string | null;
}

export interface ShapeOptions {
  /** Params with a wire, by name. */
  readonly wired: ReadonlySet<string>;
  /** Shows every param that can be wired. */
  readonly expanded: boolean;
  /** Shows the head alone; all wires end at its sides. */
  readonly collapsed?: boolean;
  /** Shows the first layer that it gives. */
  readonly pictured?: boolean;
}

export function nodeShape(
  definition: NodeDefinition,
  node: GraphNode,
  { wired, expanded, collapsed = false, pictured = false }: ShapeOptions,
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

  // A node that only computes is read by its operands, so they are always there.
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
  if (collapsed) return { width: NODE_WIDTH, height: HEADER_HEIGHT, ports, hiddenParams: 0, collapsed, picture: null };
  const rows = Math.max(row, 1);
  const picture = pictured ? layerPortOf(definition) : null;
  const height = HEADER_HEIGHT + 2 * BODY_PADDING + rows * ROW_HEIGHT + (picture === null ? 0 : PICTURE_HEIGHT);
  return { width: NODE_WIDTH, height, ports, hiddenParams, picture };
}

/** The type that the node is about: what it gives, or what it takes where it gives nothing. */
export function mainType({ inputs, outputs }: Pick<NodeDefinition, 'inputs' | 'outputs'>): WireType | undefined {
  return (Object.values(outputs)[0] ?? Object.values(inputs)[0])?.type;
}

/** For a node whose type is not in the library: as many ports as its wires name, so that nothing of it is lost from sight. */
export function unknownShape(wiredInputs: readonly string[], wiredOutputs: readonly string[]): NodeShape {
  const port = (name: string, side: 'input' | 'output', row: number): PortView => ({
    name,
    label: name,
    doc: 'A port of a node type that this Scrim does not know.',
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
  return { width: NODE_WIDTH, height: HEADER_HEIGHT + 2 * BODY_PADDING + rows * ROW_HEIGHT, ports, hiddenParams: 0, picture: null };
}

/** Center of a port, relative to the node's top left corner. */
export function portCenter(shape: NodeShape, port: PortView): { readonly x: number; readonly y: number } {
  return {
    x: port.side === 'input' ? 0 : shape.width,
    y: shape.collapsed ? HEADER_HEIGHT / 2 : HEADER_HEIGHT + BODY_PADDING + (port.row + 0.5) * ROW_HEIGHT,
  };
}
