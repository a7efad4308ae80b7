import {
  Background,
  BackgroundVariant,
  MiniMap,
  ReactFlow,
  ReactFlowProvider,
  SelectionMode,
  useStore as useFlowStore,
  useReactFlow,
} from '@xyflow/react';
import '@xyflow/react/dist/base.css';
import { useMemo, useRef, useState } from 'react';
import { WIRE_TYPES } from '../../nodes/kit/wire-types.ts';
import { uiScale } from '../ui/appearance.ts';
import { BorderView } from './border-view.tsx';
import { Breadcrumb } from './breadcrumb.tsx';
import { CanvasControls } from './canvas-controls.tsx';
import { CanvasMenu, useCanvasMenu } from './canvas-menu.tsx';
import './canvas.css';
import './far-view.css';
import { useCanvasCenter, useScale, useShownPlace, useWheel } from './canvas-view.ts';
import { ConnectionHint } from './connection-hint.tsx';
import { createCopies } from './copy-nodes.ts';
import { DetailProvider, detailOf } from './detail.ts';
import { useFileDrop } from './file-drop.ts';
import { FirstSteps } from './first-steps.tsx';
import { FrameView, NoteView } from './item-view.tsx';
import { NodeView } from './node-view.tsx';
import { OverviewWires } from './overview-wires.tsx';
import { PaletteHost } from './palette-host.tsx';
import { CostsProvider, PerformancePanel } from './performance-overlay.tsx';
import type { CanvasWire } from './project-wires.ts';
import { RerouteView } from './reroute-view.tsx';
import { type AnyNode, useCanvasView } from './use-canvas-view.ts';
import { useGestures } from './use-gestures.ts';
import { useKeptView } from './use-kept-view.ts';
import { FAR_ZOOM, useLegibleLabels } from './use-legible-labels.ts';
import { useLongPress } from './use-long-press.ts';
import { FIT_PADDING, useReveal } from './use-reveal.ts';
import { useWireTarget } from './use-wire-target.ts';
import { PendingWire, WireView } from './wire-view.tsx';

const NODE_TYPES = { scrim: NodeView, frame: FrameView, note: NoteView, reroute: RerouteView, border: BorderView };
const WIRE_VIEWS = { scrim: WireView };
const NO_WIRES: CanvasWire[] = [];
const SNAP: [number, number] = [8, 8];
/** A smaller graph is seen whole, and the minimap would cover part of it. */
const FEWEST_ON_MINIMAP = 12;
const ARIA_LABELS = {
  'node.a11yDescription.default': 'Enter selects the node, arrow keys move it, Delete removes it. Its wires are in the inspector.',
  'edge.a11yDescription.default': 'Enter selects the wire, R adds a reroute to it, Delete removes it.',
};

/** The graph editor. Gestures end in commands on the document, and React Flow draws only what the document says. */
export function Canvas() {
  return (
    <ReactFlowProvider>
      <CanvasInside />
    </ReactFlowProvider>
  );
}

function CanvasInside() {
  const { nodes, wires, items, reroutes, borders } = useCanvasView();
  const flow = useReactFlow<AnyNode, CanvasWire>();
  const root = useRef<HTMLDivElement>(null);
  const menu = useCanvasMenu(flow.screenToFlowPosition);
  const panOnScroll = useWheel(root);
  const drop = useFileDrop(flow.screenToFlowPosition);
  const handlers = useGestures(flow.screenToFlowPosition, flow.flowToScreenPosition);
  const revealing = useReveal(root);
  useKeptView(revealing);
  useScale();
  useShownPlace();
  const [fit] = useState(() => ({ padding: FIT_PADDING, maxZoom: uiScale() }));
  useLongPress(root);
  useWireTarget();
  useLegibleLabels(root);
  useCanvasCenter(root, flow.screenToFlowPosition);
  const far = useFlowStore((state) => state.transform[2] < FAR_ZOOM);
  const detail = useFlowStore((state) => detailOf(state.transform[2], nodes.length));
  const [copyOf] = useState(createCopies<AnyNode>);
  const all = useMemo(() => {
    const view = [...items, ...nodes, ...reroutes, ...borders];
    return detail === 'overview' ? view.map(copyOf) : view;
  }, [items, nodes, reroutes, borders, detail, copyOf]);

  return (
    <div
      ref={root}
      tabIndex={-1}
      className={`canvas${far ? ' canvas-far' : ''}${detail === 'heads' ? ' canvas-heads' : ''}`}
      {...drop.handlers}
    >
      <CostsProvider>
        <DetailProvider value={detail}>
          <ReactFlow<AnyNode, CanvasWire>
            nodes={all}
            edges={detail === 'overview' ? NO_WIRES : wires}
            nodeTypes={NODE_TYPES}
            edgeTypes={WIRE_VIEWS}
            connectionLineComponent={PendingWire}
            onNodesChange={handlers.onNodesChange}
            onEdgesChange={handlers.onWiresChange}
            onConnect={handlers.onConnect}
            onConnectStart={handlers.onConnectStart}
            onConnectEnd={handlers.onConnectEnd}
            onReconnectStart={handlers.onReconnectStart}
            onReconnect={handlers.onReconnect}
            onReconnectEnd={handlers.onReconnectEnd}
            isValidConnection={handlers.isValidConnection}
            onNodeMouseEnter={handlers.onNodeEnter}
            onNodeMouseLeave={handlers.onNodeLeave}
            onNodeContextMenu={menu.onNode}
            onEdgeContextMenu={menu.onWire}
            onPaneContextMenu={menu.onPane}
            onNodeClick={handlers.onNodeClick}
            onNodeDoubleClick={handlers.onNodeDoubleClick}
            onEdgeDoubleClick={handlers.onWireDoubleClick}
            onDoubleClick={handlers.onDoubleClick}
            connectionRadius={24}
            reconnectRadius={14}
            onlyRenderVisibleElements
            elevateNodesOnSelect={false}
            snapToGrid
            snapGrid={SNAP}
            minZoom={0.1}
            maxZoom={2.5}
            fitView
            fitViewOptions={fit}
            panOnDrag={[1]}
            panOnScroll={panOnScroll}
            panOnScrollSpeed={1}
            zoomOnScroll={!panOnScroll}
            zoomOnDoubleClick={false}
            selectionOnDrag
            selectionMode={SelectionMode.Partial}
            multiSelectionKeyCode={['Shift', 'Control', 'Meta']}
            selectionKeyCode={null}
            deleteKeyCode={null}
            proOptions={{ hideAttribution: true }}
            ariaLabelConfig={ARIA_LABELS}
            aria-label="Graph"
          >
            <Background variant={BackgroundVariant.Dots} gap={24} size={1.2} color="var(--canvas-dot)" />
            {nodes.length >= FEWEST_ON_MINIMAP && (
              <MiniMap<AnyNode>
                position="bottom-right"
                pannable
                zoomable
                ariaLabel="Minimap"
                nodeColor={minimapColor}
                nodeBorderRadius={6}
                maskColor="var(--minimap-mask)"
              />
            )}
            <CanvasControls />
            <ConnectionHint />
            <Breadcrumb />
            <PerformancePanel />
            {detail === 'overview' && <OverviewWires nodes={nodes} reroutes={reroutes} wires={wires} />}
          </ReactFlow>
        </DetailProvider>
      </CostsProvider>
      <FirstSteps isEmpty={all.length === 0} />
      {drop.over && <div className="canvas-drop">Drop models, images or ISF shaders here</div>}
      <CanvasMenu menu={menu.open} onClose={menu.close} />
      <PaletteHost toCanvas={flow.screenToFlowPosition} canvas={root} />
    </div>
  );
}

function minimapColor(node: AnyNode): string {
  if (node.type !== 'scrim') return 'var(--minimap-mask)';
  return node.data.type ? WIRE_TYPES[node.data.type].color : 'var(--line-strong)';
}
