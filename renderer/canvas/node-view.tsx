import { Handle, type NodeProps, Position } from '@xyflow/react';
import { type MouseEvent, memo, useEffect, useMemo, useRef, useState } from 'react';
import { useStore } from 'zustand';
import { subgraphName } from '../../export/graph/document-names.ts';
import { WIRE_TYPES } from '../../nodes/kit/wire-types.ts';
import { toggleExpanded } from '../state/editor/canvas-state.ts';
import { useDocument, useEditor } from '../state/editor/editor-context.ts';
import { layerName } from '../state/editor/layer-names.ts';
import { refusalOf } from '../state/graph/edit-graph.ts';
import { BODY_PADDING, HEADER_HEIGHT, type PortView, ROW_HEIGHT } from '../state/graph/node-shape.ts';
import { titleProblem } from '../state/graph/subgraph-library.ts';
import { renameSubgraph } from '../state/graph/subgraphs.ts';
import { CategoryMark, categoryColor } from '../ui/category-mark.tsx';
import { Icon } from '../ui/icon.tsx';
import { useDetail } from './detail.ts';
import { NameInPlace } from './name-in-place.tsx';
import { NodeCost } from './performance-overlay.tsx';
import type { CanvasNode, NodeData } from './project-canvas.ts';
import './node-view.css';

/** A node on the canvas. Mounts only visible elements, because a large canvas holds three thousand nodes. */
export const NodeView = memo(function NodeView({ id, data, selected }: NodeProps<CanvasNode>) {
  const detail = useDetail();
  if (detail === 'overview') return <OverviewNode id={id} data={data} selected={selected} />;
  return <FullNode id={id} data={data} selected={selected} titled={detail === 'whole'} />;
});

type NodeBodyProps = Pick<NodeProps<CanvasNode>, 'id' | 'data' | 'selected'>;

/** A node on an overview: a rectangle with the icon and the color of its category. */
function OverviewNode({ id, data, selected }: NodeBodyProps) {
  const state = data.problem?.severity === 'error' ? ' patch-error' : data.muted ? ' patch-muted' : '';
  return (
    <div
      className={`patch${state}${selected ? ' patch-selected' : ''}`}
      style={{ ['--category' as string]: categoryColor(data.nodeType) }}
      data-node={id}
      data-tip={data.title}
    >
      <CategoryMark type={data.nodeType} />
    </div>
  );
}

interface FullNodeProps extends NodeBodyProps {
  /** Whether its title is drawn. */
  readonly titled: boolean;
}

function FullNode({ id, data, selected, titled }: FullNodeProps) {
  const dimmed = useDimmedPorts(id, data.shape.ports);
  const { ports } = data.shape;
  return (
    <div
      className={classOf(data, selected, dimmed === 'all')}
      style={{
        ['--category' as string]: categoryColor(data.nodeType),
        ['--thumbnail' as string]: `${data.shape.thumbnail?.height ?? 0}px`,
      }}
      data-node={id}
    >
      <div
        className="node-head"
        data-tip={data.title !== data.typeTitle ? `${data.typeTitle} · ${data.title}` : titled ? undefined : data.title}
      >
        <CategoryMark type={data.nodeType} />
        {data.subgraph ? <SubgraphTitle data={data} /> : <span className="node-title">{data.title}</span>}
        {data.problem && (
          <span className="node-problem" data-severity={data.problem.severity} data-tip={data.problem.text}>
            <Icon name={data.problem.severity === 'info' ? 'info' : data.problem.severity} size={14} />
          </span>
        )}
      </div>
      {ports.map((port) => (
        <Port
          key={`${port.side} ${port.name}`}
          port={port}
          value={data.values[port.name]}
          collapsed={data.shape.collapsed === true}
          alone={!ports.some(({ row, side }) => row === port.row && side !== port.side)}
          dimmed={dimmed !== null && dimmed !== 'all' && dimmed.has(`${port.side} ${port.name}`)}
        />
      ))}
      {data.shape.thumbnail !== null && <NodeThumbnail node={id} {...data.shape.thumbnail} />}
      <Expander id={id} data={data} />
      <div className="node-above">
        <NodeCost id={id} />
        {data.problem && data.problem.severity !== 'info' && (
          <p className="node-says" data-severity={data.problem.severity}>
            {data.problem.text}
          </p>
        )}
      </div>
    </div>
  );
}

/** The title of a subgraph. A double-click on its text edits it; beside the text, it opens the subgraph, as on other parts of the node. */
function SubgraphTitle({ data: { nodeType, title } }: { readonly data: NodeData }) {
  const editor = useEditor();
  const [naming, setNaming] = useState(false);
  const name = subgraphName(nodeType) ?? '';
  if (!naming) {
    const begin = (event: MouseEvent<HTMLElement>) => {
      // Zoomed out, the text is most of the node.
      if (event.currentTarget.closest('.canvas-far')) return;
      event.stopPropagation();
      setNaming(true);
    };
    return (
      <span className="node-title">
        {/* biome-ignore lint/a11y/noStaticElementInteractions: the inspector has a field for the name */}
        <span onDoubleClick={begin}>{title}</span>
      </span>
    );
  }
  return (
    <NameInPlace
      label="Name of the subgraph"
      title={title}
      problemOf={(typed) => titleProblem(editor.document.getState().project, name, typed)}
      onName={(typed) => void renameSubgraph(editor, name, typed)}
      onLeave={() => setNaming(false)}
    />
  );
}

interface PortProps {
  readonly port: PortView;
  readonly value: string | undefined;
  readonly dimmed: boolean;
  readonly collapsed: boolean;
  /** Whether the row has no port on the other side. */
  readonly alone: boolean;
}

function Port({ port, value, dimmed, collapsed, alone }: PortProps) {
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
        data-tip={`${port.label} · ${label}${input && port.required ? ', required' : ''}\n${port.doc}`}
        style={{ ['--port' as string]: color, top: top + ROW_HEIGHT / 2 }}
      />
      {!collapsed && (
        <span className={`port-label port-label-${port.side}${alone ? ' port-label-alone' : ''}`} style={{ top, height: ROW_HEIGHT }}>
          <span>{port.label}</span>
          {value !== undefined && <span className="port-value">{value}</span>}
        </span>
      )}
    </>
  );
}

/** Shows or hides the ports of unconnected params. Visible while the node is hovered or focused. */
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
      {data.expanded ? 'Hide parameters' : `${count} ${count === 1 ? 'parameter' : 'parameters'}`}
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

/**
 * Ports of a node that cannot take the wire being dragged, as `side name`; `all` if no port can; null while no wire is dragged.
 */
function useDimmedPorts(node: string, ports: readonly PortView[]): ReadonlySet<string> | 'all' | null {
  const editor = useEditor();
  const draggedWire = useStore(editor.canvas, (state) => state.draggedWire);
  return useMemo(() => {
    if (draggedWire === null) return null;
    const wanted = draggedWire.side === 'output' ? 'input' : 'output';
    const dimmed = ports.filter((port) => {
      const start = node === draggedWire.node && port.name === draggedWire.port && port.side === draggedWire.side;
      return !start && (port.side !== wanted || refusalOf(editor, draggedWire, { node, port: port.name, side: port.side }) !== null);
    });
    return dimmed.length === ports.length ? 'all' : new Set(dimmed.map((port) => `${port.side} ${port.name}`));
  }, [editor, draggedWire, node, ports]);
}

interface ThumbnailProps {
  readonly node: string;
  readonly port: string;
  /** Height with the margin, in canvas units. */
  readonly height: number;
}

/** Distance of a thumbnail to the lower border of its node. */
const THUMBNAIL_MARGIN = 6;

/** Thumbnail of a layer. React Flow mounts only visible nodes, so only visible layers are requested; bitmaps bypass React. */
function NodeThumbnail({ node, port, height }: ThumbnailProps) {
  const { thumbnails } = useEditor();
  const layer = useDocument((state) => layerName(state, node, port));
  const canvas = useRef<HTMLCanvasElement>(null);
  useEffect(
    () =>
      thumbnails.watch(layer, (picture) => {
        const element = canvas.current;
        if (!element) return picture.close();
        element.width = picture.width;
        element.height = picture.height;
        element.getContext('bitmaprenderer')?.transferFromImageBitmap(picture);
      }),
    [thumbnails, layer],
  );
  return (
    <div className="node-thumbnail" style={{ height: height - THUMBNAIL_MARGIN }}>
      <canvas ref={canvas} width="0" height="0" />
    </div>
  );
}
