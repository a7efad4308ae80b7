import { type KeyboardEvent, type PointerEvent, useRef } from 'react';
import { endGesture } from '../state/document/apply.ts';
import { useEditor } from '../state/editor/editor-context.ts';
import { moveKey, removeKey } from '../state/params/keyframes.ts';
import { goToTime } from '../state/preview/playback.ts';
import { percentOf } from './time-scale.ts';

export interface ChosenKeyframe {
  readonly node: string;
  readonly param: string;
  readonly index: number;
}

interface KeyframeMarkProps extends ChosenKeyframe {
  readonly timeS: number;
  readonly lengthS: number;
  readonly chosen: boolean;
  readonly onChoose: (key: ChosenKeyframe) => void;
}

const START_PX = 3;
const KEY_STEP_S = 0.1;

/** One keyframe. A drag or arrow keys move it, Delete removes it, Enter goes to its time. */
export function KeyframeMark({ node, param, index, timeS, lengthS, chosen, onChoose }: KeyframeMarkProps) {
  const editor = useEditor();
  /** State at the start of the drag. The scale is fixed then, because a drag to the right may extend the timeline. */
  const drag = useRef<{ x: number; timeS: number; secondsPerPx: number; moving: boolean } | null>(null);

  const onPointerDown = (event: PointerEvent<HTMLElement>) => {
    if (event.button !== 0) return;
    event.currentTarget.setPointerCapture(event.pointerId);
    const width = event.currentTarget.parentElement?.getBoundingClientRect().width ?? 1;
    drag.current = { x: event.clientX, timeS, secondsPerPx: lengthS / width, moving: false };
    onChoose({ node, param, index });
  };
  const onPointerMove = (event: PointerEvent<HTMLElement>) => {
    const from = drag.current;
    if (!from) return;
    const byPx = event.clientX - from.x;
    if (!from.moving && Math.abs(byPx) < START_PX) return;
    from.moving = true;
    moveKey(editor, node, param, index, from.timeS + byPx * from.secondsPerPx);
  };
  const onRelease = () => {
    if (drag.current?.moving) endGesture(editor);
    drag.current = null;
  };
  const onKeyDown = (event: KeyboardEvent) => {
    const by = event.key === 'ArrowLeft' ? -KEY_STEP_S : event.key === 'ArrowRight' ? KEY_STEP_S : 0;
    if (by !== 0) moveKey(editor, node, param, index, timeS + by);
    else if (event.key === 'Delete' || event.key === 'Backspace') removeKey(editor, node, param, index);
    else if (event.key === 'Enter') {
      onChoose({ node, param, index });
      goToTime(editor, timeS);
    } else return;
    event.preventDefault();
    event.stopPropagation();
  };
  return (
    <button
      type="button"
      className="timeline-key"
      aria-label={`Keyframe ${index + 1}, ${timeS.toFixed(2)} s`}
      aria-pressed={chosen}
      style={{ left: percentOf(timeS, lengthS) }}
      onPointerDown={onPointerDown}
      onPointerMove={onPointerMove}
      onLostPointerCapture={onRelease}
      onKeyDown={onKeyDown}
      onKeyUp={() => endGesture(editor)}
    />
  );
}
