import { useStore } from 'zustand';
import type { Track } from '../../export/graph/project.ts';
import type { ParamDefinition } from '../../nodes/kit/definition.ts';
import { useEditor } from '../shell/editor-context.ts';
import { editAt, keyAt, toggleKey, valueAt } from '../state/keyframes.ts';
import { timeOf } from '../state/preview.ts';
import { ParamControl } from './param-control.tsx';
import { useGesture } from './use-gesture.ts';

interface KeyButtonProps {
  readonly node: string;
  readonly name: string;
  readonly label: string;
  readonly track: Track | null;
}

/** A diamond: hollow without keyframes, filled where one stands at the time that is shown. */
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

/** The value that the keyframes give at the time that is shown; changing it sets the key there. */
export function TrackField({ id, node, name, param, track }: TrackFieldProps) {
  const editor = useEditor();
  const timeS = useStore(editor.preview, timeOf);
  const gesture = useGesture((value) => void editAt(editor, node, name, timeOf(editor.preview.getState()), value));
  return <ParamControl id={id} param={param} value={valueAt(param, track, timeS)} {...gesture} onExpression={() => false} />;
}
