import { type KeyboardEvent, type PointerEvent, useRef } from 'react';
import { useEditor } from '../shell/editor-context.ts';
import { endGesture } from '../state/apply.ts';
import { moveKey, removeKey } from '../state/keyframes.ts';
import { goToTime } from '../state/playing.ts';
import { percentOf } from './time-scale.ts';

export interface ChosenKey {
  readonly node: string;
  readonly param: string;
  readonly index: number;
}

interface KeyMarkProps extends ChosenKey {
  readonly timeS: number;
  readonly lengthS: number;
  readonly chosen: boolean;
  readonly onChoose: (key: ChosenKey) => void;
}

const START_PX = 3;
const KEY_STEP_S = 0.1;

/** One keyframe: dragged, or moved by arrow keys; Delete takes it away, Enter goes to its moment. */
export function KeyMark({ node, param, index, timeS, lengthS, chosen, onChoose }: KeyMarkProps) {
  const editor = useEditor();
  /** The scale of the moment at which the drag began: it may grow with the key. */
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
