import { Handle, type NodeProps, Position } from '@xyflow/react';
import { memo } from 'react';
import { WIRE_TYPES } from '../../nodes/kit/wire-types.ts';
import { useDetail } from './detail.ts';
import { REROUTE_KNOB, type RerouteNode } from './project-reroutes.ts';
import { REROUTE_IN, REROUTE_OUT } from './project-wires.ts';
import './reroute-view.css';

/** A point that wires run through. Its middle drags it; the knob beside it starts a new wire. */
export const RerouteView = memo(function RerouteView({ data, selected }: NodeProps<RerouteNode>) {
  if (useDetail() === 'overview') return null;
  return (
    <div className={selected ? 'reroute reroute-selected' : 'reroute'} style={{ ['--port' as string]: WIRE_TYPES[data.type].color }}>
      <Handle id={REROUTE_IN} type="target" position={Position.Left} className="reroute-end" isConnectableStart={false} />
      <Handle id={REROUTE_OUT} type="source" position={Position.Right} className="reroute-end" isConnectableStart={false} />
      <Handle
        id={REROUTE_KNOB}
        type="source"
        position={Position.Right}
        className="reroute-knob"
        isConnectableEnd={false}
        data-tip="Draw another wire from here"
      />
    </div>
  );
});
