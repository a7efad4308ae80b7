import { type NodeProps, NodeResizer } from '@xyflow/react';
import { memo } from 'react';
import { endGesture } from '../state/document/apply.ts';
import { showResized } from '../state/editor/canvas-state.ts';
import { useEditor } from '../state/editor/editor-context.ts';
import { editItemText, resizeItem } from '../state/graph/layout-items.ts';
import './item-view.css';
import type { ItemNode } from './project-items.ts';

/** A node frame: a titled rectangle that moves the nodes in it. */
export const FrameView = memo(function FrameView({ id, data, selected }: NodeProps<ItemNode>) {
  const editor = useEditor();
  return (
    <div className={selected ? 'frame frame-selected' : 'frame'} data-item={id}>
      <Resizer id={id} selected={selected} minWidth={120} minHeight={72} />
      <div className="frame-head">
        <input
          className="frame-title nodrag"
          aria-label="Frame title"
          spellCheck={false}
          value={data.text}
          onChange={(event) => editItemText(editor, id, event.target.value)}
          onBlur={() => endGesture(editor)}
        />
      </div>
    </div>
  );
});

/** A text note beside the nodes. */
export const NoteView = memo(function NoteView({ id, data, selected }: NodeProps<ItemNode>) {
  const editor = useEditor();
  return (
    <div className={selected ? 'note note-selected' : 'note'} data-item={id}>
      <Resizer id={id} selected={selected} minWidth={96} minHeight={56} />
      <textarea
        className="note-text nodrag nowheel"
        aria-label="Note text"
        placeholder="Note"
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
