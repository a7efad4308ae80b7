import {
  type Connection,
  type Edge,
  type EdgeChange,
  type FinalConnectionState,
  type HandleType,
  type NodeChange,
  useStoreApi,
} from '@xyflow/react';
import { type MouseEvent as ReactMouseEvent, useCallback, useRef } from 'react';
import { subgraphName } from '../../export/graph/document-names.ts';
import { printWire } from '../../export/graph/wires.ts';
import { dragTo, dropWire, endDrag, hoverWire, offerParams, type Place } from '../state/editor/canvas-state.ts';
import { layoutOf, nodeOf } from '../state/editor/document.ts';
import type { Editor } from '../state/editor/editor.ts';
import { useEditor } from '../state/editor/editor-context.ts';
import { borderOf, itemOf } from '../state/editor/item-ids.ts';
import { changeSelection, type SelectionChange, selectOnly } from '../state/editor/selection.ts';
import { connectPorts, explainRefusal, reconnectPorts, refusalOfEnds, startWireAt } from '../state/graph/connect-ports.ts';
import { dropOnNode } from '../state/graph/drop-on-node.ts';
import { removeWires } from '../state/graph/edit-graph.ts';
import { compositeOver, dropOnWire } from '../state/graph/insert-on-wire.ts';
import { boxOfItem, contentOf, moveAll } from '../state/graph/layout-items.ts';
import { HEADER_HEIGHT, NODE_WIDTH } from '../state/graph/node-shape.ts';
import { addReroute, findStretch, wiresOfStretch } from '../state/graph/reroutes.ts';
import { canExpose, openSubgraph, setPortExposed } from '../state/graph/subgraphs.ts';
import { nodeAt } from './connection-hint.tsx';
import { NEW_PORT } from './project-borders.ts';
import type { CanvasWire } from './project-wires.ts';
import { useCancelGesture } from './use-cancel-gesture.ts';
import type { AnyNode } from './use-canvas-view.ts';
import { wireBehind } from './wire-behind.ts';

export type ToCanvas = (client: Place, options?: { readonly snapToGrid: boolean }) => Place;

/** Option of `ToCanvas` that does not snap to the grid, so that a new reroute lies on the wire. */
export const UNSNAPPED = { snapToGrid: false };

/** Handlers of React Flow that turn gestures into commands: selection, wires and positions. */
export function useGestures(toCanvas: ToCanvas, toClient: (canvas: Place) => Place) {
  const editor = useEditor();
  const canceling = useCancelGesture();
  const onNodesChange = useCallback(
    (changes: NodeChange<AnyNode>[]) => {
      if (canceling.current) return;
      changeSelection(editor.selection, nodeChanges(changes));
      const moved = changes.filter((change) => change.type === 'position');
      const places: Record<string, Place> = {};
      for (const { id, position } of moved) if (position) Object.assign(places, withContent(editor, id, position), { [id]: position });
      if (moved.length === 0) return;
      dragTo(editor.canvas, places);
      const [only] = moved.length === 1 ? moved : [];
      // Moves by arrow keys, and the last change of a drag, have `dragging` unset.
      if (moved.some((change) => change.dragging === true)) {
        const isNode = only !== undefined && itemOf(only.id) === null && borderOf(only.id) === null;
        hoverWire(editor.canvas, isNode && only.position ? wireBehind(editor, only.id, toClient(only.position)) : null);
        return;
      }
      const { wireUnder } = editor.canvas.getState();
      const dragged = endDrag(editor.canvas);
      const place = only && dragged[only.id];
      if (only && place && wireUnder !== null) dropOnWire(editor, only.id, place, wireUnder);
      else moveAll(editor, dragged);
    },
    [editor, canceling, toClient],
  );
  const flowStore = useStoreApi();
  const onWiresChange = useCallback(
    (changes: EdgeChange<CanvasWire>[]) => {
      const { userSelectionActive } = flowStore.getState();
      changeSelection(editor.selection, wireChanges(editor, changes, userSelectionActive));
    },
    [editor, flowStore],
  );
  /** Whether an existing wire is being reconnected. React Flow reports that as a new connection, too. */
  const rewiring = useRef(false);
  const onReconnectStart = useCallback(() => {
    rewiring.current = true;
  }, []);
  const isValidConnection = useCallback(
    (connection: Connection | Edge) => {
      const ends = endsOf(connection);
      if (ends === null) return false;
      const exposure = exposureOf(ends);
      if (exposure !== null) return canExpose(editor, exposure.side, exposure.port);
      return refusalOfEnds(editor, ends.from, ends.to) === null;
    },
    [editor],
  );
  const onConnect = useCallback(
    (connection: Connection) => {
      const ends = endsOf(connection);
      if (ends === null || canceling.current) return;
      const exposure = exposureOf(ends);
      if (exposure === null) connectPorts(editor, ends.from, ends.to);
      else setPortExposed(editor, exposure.side, exposure.port, true);
    },
    [editor, canceling],
  );
  const onConnectStart = useCallback(
    (_event: MouseEvent | TouchEvent, start: { nodeId: string | null; handleId: string | null; handleType: HandleType | null }) => {
      if (start.nodeId === null || start.handleId === null || borderOf(start.nodeId) !== null) return;
      startWireAt(editor, { node: start.nodeId, port: start.handleId }, start.handleType === 'source' ? 'output' : 'input');
    },
    [editor],
  );
  const onConnectEnd = useCallback(
    (event: MouseEvent | TouchEvent, end: FinalConnectionState) => {
      const { draggedWire, wireUnder } = editor.canvas.getState();
      dropWire(editor.canvas);
      if (draggedWire === null || end.isValid === true || canceling.current) return;
      if (end.toHandle && borderOf(end.toHandle.nodeId) !== null) return;
      const client = clientOf(event);
      // Near a port that refuses it, the marked wire takes it.
      if (wireUnder !== null && !rewiring.current) {
        const { x, y } = toCanvas(client);
        compositeOver(editor, draggedWire, wireUnder, { x: x - NODE_WIDTH / 2, y: y - HEADER_HEIGHT });
        return;
      }
      if (end.toHandle) explainRefusal(editor, draggedWire, end.toHandle);
      else if (rewiring.current) return;
      else if (onPane(event)) editor.ui.setState({ palette: { at: client, place: toCanvas(client), end: draggedWire } });
      else dropOnNode(editor, draggedWire, nodeAt(client));
    },
    [editor, canceling, toCanvas],
  );
  const onReconnect = useCallback(
    (wire: CanvasWire, connection: Connection) => {
      const ends = endsOf(connection);
      if (ends && !canceling.current) reconnectPorts(editor, wire.id, ends.from, ends.to);
    },
    [editor, canceling],
  );
  const onReconnectEnd = useCallback(
    (_event: MouseEvent | TouchEvent, wire: CanvasWire, _type: HandleType, end: FinalConnectionState) => {
      rewiring.current = false;
      // Dropped on nothing: disconnects the wire.
      if (end.isValid !== true && !end.toHandle && !canceling.current)
        removeWires(editor, wiresOfStretch(editor.document.getState(), wire.id));
    },
    [editor, canceling],
  );
  const onNodeEnter = useCallback(
    (_event: unknown, node: AnyNode) => {
      if (editor.canvas.getState().draggedWire?.side === 'output') offerParams(editor.canvas, node.id);
    },
    [editor],
  );
  const onNodeLeave = useCallback(() => offerParams(editor.canvas, null), [editor]);
  /** React Flow keeps a selection when one of its nodes is clicked, so that it can be dragged. */
  const onNodeClick = useCallback(
    ({ shiftKey, ctrlKey, metaKey }: ReactMouseEvent, { id }: AnyNode) => {
      const { nodes } = editor.selection.getState();
      if (!shiftKey && !ctrlKey && !metaKey && nodes.size > 1 && nodes.has(id)) selectOnly(editor.selection, [id]);
    },
    [editor],
  );
  const onNodeDoubleClick = useCallback(
    (_event: unknown, { id }: AnyNode) => {
      const name = subgraphName(nodeOf(editor.document.getState(), id)?.type ?? '');
      if (name !== null) openSubgraph(editor, name);
    },
    [editor],
  );
  const onWireDoubleClick = useCallback(
    (event: ReactMouseEvent, { id }: CanvasWire) =>
      void addReroute(editor, id, toCanvas({ x: event.clientX, y: event.clientY }, UNSNAPPED)),
    [editor, toCanvas],
  );
  const onDoubleClick = useCallback(
    (event: ReactMouseEvent) => {
      if (!onPane(event.nativeEvent)) return;
      const client = { x: event.clientX, y: event.clientY };
      editor.ui.setState({ palette: { at: client, place: toCanvas(client), end: null } });
    },
    [editor, toCanvas],
  );
  return {
    onNodesChange,
    onWiresChange,
    isValidConnection,
    onConnect,
    onConnectStart,
    onConnectEnd,
    onReconnectStart,
    onReconnect,
    onReconnectEnd,
    onNodeEnter,
    onNodeLeave,
    onNodeClick,
    onNodeDoubleClick,
    onWireDoubleClick,
    onDoubleClick,
  };
}

/** Output and input of a connection; null without both handles. */
function endsOf({ source, sourceHandle, target, targetHandle }: Connection | Edge) {
  if (!sourceHandle || !targetHandle) return null;
  return { from: { node: source, port: sourceHandle }, to: { node: target, port: targetHandle } };
}

/** The port that a wire from or to the border of a subgraph exposes; null for other wires. */
function exposureOf({ from, to }: NonNullable<ReturnType<typeof endsOf>>) {
  if (from.port === NEW_PORT && borderOf(from.node) !== null) return { side: 'inputs', port: to } as const;
  if (to.port === NEW_PORT && borderOf(to.node) !== null) return { side: 'outputs', port: from } as const;
  return null;
}

/** New positions of the nodes in a dragged frame. */
function withContent(editor: Editor, id: string, { x, y }: Place): Readonly<Record<string, Place>> {
  const frame = boxOfItem(layoutOf(editor.document.getState()), id);
  if (!frame) return {};
  const content = Object.entries(contentOf(editor, id));
  return Object.fromEntries(content.map(([inside, place]) => [inside, { x: place.x + x - frame.x, y: place.y + y - frame.y }]));
}

function nodeChanges(changes: readonly NodeChange<AnyNode>[]): SelectionChange[] {
  return changes.flatMap((change): SelectionChange[] => {
    if (change.type !== 'select') return [];
    const isItem = itemOf(change.id) !== null || borderOf(change.id) !== null;
    return [{ kind: isItem ? 'item' : 'node', id: change.id, selected: change.selected }];
  });
}

/**
 * Converts changes that React Flow reports for stretches to changes of the wire selection. Removals come first: a press on another
 * stretch of a selected wire deselects the old stretch and selects the new one, and the wire must stay selected. A selection box adds a
 * wire only together with one of its nodes: with a reroute alone, Delete would remove the wire as well.
 */
function wireChanges(editor: Editor, changes: readonly EdgeChange<CanvasWire>[], byBox: boolean): SelectionChange[] {
  const state = editor.document.getState();
  const { nodes } = editor.selection.getState();
  const of = (selected: boolean) =>
    changes.flatMap((change): SelectionChange[] => {
      if (change.type !== 'select' || change.selected !== selected) return [];
      const wires = findStretch(state, change.id)?.wires ?? [];
      const meant = byBox && selected ? wires.filter(({ from, to }) => nodes.has(from.node) || nodes.has(to.node)) : wires;
      return meant.map((wire) => ({ kind: 'wire', id: printWire(wire), selected }));
    });
  return [...of(false), ...of(true)];
}

/** Place of the pointer, or of the first finger that the event is about, in client pixels. */
export function clientOf(event: MouseEvent | TouchEvent): Place {
  const point = 'changedTouches' in event ? event.changedTouches[0] : event;
  return { x: point?.clientX ?? 0, y: point?.clientY ?? 0 };
}

function onPane(event: MouseEvent | TouchEvent): boolean {
  const { x, y } = clientOf(event);
  return document.elementFromPoint(x, y)?.classList.contains('react-flow__pane') ?? false;
}
