import { BaseEdge, type ConnectionLineComponentProps, type EdgeProps } from '@xyflow/react';
import { memo } from 'react';
import { WIRE_TYPES, type WireType } from '../../nodes/kit/wire-types.ts';
import { itemOf } from '../state/editor/item-ids.ts';
import { PORT_SIZE } from '../state/graph/node-shape.ts';
import type { CanvasWire } from './project-wires.ts';
import { stretchPath, wirePath } from './wire-path.ts';
import './wire-view.css';

/** A wire in the color of its type, double for scene layers; a gradient if it converts one type to another. */
export const WireView = memo(function WireView(props: EdgeProps<CanvasWire>) {
  const { id, sourceY, targetY, data } = props;
  const fromReroute = itemOf(props.source) !== null;
  const toReroute = itemOf(props.target) !== null;
  // React Flow ends edges at the rim of the hit area of a port; wires end at its center.
  const sourceX = props.sourceX - (fromReroute ? 0 : PORT_SIZE / 2);
  const targetX = props.targetX + (toReroute ? 0 : PORT_SIZE / 2);
  const path = stretchPath({ sourceX, sourceY, targetX, targetY, fromReroute, toReroute });
  const from = data?.from ?? 'number';
  const to = data?.to ?? 'number';
  const gradientId = `wire-${id.replaceAll(/[^a-z0-9]/gi, '-')}`;
  const stroke = from === to ? WIRE_TYPES[from].color : `url(#${gradientId})`;
  return (
    <>
      {from !== to && (
        <linearGradient id={gradientId} gradientUnits="userSpaceOnUse" x1={sourceX} y1={sourceY} x2={targetX} y2={targetY}>
          <stop offset="0.25" stopColor={WIRE_TYPES[from].color} />
          <stop offset="0.75" stopColor={WIRE_TYPES[to].color} />
        </linearGradient>
      )}
      <BaseEdge
        path={path}
        className={`wire${data?.scene ? ' wire-scene' : ''}${data?.lit ? ' wire-selected' : ''}${data?.under ? ' wire-under' : ''}`}
        style={{ stroke }}
        interactionWidth={18}
      />
      {data?.scene && <path className="wire-core" d={path} />}
      {data?.order !== null && data?.order !== undefined && (
        <text className="wire-order" x={targetX - 16} y={targetY - 5} textAnchor="middle">
          {data.order}
        </text>
      )}
    </>
  );
});

/** The wire being dragged. */
export function PendingWire({ fromX, fromY, toX, toY, fromHandle, connectionStatus, fromNode }: ConnectionLineComponentProps) {
  const output = fromHandle.type === 'source';
  const path = output ? wirePath(fromX, fromY, toX, toY) : wirePath(toX, toY, fromX, fromY);
  const type = typeOfPort(fromNode.data, fromHandle.id ?? '', output ? 'output' : 'input');
  const color = type ? WIRE_TYPES[type].color : 'var(--text-3)';
  return <path className={`wire wire-in-hand wire-${connectionStatus ?? 'open'}`} d={path} style={{ stroke: color }} />;
}

function typeOfPort(data: Record<string, unknown>, name: string, side: 'input' | 'output'): WireType | undefined {
  const { shape, type } = data as { readonly shape?: CanvasShape; readonly type?: WireType };
  // A reroute has no ports; all of its wires have its type.
  if (!shape) return type;
  return shape.ports.find((port) => port.name === name && port.side === side)?.type;
}

interface CanvasShape {
  readonly ports: readonly { readonly name: string; readonly side: string; readonly type: WireType }[];
}
