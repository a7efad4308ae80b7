import { Handle, type NodeProps, Position } from '@xyflow/react';
import { memo } from 'react';
import { WIRE_TYPES } from '../../nodes/kit/wire-types.ts';
import { useEditor } from '../shell/editor-context.ts';
import { toggleExpanded } from '../state/canvas.ts';
import { Icon } from '../ui/icon.tsx';
import { NodeCost } from './costs.tsx';
import { useDetail } from './detail.ts';
import './node-view.css';
import { NodePicture } from './node-picture.tsx';
import { BODY_PADDING, HEADER_HEIGHT, type PortView, ROW_HEIGHT } from './node-shape.ts';
import { PortMark } from './port-mark.tsx';
import type { CanvasNode, NodeData } from './project-canvas.ts';
import { useDimmedPorts } from './use-dimmed-ports.ts';

/** One node. Three thousand of these are on a large canvas, so it has nothing that is not seen. */
export const NodeView = memo(function NodeView({ id, data, selected }: NodeProps<CanvasNode>) {
  const overview = useDetail() === 'overview';
  return overview ? <Patch id={id} data={data} selected={selected} /> : <WholeNode id={id} data={data} selected={selected} />;
});

type FaceProps = Pick<NodeProps<CanvasNode>, 'id' | 'data' | 'selected'>;

/** Seen from afar: where it is, and what it is about. */
function Patch({ id, data, selected }: FaceProps) {
  const state = data.problem?.severity === 'error' ? ' patch-error' : data.muted ? ' patch-muted' : '';
  const color = data.type ? WIRE_TYPES[data.type].color : 'var(--text-3)';
  return (
    <div
      className={`patch${state}${selected ? ' patch-selected' : ''}`}
      style={{ ['--port' as string]: color }}
      data-node={id}
      data-tip={data.title}
    />
  );
}

function WholeNode({ id, data, selected }: FaceProps) {
  const dimmed = useDimmedPorts(id, data.shape.ports);
  return (
    <div className={classOf(data, selected, dimmed === 'all')} data-node={id}>
      <div className="node-head">
        {data.type && <PortMark type={data.type} />}
        <span className="node-title">{data.title}</span>
        {data.problem && (
          <span className="node-problem" data-severity={data.problem.severity} data-tip={data.problem.text}>
            <Icon name={data.problem.severity === 'info' ? 'info' : data.problem.severity} size={14} />
          </span>
        )}
      </div>
      {data.shape.ports.map((port) => (
        <Port
          key={`${port.side} ${port.name}`}
          port={port}
          value={data.values[port.name]}
          collapsed={data.shape.collapsed === true}
          dimmed={dimmed !== null && dimmed !== 'all' && dimmed.has(`${port.side} ${port.name}`)}
        />
      ))}
      {data.shape.picture !== null && <NodePicture node={id} port={data.shape.picture} />}
      <Expander id={id} data={data} />
      <NodeCost id={id} />
    </div>
  );
}

interface PortProps {
  readonly port: PortView;
  readonly value: string | undefined;
  readonly dimmed: boolean;
  readonly collapsed: boolean;
}

function Port({ port, value, dimmed, collapsed }: PortProps) {
  const { color, shape, label } = WIRE_TYPES[port.type];
  const input = port.side === 'input';
  const top = collapsed ? (HEADER_HEIGHT - ROW_HEIGHT) / 2 : HEADER_HEIGHT + BODY_PADDING + port.row * ROW_HEIGHT;
  return (
    <>
      <Handle
        id={port.name}
        type={input ? 'target' : 'source'}
        position={input ? Position.Left : Position.Right}
        className={dimmed ? 'port port-dimmed' : 'port'}
        data-shape={shape}
        data-multiple={port.multiple && input ? '' : undefined}
        data-tip={`${port.label} · ${label}${input && port.required ? ', needed' : ''}\n${port.doc}`}
        style={{ ['--port' as string]: color, top: top + ROW_HEIGHT / 2 }}
      />
      {!collapsed && (
        <span className={`port-label port-label-${port.side}`} style={{ top, height: ROW_HEIGHT }}>
          <span>{port.label}</span>
          {value !== undefined && <span className="port-value">{value}</span>}
        </span>
      )}
    </>
  );
}

/** Shows the params that could be wired, for wiring them; seen while the pointer or the focus is at the node. */
function Expander({ id, data }: { readonly id: string; readonly data: NodeData }) {
  const { canvas } = useEditor();
  if (data.shape.collapsed || (data.shape.hiddenParams === 0 && !data.expanded)) return null;
  const count = data.shape.hiddenParams;
  return (
    <button
      type="button"
      className="node-expander nodrag"
      aria-expanded={data.expanded}
      tabIndex={-1}
      onClick={(event) => {
        event.stopPropagation();
        toggleExpanded(canvas, id);
      }}
    >
      {data.expanded ? 'Hide values' : `${count} ${count === 1 ? 'value' : 'values'}`}
    </button>
  );
}

function classOf(data: NodeData, selected: boolean, dimmed: boolean): string {
  return [
    'node',
    selected ? 'node-selected' : '',
    data.muted ? 'node-muted' : '',
    data.subgraph ? 'node-subgraph' : '',
    data.shape.collapsed ? 'node-collapsed' : '',
    data.known ? '' : 'node-unknown',
    dimmed ? 'node-dimmed' : '',
    data.problem?.severity === 'error' ? 'node-error' : '',
  ]
    .filter(Boolean)
    .join(' ');
}
