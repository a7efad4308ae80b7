import { useConnection, useStore as useFlowStore } from '@xyflow/react';
import { createPortal } from 'react-dom';
import type { Place } from '../state/editor/canvas-state.ts';
import { useEditor } from '../state/editor/editor-context.ts';
import { borderOf, itemOf } from '../state/editor/item-ids.ts';
import { refusalOver } from '../state/graph/connect-ports.ts';
import { portOver } from '../state/graph/drop-on-node.ts';

const OFFSET_PX = 16;

/** Text beside the pointer while a wire is dragged: over a port, why it refuses the wire; over a node, which port would take it. */
export function ConnectionHint() {
  const editor = useEditor();
  const connection = useConnection();
  const pane = useFlowStore((state) => state.domNode);
  const { draggedWire } = editor.canvas.getState();
  if (!connection.inProgress || !draggedWire || !pane) return null;
  const box = pane.getBoundingClientRect();
  const at = { x: box.left + connection.pointer.x, y: box.top + connection.pointer.y };
  const hint = hintAt();
  if (!hint) return null;
  return createPortal(
    <div className="connection-hint" data-refused={hint.refused} role="status" style={{ left: at.x + OFFSET_PX, top: at.y + OFFSET_PX }}>
      {hint.text}
    </div>,
    document.body,
  );

  function hintAt() {
    if (!draggedWire) return null;
    if (connection.toHandle) {
      if (borderOf(connection.toHandle.nodeId) !== null) return null;
      const reason = connection.isValid === false && refusalOver(editor, draggedWire, connection.toHandle);
      return reason ? { text: reason.message, refused: true } : null;
    }
    const node = nodeAt(at);
    const port = node === null ? null : portOver(editor, draggedWire, node);
    return port && { text: draggedWire.side === 'output' ? `Connect to ${port.label}` : `Connect from ${port.label}`, refused: false };
  }
}

/** Id of the topmost node at a place in client pixels; null if there is none. Frames, notes, reroutes and borders do not count. */
export function nodeAt({ x, y }: Place): string | null {
  const id = document.elementFromPoint(x, y)?.closest('.react-flow__node')?.getAttribute('data-id') ?? null;
  return id === null || itemOf(id) !== null || borderOf(id) !== null ? null : id;
}
