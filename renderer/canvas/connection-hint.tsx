import { useConnection, useStore as useFlowStore } from '@xyflow/react';
import { createPortal } from 'react-dom';
import { useEditor } from '../shell/editor-context.ts';
import { refusalOver } from '../state/join-ends.ts';

const OFFSET_PX = 16;

/** While a wire hangs over a port that cannot take it: why not, beside the pointer. */
export function ConnectionHint() {
  const editor = useEditor();
  const connection = useConnection();
  const pane = useFlowStore((state) => state.domNode);
  if (!connection.inProgress || connection.isValid !== false || !connection.toHandle || !pane) return null;
  const { inHand } = editor.canvas.getState();
  const reason = inHand && refusalOver(editor, inHand, connection.toHandle);
  if (!reason) return null;
  const box = pane.getBoundingClientRect();
  return createPortal(
    <div
      className="connection-hint"
      role="status"
      style={{ left: box.left + connection.pointer.x + OFFSET_PX, top: box.top + connection.pointer.y + OFFSET_PX }}
    >
      {reason.message}
    </div>,
    document.body,
  );
}
