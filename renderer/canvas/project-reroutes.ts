import type { Node, NodeHandle } from '@xyflow/react';
import type { Wire } from '../../export/graph/project.ts';
import { routeOf } from '../../export/graph/routes.ts';
import type { WireType } from '../../nodes/kit/wire-types.ts';
import type { Place } from '../state/editor/canvas-state.ts';
import { layoutOf, nodeOf, type OpenGraph } from '../state/editor/document.ts';
import { itemId } from '../state/editor/item-ids.ts';
import { rerouteWords } from '../state/graph/reroutes.ts';
import { REROUTE_IN, REROUTE_OUT, sameParts } from './project-wires.ts';

export interface RerouteData extends Record<string, unknown> {
  readonly type: WireType;
}

/** A reroute, as a React Flow node. */
export type RerouteNode = Node<RerouteData, 'reroute'>;

export interface ReroutesInput {
  readonly open: OpenGraph;
  readonly wires: readonly Wire[];
  readonly selected: ReadonlySet<string>;
  readonly dragged: Readonly<Record<string, Place>>;
}

/** Side of the hit area, in canvas units; the drawn point is smaller. */
export const REROUTE_SIZE = 18;
/** Hit area of the knob; matches `reroute-view.css`. */
const KNOB = { x: REROUTE_SIZE + 1, y: 0, width: REROUTE_SIZE, height: REROUTE_SIZE };

const NONE: readonly RerouteNode[] = [];

/** Unchanged reroutes are the same objects as before, and the array is the same if none changed. */
export function createReroutesProjection(): (input: ReroutesInput) => readonly RerouteNode[] {
  let known = new Map<string, { readonly key: readonly unknown[]; readonly node: RerouteNode }>();
  let list: readonly RerouteNode[] = [];
  return ({ open, wires, selected, dragged }) => {
    const layout = layoutOf(open);
    if (Object.keys(layout.reroutes).length === 0) return NONE;
    const through = new Map<string, Wire[]>();
    for (const wire of wires) for (const id of routeOf(layout, wire)) through.set(id, [...(through.get(id) ?? []), wire]);
    const next: typeof known = new Map();
    for (const [id, place] of Object.entries(layout.reroutes)) {
      const canvasId = itemId('reroute', id);
      const led = through.get(id) ?? [];
      const { x, y } = dragged[canvasId] ?? place;
      const key = [x, y, selected.has(canvasId), typeAt(open, led[0]), rerouteWords(open, led)] as const;
      const before = known.get(canvasId);
      next.set(canvasId, before && sameParts(before.key, key) ? before : { key, node: rerouteNode(canvasId, ...key) });
    }
    known = next;
    const nodes = [...next.values()].map(({ node }) => node);
    if (!sameParts(nodes, list)) list = nodes;
    return list;
  };
}

function typeAt({ library, ...open }: OpenGraph, wire: Wire | undefined): WireType {
  const definition = wire && library.definition(nodeOf(open, wire.from.node)?.type ?? '');
  return (wire && definition?.outputs[wire.from.port]?.type) ?? 'number';
}

/** Handle that new wires start from, beside the point. The point itself drags the reroute. */
export const REROUTE_KNOB = 'knob';

/** Handles of a reroute. Wires end in its center; new wires start from the knob. */
const HANDLES: NodeHandle[] = [
  handleAt(REROUTE_IN, 'target'),
  handleAt(REROUTE_OUT, 'source'),
  { ...handleAt(REROUTE_KNOB, 'source'), ...KNOB },
];

function handleAt(id: string, type: NodeHandle['type']): NodeHandle {
  const position = (type === 'target' ? 'left' : 'right') as NodeHandle['position'];
  return { id, type, position, x: REROUTE_SIZE / 2, y: REROUTE_SIZE / 2, width: 0, height: 0 };
}

function rerouteNode(id: string, x: number, y: number, selected: boolean, type: WireType, ariaLabel: string): RerouteNode {
  return {
    id,
    type: 'reroute',
    // The document stores the center.
    origin: [0.5, 0.5],
    position: { x, y },
    width: REROUTE_SIZE,
    height: REROUTE_SIZE,
    measured: { width: REROUTE_SIZE, height: REROUTE_SIZE },
    handles: HANDLES,
    data: { type },
    selected,
    ariaLabel,
  };
}
