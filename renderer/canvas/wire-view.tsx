import { BaseEdge, type ConnectionLineComponentProps, type EdgeProps, getBezierPath, Position } from '@xyflow/react';
import { memo } from 'react';
import { WIRE_TYPES, type WireType } from '../../nodes/kit/wire-types.ts';
import type { CanvasWire } from './project-canvas.ts';
import './wire-view.css';

/** A wire in its type's colour; a converting one runs from one colour into the other. */
export const WireView = memo(function WireView(props: EdgeProps<CanvasWire>) {
  const { id, sourceX, sourceY, targetX, targetY, data, selected } = props;
  const [path] = getBezierPath({ sourceX, sourceY, sourcePosition: Position.Right, targetX, targetY, targetPosition: Position.Left, curvature: 0.35 });
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
      <BaseEdge path={path} className={selected ? 'wire wire-selected' : 'wire'} style={{ stroke }} interactionWidth={18} />
      {data?.order !== null && data?.order !== undefined && (
        <text className="wire-order" x={targetX - 16} y={targetY - 5} textAnchor="middle">
          {data.order}
        </text>
      )}
    </>
  );
});

/** The wire in hand. */
export function WireInHand({ fromX, fromY, toX, toY, fromHandle, connectionStatus, fromNode }: ConnectionLineComponentProps) {
  const output = fromHandle.type === 'source';
  const [path] = getBezierPath({
    sourceX: output ? fromX : toX,
    sourceY: output ? fromY : toY,
    sourcePosition: Position.Right,
    targetX: output ? toX : fromX,
    targetY: output ? toY : fromY,
    targetPosition: Position.Left,
    curvature: 0.35,
  });
  const type = typeOfPort(fromNode.data, fromHandle.id ?? '', output ? 'output' : 'input');
  const color = type ? WIRE_TYPES[type].color : 'var(--text-3)';
  return <path className={`wire wire-in-hand wire-${connectionStatus ?? 'open'}`} d={path} style={{ stroke: color }} />;
}

function typeOfPort(data: Record<string, unknown>, name: string, side: 'input' | 'output'): WireType | undefined {
  const shape = data.shape as CanvasShape | undefined;
  return shape?.ports.find((port) => port.name === name && port.side === side)?.type;
}

interface CanvasShape {
  readonly ports: readonly { readonly name: string; readonly side: string; readonly type: WireType }[];
}
