import { useStore } from 'zustand';
import type { Track } from '../../export/graph/project.ts';
import type { ParamDefinition } from '../../nodes/kit/definition.ts';
import { useUndoGroup } from '../state/document/use-undo-group.ts';
import { useEditor } from '../state/editor/editor-context.ts';
import { timeOf } from '../state/editor/preview-state.ts';
import { editAt, keyAt, toggleKey, valueAt } from '../state/params/keyframes.ts';
import { ParamControl } from './param-control.tsx';

interface KeyButtonProps {
  readonly node: string;
  readonly name: string;
  readonly label: string;
  readonly track: Track | null;
}

/** Diamond that sets or deletes the keyframe at the current time: filled if there is one, else hollow. */
export function KeyButton({ node, name, label, track }: KeyButtonProps) {
  const editor = useEditor();
  const isHere = useStore(editor.preview, (state) => track !== null && keyAt(track, timeOf(state)) !== -1);
  const press = () => {
    toggleKey(editor, node, name, timeOf(editor.preview.getState()));
    if (track === null) editor.ui.setState({ bottom: 'timeline' });
  };
  const words = isHere ? `Delete the keyframe of ${label}` : `Set a keyframe of ${label}`;
  return (
    <button
      type="button"
      className={`key-button${track === null ? '' : ' key-button-on'}${isHere ? ' key-button-here' : ''}`}
      aria-label={words}
      data-tip={words}
      onClick={press}
    >
      <svg width="10" height="10" viewBox="0 0 10 10" aria-hidden="true" focusable="false">
        <path d="M5 1l4 4-4 4-4-4z" />
      </svg>
    </button>
  );
}

interface TrackFieldProps {
  readonly id: string;
  readonly node: string;
  readonly name: string;
  readonly param: ParamDefinition;
  readonly track: Track;
}

/** Value of a track at the current time. An edit sets a keyframe there. */
export function TrackField({ id, node, name, param, track }: TrackFieldProps) {
  const editor = useEditor();
  const timeS = useStore(editor.preview, timeOf);
  const gesture = useUndoGroup((value) => void editAt(editor, node, name, timeOf(editor.preview.getState()), value));
  return (
    <ParamControl id={id} param={param} value={valueAt(param, track, timeS)} {...gesture} onExpression={() => false} onPoint={() => {}} />
  );
}
