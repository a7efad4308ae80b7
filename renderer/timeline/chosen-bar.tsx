import type { Track } from '../../export/graph/project.ts';
import { type Handles, handlesOf, type NAMED_EASINGS } from '../../nodes/kit/ease.ts';
import { useEditor } from '../shell/editor-context.ts';
import { endGesture } from '../state/apply.ts';
import { type AnimatedParam, setEasing, setRepeat } from '../state/keyframes.ts';
import { EasingButton } from './easing-button.tsx';
import type { ChosenKey } from './key-mark.tsx';

const EASINGS: readonly (readonly [(typeof NAMED_EASINGS)[number], string])[] = [
  ['linear', 'Evenly'],
  ['ease-in', 'Slow at first'],
  ['ease-out', 'Slow at last'],
  ['ease-in-out', 'Slow at both ends'],
  ['step', 'In a step'],
];
const BY_HANDLES = 'handles';
/** Where a step's would begin: slow at both ends. */
const FIRST_HANDLES: Handles = [0.42, 0, 0.58, 1];
const REPEATS: readonly (readonly [Track['repeat'], string])[] = [
  ['once', 'Once'],
  ['loop', 'Again and again'],
  ['mirror', 'To and fro'],
];

/** What can be chosen for the key that is: how it goes on to the next, and what comes after the last. */
export function ChosenBar({ chosen, tracks }: { readonly chosen: ChosenKey | null; readonly tracks: readonly AnimatedParam[] }) {
  const editor = useEditor();
  const track = tracks.find(({ node, param }) => node === chosen?.node && param === chosen.param)?.track;
  const key = chosen === null ? undefined : track?.keys[chosen.index];
  if (!chosen || !track || !key) return null;
  return (
    <div className="timeline-chosen">
      <output>{key.timeS.toFixed(2)} s</output>
      <label>
        To the next key{' '}
        <select
          className="select"
          value={typeof key.easing === 'string' ? key.easing : BY_HANDLES}
          onChange={(event) => {
            const named = EASINGS.find(([easing]) => easing === event.target.value)?.[0];
            setEasing(editor, chosen.node, chosen.param, chosen.index, named ?? handlesOf(key.easing) ?? FIRST_HANDLES);
            endGesture(editor);
          }}
        >
          {EASINGS.map(([easing, words]) => (
            <option key={easing} value={easing}>
              {words}
            </option>
          ))}
          <option value={BY_HANDLES}>By handles</option>
        </select>
      </label>
      <EasingButton {...chosen} easing={key.easing} />
      <label>
        Play{' '}
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
