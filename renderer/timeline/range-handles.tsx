import { type KeyboardEvent, type PointerEvent, useRef } from 'react';
import { useStore } from 'zustand';
import { frameAtTime, timeOfFrame } from '../../nodes/kit/frame-times.ts';
import { useEditor } from '../state/editor/editor-context.ts';
import type { PreviewState } from '../state/editor/preview-state.ts';
import { nearestFrame, playedRange, setIn, setOut } from '../state/preview/playback.ts';
import { percentOf, timeAt } from './time-scale.ts';

interface Lengthy {
  readonly lengthS: number;
}

const fromOf = (state: PreviewState) => playedRange(state).from;
const toOf = (state: PreviewState) => playedRange(state).to;

/** Shades the time outside the play range. */
export function RangeShade({ lengthS }: Lengthy) {
  const { preview } = useEditor();
  const frames = useStore(preview, (state) => state.frames);
  const from = useStore(preview, fromOf);
  const to = useStore(preview, toOf);
  if (frames === null) return null;
  const [fromS, endS] = [timeOfFrame(frames, from), Math.min(lengthS, timeOfFrame(frames, to + 1))];
  return (
    <>
      <span className="timeline-shade" style={{ left: 0, width: percentOf(fromS, lengthS) }} />
      <span className="timeline-shade" style={{ left: percentOf(endS, lengthS), right: 0 }} />
    </>
  );
}

/** In and out point on the ruler. A drag or arrow keys move them. */
export function RangeHandles({ lengthS }: Lengthy) {
  return (
    <>
      <Handle which="in" lengthS={lengthS} />
      <Handle which="out" lengthS={lengthS} />
    </>
  );
}

const STEPS: Readonly<Record<string, number>> = { ArrowLeft: -1, ArrowDown: -1, ArrowRight: 1, ArrowUp: 1, PageDown: -10, PageUp: 10 };

function Handle({ which, lengthS }: Lengthy & { readonly which: 'in' | 'out' }) {
  const editor = useEditor();
  const { preview } = editor;
  const frames = useStore(preview, (state) => state.frames);
  const from = useStore(preview, fromOf);
  const to = useStore(preview, toOf);
  const dragged = useRef(false);
  if (frames === null) return null;
  const frame = which === 'in' ? from : to;
  const least = which === 'in' ? 0 : from;
  const most = which === 'in' ? to : frameAtTime(frames, lengthS) - 1;
  const move = (asked: number) => (which === 'in' ? setIn : setOut)(editor, Math.min(Math.max(asked, least), Math.max(most, least)));

  const onPointerDown = (event: PointerEvent<HTMLElement>) => {
    if (event.button !== 0) return;
    event.currentTarget.setPointerCapture(event.pointerId);
    dragged.current = false;
  };
  const onPointerMove = (event: PointerEvent<HTMLElement>) => {
    const box = event.currentTarget.parentElement?.getBoundingClientRect();
    if (!box || !event.currentTarget.hasPointerCapture(event.pointerId)) return;
    // The out point lies at the end of its frame.
    const border = nearestFrame(frames, timeAt(event.clientX, box, lengthS));
    const next = which === 'in' ? border : border - 1;
    if (next === frame && !dragged.current) return;
    dragged.current = true;
    move(next);
  };
  const onKeyDown = (event: KeyboardEvent) => {
    const by = STEPS[event.key];
    if (by !== undefined) move(frame + by);
    else if (event.key === 'Home') move(least);
    else if (event.key === 'End') move(most);
    else return;
    event.preventDefault();
    event.stopPropagation();
  };
  const words = which === 'in' ? 'In point' : 'Out point';
  return (
    <div
      className={`timeline-handle timeline-handle-${which}`}
      role="slider"
      tabIndex={0}
      data-tip={`${words}: drag, or press ${which === 'in' ? 'I' : 'O'} at a frame`}
      aria-label={words}
      aria-orientation="horizontal"
      aria-valuemin={least}
      aria-valuemax={most}
      aria-valuenow={frame}
      aria-valuetext={frameLabel(frame, timeOfFrame(frames, frame))}
      style={{ left: percentOf(Math.min(timeOfFrame(frames, which === 'in' ? frame : frame + 1), lengthS), lengthS) }}
      onPointerDown={onPointerDown}
      onPointerMove={onPointerMove}
      onKeyDown={onKeyDown}
    />
  );
}

/** Label of a frame for tooltips and screen readers. */
export function frameLabel(frame: number, timeS: number): string {
  return `Frame ${frame}, ${timeS.toFixed(2)} s`;
}
