import { useId } from 'react';
import type { Track } from '../../export/graph/project.ts';
import { type Handles, handlesOf, type NAMED_EASINGS } from '../../nodes/kit/ease.ts';
import { endGesture } from '../state/document/apply.ts';
import { useEditor } from '../state/editor/editor-context.ts';
import { type AnimatedParam, setEasing, setRepeat } from '../state/params/keyframes.ts';
import { SelectField, type SelectOption } from '../ui/select-field.tsx';
import { EasingButton } from './easing-button.tsx';
import type { ChosenKeyframe } from './keyframe-mark.tsx';

const EASINGS: readonly SelectOption<(typeof NAMED_EASINGS)[number] | 'bezier'>[] = [
  { value: 'linear', label: 'Linear' },
  { value: 'ease-in', label: 'Ease in' },
  { value: 'ease-out', label: 'Ease out' },
  { value: 'ease-in-out', label: 'Ease in-out' },
  { value: 'step', label: 'Hold' },
  { value: 'bezier', label: 'Bézier' },
];
/** Control points for an easing without its own, such as `step`: those of `ease-in-out`. */
const DEFAULT_HANDLES: Handles = [0.42, 0, 0.58, 1];
const REPEATS: readonly SelectOption<Track['repeat']>[] = [
  { value: 'once', label: 'Once' },
  { value: 'loop', label: 'Loop' },
  { value: 'mirror', label: 'Ping-pong' },
];

/** Options of the selected keyframe: its interpolation, and how its track repeats. */
export function KeyframeBar({ chosen, tracks }: { readonly chosen: ChosenKeyframe | null; readonly tracks: readonly AnimatedParam[] }) {
  const editor = useEditor();
  const id = useId();
  const track = tracks.find(({ node, param }) => node === chosen?.node && param === chosen.param)?.track;
  const key = chosen === null ? undefined : track?.keys[chosen.index];
  if (!chosen || !track || !key) return null;
  return (
    <div className="timeline-chosen">
      <output>{key.timeS.toFixed(2)} s</output>
      <div className="timeline-choice">
        <label htmlFor={`${id}-easing`}>Interpolation</label>
        <SelectField
          id={`${id}-easing`}
          label="Interpolation"
          value={typeof key.easing === 'string' ? key.easing : 'bezier'}
          options={EASINGS}
          onChoose={(value) => {
            const easing = value === 'bezier' ? (handlesOf(key.easing) ?? DEFAULT_HANDLES) : value;
            setEasing(editor, chosen.node, chosen.param, chosen.index, easing);
            endGesture(editor);
          }}
        />
      </div>
      <EasingButton {...chosen} easing={key.easing} />
      <div className="timeline-choice">
        <label htmlFor={`${id}-repeat`}>Repeat</label>
        <SelectField
          id={`${id}-repeat`}
          label="Repeat"
          value={track.repeat}
          options={REPEATS}
          onChoose={(repeat) => void setRepeat(editor, chosen.node, chosen.param, repeat)}
        />
      </div>
    </div>
  );
}
