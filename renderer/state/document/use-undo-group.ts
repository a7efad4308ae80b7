import { useRef } from 'react';
import type { ParamValue } from '../../../nodes/kit/definition.ts';
import type { EditHandlers } from '../../ui/number-field.tsx';
import { useEditor } from '../editor/editor-context.ts';
import { endGesture, revertGesture } from './apply.ts';

/** Groups the edits of a gesture on a control into one undo step, and reverts them if the gesture is canceled. */
export function useUndoGroup<T = ParamValue>(edit: (value: T) => void): Required<EditHandlers<T>> {
  const editor = useEditor();
  /** State of the history before the gesture. */
  const began = useRef<number | null>(null);
  return {
    onEdit: (value) => {
      if (began.current === null) {
        endGesture(editor);
        began.current = editor.document.getState().history.state;
      }
      edit(value);
    },
    onEnd: () => {
      began.current = null;
      endGesture(editor);
    },
    onCancel: () => {
      if (began.current !== null) revertGesture(editor, began.current);
      began.current = null;
    },
  };
}
