import type { Connection, Edge, EdgeChange, FinalConnectionState, HandleType, NodeChange } from '@xyflow/react';
import { type MouseEvent as ReactMouseEvent, useCallback, useRef } from 'react';
import { subgraphName } from '../../export/graph/names.ts';
import { useEditor } from '../shell/editor-context.ts';
import { dragTo, dropWire, endDrag, hoverWire, offerParams, type Place } from '../state/canvas.ts';
import { layoutOf, nodeOf } from '../state/document.ts';
import { connect, explainRefusal, refusalOf, removeWires, rewire, takeWireFrom, type WireEnd } from '../state/edit-graph.ts';
import type { Editor } from '../state/editor.ts';
import { dropOnWire, layOver } from '../state/insert-on-wire.ts';
import { boxOfItem, contentOf, itemOf, moveAll } from '../state/layout-items.ts';
import { changeSelection, type SelectionChange } from '../state/selection.ts';
import { openSubgraph } from '../state/subgraphs.ts';
import { HEADER_HEIGHT, NODE_WIDTH } from './node-shape.ts';
import type { CanvasNode } from './project-canvas.ts';
import type { ItemNode } from './project-items.ts';
import type { CanvasWire } from './project-wires.ts';
import { wireBehind } from './wire-behind.ts';

/** What pointer and keys on the canvas do: selection, wires, places. */
export function useGestures(toCanvas: (client: Place) => Place, toClient: (canvas: Place) => Place) {
  const editor = useEditor();
  const onNodesChange = useCallback(
    (changes: NodeChange<CanvasNode | ItemNode>[]) => {
      changeSelection(editor.selection, selectionChanges('node', changes));
      const moved = changes.filter((change) => change.type === 'position');
      const places: Record<string, Place> = {};
      for (const { id, position } of moved) if (position) Object.assign(places, withContent(editor, id, position), { [id]: position });
      if (moved.length === 0) return;
      dragTo(editor.canvas, places);
      const [only] = moved.length === 1 ? moved : [];
      // React Flow's arrow keys move without dragging; a drag's last change has none either.
      if (moved.some((change) => change.dragging === true)) {
        hoverWire(editor.canvas, only?.position ? wireBehind(editor, only.id, toClient(only.position)) : null);
        return;
      }
      const { wireUnder } = editor.canvas.getState();
      const dragged = endDrag(editor.canvas);
      const place = only && dragged[only.id];
      if (only && place && wireUnder !== null) dropOnWire(editor, only.id, place, wireUnder);
      else moveAll(editor, dragged);
    },
    [editor, toClient],
  );
  const onWiresChange = useCallback(
    (changes: EdgeChange<CanvasWire>[]) => changeSelection(editor.selection, selectionChanges('wire', changes)),
    [editor],
  );
  /** An end of a wire that is there is in hand; React Flow tells of it as of a new one, too. */
  const rewiring = useRef(false);
  const onReconnectStart = useCallback(() => {
    rewiring.current = true;
  }, []);
  const isValidConnection = useCallback(
    (connection: Connection | Edge) => {
      const ends = endsOf(connection);
      return ends !== null && refusalOf(editor, { ...ends.from, side: 'output' }, { ...ends.to, side: 'input' }) === null;
    },
    [editor],
  );
  const onConnect = useCallback(
    (connection: Connection) => {
      const ends = endsOf(connection);
      if (ends) connect(editor, ends.from, ends.to);
    },
    [editor],
  );
  const onConnectStart = useCallback(
    (_event: MouseEvent | TouchEvent, start: { nodeId: string | null; handleId: string | null; handleType: HandleType | null }) => {
      if (start.nodeId === null || start.handleId === null) return;
      takeWireFrom(editor, start.nodeId, start.handleId, start.handleType === 'source' ? 'output' : 'input');
    },
    [editor],
  );
  const onConnectEnd = useCallback(
    (event: MouseEvent | TouchEvent, end: FinalConnectionState) => {
      const { inHand, wireUnder } = editor.canvas.getState();
      dropWire(editor.canvas);
      if (inHand === null || end.isValid === true) return;
      const client = clientOf(event);
      if (wireUnder !== null && !end.toHandle && !rewiring.current) {
        const { x, y } = toCanvas(client);
        layOver(editor, inHand, wireUnder, { x: x - NODE_WIDTH / 2, y: y - HEADER_HEIGHT });
        return;
      }
      if (end.toHandle) explainRefusal(editor, inHand, endOf(end.toHandle));
      else if (onPane(event) && !rewiring.current) editor.ui.setState({ palette: { at: client, place: toCanvas(client), end: inHand } });
    },
    [editor, toCanvas],
  );
  const onReconnect = useCallback(
    (wire: CanvasWire, connection: Connection) => {
      const ends = endsOf(connection);
      if (ends) rewire(editor, wire.id, ends.from, ends.to);
    },
    [editor],
  );
  const onReconnectEnd = useCallback(
    (_event: MouseEvent | TouchEvent, wire: CanvasWire, _type: HandleType, end: FinalConnectionState) => {
      rewiring.current = false;
      // Pulled off and let go over nothing: the usual way to take a wire away.
      if (end.isValid !== true && !end.toHandle) removeWires(editor, [wire.id]);
    },
    [editor],
  );
  const onNodeEnter = useCallback(
    (_event: unknown, node: CanvasNode | ItemNode) => {
      if (editor.canvas.getState().inHand?.side === 'output') offerParams(editor.canvas, node.id);
    },
    [editor],
  );
  const onNodeLeave = useCallback(() => offerParams(editor.canvas, null), [editor]);
  const onNodeDoubleClick = useCallback(
    (_event: unknown, { id }: CanvasNode | ItemNode) => {
      const name = subgraphName(nodeOf(editor.document.getState(), id)?.type ?? '');
      if (name !== null) openSubgraph(editor, name);
    },
    [editor],
  );
  /** Double-clicked, a wire asks for a node to go through. */
  const onWireDoubleClick = useCallback(
    (event: ReactMouseEvent, { id }: CanvasWire) => {
      const client = { x: event.clientX, y: event.clientY };
      editor.ui.setState({ palette: { at: client, place: toCanvas(client), end: null, wire: id } });
    },
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
    onNodeDoubleClick,
    onWireDoubleClick,
    onDoubleClick,
  };
}

function endOf({ nodeId, id, type }: { readonly nodeId: string; readonly id?: string | null; readonly type: HandleType }): WireEnd {
  return { node: nodeId, port: id ?? '', side: type === 'source' ? 'output' : 'input' };
}

/** From output to input, whichever of them the gesture began at. */
function endsOf({ source, sourceHandle, target, targetHandle }: Connection | Edge) {
  if (!sourceHandle || !targetHandle) return null;
  return { from: { node: source, port: sourceHandle }, to: { node: target, port: targetHandle } };
}

/** Where what lies in a dragged frame is then. */
function withContent(editor: Editor, id: string, { x, y }: Place): Readonly<Record<string, Place>> {
  const frame = boxOfItem(layoutOf(editor.document.getState()), id);
  if (!frame) return {};
  const content = Object.entries(contentOf(editor, id));
  return Object.fromEntries(content.map(([inside, place]) => [inside, { x: place.x + x - frame.x, y: place.y + y - frame.y }]));
}

function selectionChanges(
  kind: 'node' | 'wire',
  changes: readonly (NodeChange<CanvasNode | ItemNode> | EdgeChange<CanvasWire>)[],
): SelectionChange[] {
  return changes.flatMap((change) =>
    change.type === 'select' ? [{ kind: itemOf(change.id) === null ? kind : 'item', id: change.id, selected: change.selected }] : [],
  );
}

function clientOf(event: MouseEvent | TouchEvent): Place {
  const point = 'changedTouches' in event ? event.changedTouches[0] : event;
  return { x: point?.clientX ?? 0, y: point?.clientY ?? 0 };
}

function onPane(event: MouseEvent | TouchEvent): boolean {
  const { x, y } = clientOf(event);
  return document.elementFromPoint(x, y)?.classList.contains('react-flow__pane') ?? false;
}
