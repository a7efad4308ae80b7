import { useRef } from 'react';
import type { ParamValue } from '../../../nodes/kit/definition.ts';
import type { EditHandlers } from '../../ui/number-field.tsx';
import { useEditor } from '../editor/editor-context.ts';
import { endGesture, takeBack } from './apply.ts';

/** Makes one step of the history of one gesture on a control, and none of one that is given up. */
export function useUndoGroup<T = ParamValue>(edit: (value: T) => void): Required<EditHandlers<T>> {
  const editor = useEditor();
  /** The state of the history before it. */
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
      if (began.current !== null) takeBack(editor, began.current);
      began.current = null;
    },
  };
}
