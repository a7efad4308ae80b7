import type { Track } from '../../export/graph/project.ts';
import { type Handles, handlesOf, type NAMED_EASINGS } from '../../nodes/kit/ease.ts';
import { endGesture } from '../state/document/apply.ts';
import { useEditor } from '../state/editor/editor-context.ts';
import { type AnimatedParam, setEasing, setRepeat } from '../state/params/keyframes.ts';
import { EasingButton } from './easing-button.tsx';
import type { ChosenKeyframe } from './keyframe-mark.tsx';

const EASINGS: readonly (readonly [(typeof NAMED_EASINGS)[number], string])[] = [
  ['linear', 'Linear'],
  ['ease-in', 'Ease in'],
  ['ease-out', 'Ease out'],
  ['ease-in-out', 'Ease in-out'],
  ['step', 'Hold'],
];
const BEZIER = 'bezier';
/** Control points for an easing without its own, such as `step`: those of `ease-in-out`. */
const DEFAULT_HANDLES: Handles = [0.42, 0, 0.58, 1];
const REPEATS: readonly (readonly [Track['repeat'], string])[] = [
  ['once', 'Once'],
  ['loop', 'Loop'],
  ['mirror', 'Ping-pong'],
];

/** Options of the selected keyframe: its interpolation, and how its track repeats. */
export function KeyframeBar({ chosen, tracks }: { readonly chosen: ChosenKeyframe | null; readonly tracks: readonly AnimatedParam[] }) {
  const editor = useEditor();
  const track = tracks.find(({ node, param }) => node === chosen?.node && param === chosen.param)?.track;
  const key = chosen === null ? undefined : track?.keys[chosen.index];
  if (!chosen || !track || !key) return null;
  return (
    <div className="timeline-chosen">
      <output>{key.timeS.toFixed(2)} s</output>
      <label>
        Interpolation{' '}
        <select
          className="select"
          value={typeof key.easing === 'string' ? key.easing : BEZIER}
          onChange={(event) => {
            const named = EASINGS.find(([easing]) => easing === event.target.value)?.[0];
            setEasing(editor, chosen.node, chosen.param, chosen.index, named ?? handlesOf(key.easing) ?? DEFAULT_HANDLES);
            endGesture(editor);
          }}
        >
          {EASINGS.map(([easing, words]) => (
            <option key={easing} value={easing}>
              {words}
            </option>
          ))}
          <option value={BEZIER}>Bézier</option>
        </select>
      </label>
      <EasingButton {...chosen} easing={key.easing} />
      <label>
        Repeat{' '}
        <select
          className="select"
          value={track.repeat}
          onChange={(event) => void setRepeat(editor, chosen.node, chosen.param, event.target.value as Track['repeat'])}
        >
          {REPEATS.map(([repeat, words]) => (
            <option key={repeat} value={repeat}>
              {words}
            </option>
          ))}
        </select>
      </label>
    </div>
  );
}
