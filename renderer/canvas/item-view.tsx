import { type NodeProps, NodeResizer } from '@xyflow/react';
import { memo } from 'react';
import { useEditor } from '../shell/editor-context.ts';
import { endGesture } from '../state/apply.ts';
import { showResized } from '../state/canvas.ts';
import { editItemText, resizeItem } from '../state/layout-items.ts';
import './item-view.css';
import type { ItemNode } from './project-items.ts';

/** A frame around nodes: what lies in it goes where it goes. */
export const FrameView = memo(function FrameView({ id, data, selected }: NodeProps<ItemNode>) {
  const editor = useEditor();
  return (
    <div className={selected ? 'frame frame-selected' : 'frame'} data-item={id}>
      <Resizer id={id} selected={selected} minWidth={120} minHeight={72} />
      <div className="frame-head">
        <input
          className="frame-title nodrag"
          aria-label="Title of the frame"
          spellCheck={false}
          value={data.text}
          onChange={(event) => editItemText(editor, id, event.target.value)}
          onBlur={() => endGesture(editor)}
        />
      </div>
    </div>
  );
});

/** A text beside the nodes. */
export const NoteView = memo(function NoteView({ id, data, selected }: NodeProps<ItemNode>) {
  const editor = useEditor();
  return (
    <div className={selected ? 'note note-selected' : 'note'} data-item={id}>
      <Resizer id={id} selected={selected} minWidth={96} minHeight={56} />
      <textarea
        className="note-text nodrag nowheel"
        aria-label="Text of the note"
        placeholder="A note"
        value={data.text}
        onChange={(event) => editItemText(editor, id, event.target.value)}
        onBlur={() => endGesture(editor)}
      />
    </div>
  );
});

interface ResizerProps {
  readonly id: string;
  readonly selected: boolean;
  readonly minWidth: number;
  readonly minHeight: number;
}

function Resizer({ id, selected, minWidth, minHeight }: ResizerProps) {
  const editor = useEditor();
  return (
    <NodeResizer
      isVisible={selected}
      minWidth={minWidth}
      minHeight={minHeight}
      onResize={(_, box) => showResized(editor.canvas, { id, ...box })}
      onResizeEnd={(_, box) => {
        showResized(editor.canvas, null);
        resizeItem(editor, id, box);
      }}
    />
  );
}
