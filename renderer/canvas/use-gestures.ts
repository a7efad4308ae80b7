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
import { subgraphName } from '../../export/graph/names.ts';
import { printWire } from '../../export/graph/wires.ts';
import { useEditor } from '../shell/editor-context.ts';
import { dragTo, dropWire, endDrag, hoverWire, offerParams, type Place } from '../state/canvas.ts';
import { layoutOf, nodeOf } from '../state/document.ts';
import { dropOnNode } from '../state/drop-on-node.ts';
import { removeWires } from '../state/edit-graph.ts';
import type { Editor } from '../state/editor.ts';
import { dropOnWire, layOver } from '../state/insert-on-wire.ts';
import { itemOf } from '../state/item-ids.ts';
import { explainRefusal, joinEnds, refusalOfEnds, rejoinEnds, takeEnd } from '../state/join-ends.ts';
import { boxOfItem, contentOf, moveAll } from '../state/layout-items.ts';
import { addReroute, stretchCalled, wiresOfStretch } from '../state/reroutes.ts';
import { changeSelection, type SelectionChange } from '../state/selection.ts';
import { openSubgraph } from '../state/subgraphs.ts';
import { nodeAt } from './node-at.ts';
import { HEADER_HEIGHT, NODE_WIDTH } from './node-shape.ts';
import type { CanvasWire } from './project-wires.ts';
import type { AnyNode } from './use-canvas-view.ts';
import { useGiveUp } from './use-give-up.ts';
import { wireBehind } from './wire-behind.ts';

export type ToCanvas = (client: Place, options?: { readonly snapToGrid: boolean }) => Place;

/** The wire stays where it runs. */
export const WHERE_IT_IS = { snapToGrid: false };

/** What pointer and keys on the canvas do: selection, wires, places. */
export function useGestures(toCanvas: ToCanvas, toClient: (canvas: Place) => Place) {
  const editor = useEditor();
  const givingUp = useGiveUp();
  const onNodesChange = useCallback(
    (changes: NodeChange<AnyNode>[]) => {
      if (givingUp.current) return;
      changeSelection(editor.selection, nodeChanges(changes));
      const moved = changes.filter((change) => change.type === 'position');
      const places: Record<string, Place> = {};
      for (const { id, position } of moved) if (position) Object.assign(places, withContent(editor, id, position), { [id]: position });
      if (moved.length === 0) return;
      dragTo(editor.canvas, places);
      const [only] = moved.length === 1 ? moved : [];
      // React Flow's arrow keys move without dragging; a drag's last change has none either.
      if (moved.some((change) => change.dragging === true)) {
        const isNode = only !== undefined && itemOf(only.id) === null;
        hoverWire(editor.canvas, isNode && only.position ? wireBehind(editor, only.id, toClient(only.position)) : null);
        return;
      }
      const { wireUnder } = editor.canvas.getState();
      const dragged = endDrag(editor.canvas);
      const place = only && dragged[only.id];
      if (only && place && wireUnder !== null) dropOnWire(editor, only.id, place, wireUnder);
      else moveAll(editor, dragged);
    },
    [editor, givingUp, toClient],
  );
  const flowStore = useStoreApi();
  const onWiresChange = useCallback(
    (changes: EdgeChange<CanvasWire>[]) => {
      const { userSelectionActive } = flowStore.getState();
      changeSelection(editor.selection, wireChanges(editor, changes, userSelectionActive));
    },
    [editor, flowStore],
  );
  /** An end of a wire that is there is in hand; React Flow tells of it as of a new one, too. */
  const rewiring = useRef(false);
  const onReconnectStart = useCallback(() => {
    rewiring.current = true;
  }, []);
  const isValidConnection = useCallback(
    (connection: Connection | Edge) => {
      const ends = endsOf(connection);
      return ends !== null && refusalOfEnds(editor, ends.from, ends.to) === null;
    },
    [editor],
  );
  const onConnect = useCallback(
    (connection: Connection) => {
      const ends = endsOf(connection);
      if (ends && !givingUp.current) joinEnds(editor, ends.from, ends.to);
    },
    [editor, givingUp],
  );
  const onConnectStart = useCallback(
    (_event: MouseEvent | TouchEvent, start: { nodeId: string | null; handleId: string | null; handleType: HandleType | null }) => {
      if (start.nodeId === null || start.handleId === null) return;
      takeEnd(editor, { node: start.nodeId, port: start.handleId }, start.handleType === 'source' ? 'output' : 'input');
    },
    [editor],
  );
  const onConnectEnd = useCallback(
    (event: MouseEvent | TouchEvent, end: FinalConnectionState) => {
      const { inHand, wireUnder } = editor.canvas.getState();
      dropWire(editor.canvas);
      if (inHand === null || end.isValid === true || givingUp.current) return;
      const client = clientOf(event);
      if (wireUnder !== null && !end.toHandle && !rewiring.current) {
        const { x, y } = toCanvas(client);
        layOver(editor, inHand, wireUnder, { x: x - NODE_WIDTH / 2, y: y - HEADER_HEIGHT });
        return;
      }
      if (end.toHandle) explainRefusal(editor, inHand, end.toHandle);
      else if (rewiring.current) return;
      else if (onPane(event)) editor.ui.setState({ palette: { at: client, place: toCanvas(client), end: inHand } });
      else dropOnNode(editor, inHand, nodeAt(client));
    },
    [editor, givingUp, toCanvas],
  );
  const onReconnect = useCallback(
    (wire: CanvasWire, connection: Connection) => {
      const ends = endsOf(connection);
      if (ends && !givingUp.current) rejoinEnds(editor, wire.id, ends.from, ends.to);
    },
    [editor, givingUp],
  );
  const onReconnectEnd = useCallback(
    (_event: MouseEvent | TouchEvent, wire: CanvasWire, _type: HandleType, end: FinalConnectionState) => {
      rewiring.current = false;
      // Pulled off and let go over nothing: the usual way to take a wire away.
      if (end.isValid !== true && !end.toHandle && !givingUp.current)
        removeWires(editor, wiresOfStretch(editor.document.getState(), wire.id));
    },
    [editor, givingUp],
  );
  const onNodeEnter = useCallback(
    (_event: unknown, node: AnyNode) => {
      if (editor.canvas.getState().inHand?.side === 'output') offerParams(editor.canvas, node.id);
    },
    [editor],
  );
  const onNodeLeave = useCallback(() => offerParams(editor.canvas, null), [editor]);
  const onNodeDoubleClick = useCallback(
    (_event: unknown, { id }: AnyNode) => {
      const name = subgraphName(nodeOf(editor.document.getState(), id)?.type ?? '');
      if (name !== null) openSubgraph(editor, name);
    },
    [editor],
  );
  const onWireDoubleClick = useCallback(
    (event: ReactMouseEvent, { id }: CanvasWire) =>
      void addReroute(editor, id, toCanvas({ x: event.clientX, y: event.clientY }, WHERE_IT_IS)),
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

function nodeChanges(changes: readonly NodeChange<AnyNode>[]): SelectionChange[] {
  return changes.flatMap((change): SelectionChange[] => {
    if (change.type !== 'select') return [];
    return [{ kind: itemOf(change.id) === null ? 'node' : 'item', id: change.id, selected: change.selected }];
  });
}

/**
 * The wires of what was selected or no more. What is taken away comes first: a press on another stretch of a wire takes its last one
 * away. A box around nodes brings their wires with it; one around a reroute alone does not, or Delete would take the wire as well.
 */
function wireChanges(editor: Editor, changes: readonly EdgeChange<CanvasWire>[], byBox: boolean): SelectionChange[] {
  const state = editor.document.getState();
  const { nodes } = editor.selection.getState();
  const of = (selected: boolean) =>
    changes.flatMap((change): SelectionChange[] => {
      if (change.type !== 'select' || change.selected !== selected) return [];
      const wires = stretchCalled(state, change.id)?.wires ?? [];
      const meant = byBox && selected ? wires.filter(({ from, to }) => nodes.has(from.node) || nodes.has(to.node)) : wires;
      return meant.map((wire) => ({ kind: 'wire', id: printWire(wire), selected }));
    });
  return [...of(false), ...of(true)];
}

function clientOf(event: MouseEvent | TouchEvent): Place {
  const point = 'changedTouches' in event ? event.changedTouches[0] : event;
  return { x: point?.clientX ?? 0, y: point?.clientY ?? 0 };
}

function onPane(event: MouseEvent | TouchEvent): boolean {
  const { x, y } = clientOf(event);
  return document.elementFromPoint(x, y)?.classList.contains('react-flow__pane') ?? false;
}
