import type { PointerEvent } from 'react';
import { useStore } from 'zustand';
import { frameAtTime, timeOfFrame } from '../../nodes/kit/frame-times.ts';
import { useEditor } from '../state/editor/editor-context.ts';
import { frameOf, timeOf } from '../state/editor/preview-state.ts';
import { goToFrame } from '../state/preview/playback.ts';
import { frameLabel } from './range-handles.tsx';
import { marksOf, percentOf, timeAt } from './time-scale.ts';

/** Ruler in seconds. A press or drag pauses the recording at that frame. */
export function Ruler({ lengthS }: { readonly lengthS: number }) {
  const editor = useEditor();
  const frames = useStore(editor.preview, (state) => state.frames);
  const seek = (event: PointerEvent<HTMLElement>) => {
    if (frames === null) return;
    const endS = lengthS - (timeOfFrame(frames, 1) - timeOfFrame(frames, 0)) / 2;
    const timeS = Math.min(timeAt(event.clientX, event.currentTarget.getBoundingClientRect(), lengthS), endS);
    goToFrame(editor, frameAtTime(frames, timeS));
  };
  return (
    <div className="timeline-row">
      <span />
      <div
        className="timeline-ruler"
        data-tip={frames === null ? 'Only recordings have frames to go to' : 'Go to a frame'}
        onPointerDown={(event) => {
          if (event.button !== 0) return;
          event.currentTarget.setPointerCapture(event.pointerId);
          seek(event);
        }}
        onPointerMove={(event) => {
          if (event.currentTarget.hasPointerCapture(event.pointerId)) seek(event);
        }}
      >
        {marksOf(lengthS).map((markS) => (
          <span key={markS} style={{ left: percentOf(markS, lengthS) }}>
            {markS} s
          </span>
        ))}
      </div>
    </div>
  );
}

/** Marks the current frame. The panel handles its keys. */
export function Playhead({ lengthS }: { readonly lengthS: number }) {
  const { preview } = useEditor();
  const timeS = useStore(preview, timeOf);
  const frame = useStore(preview, frameOf);
  const frames = useStore(preview, (state) => state.frames);
  if (frames === null) return timeS <= lengthS && <span className="timeline-head" style={{ left: percentOf(timeS, lengthS) }} />;
  // Loops of a recording are shown as one unless a keyframe lies after the first.
  const shownS = timeS < lengthS ? timeS : timeS % frames.durationS;
  return (
    <div
      className="timeline-head"
      role="slider"
      tabIndex={0}
      aria-label="Playhead"
      aria-orientation="horizontal"
      aria-valuemin={0}
      aria-valuemax={frameAtTime(frames, lengthS) - 1}
      aria-valuenow={frame}
      aria-valuetext={frameLabel(frame, timeS)}
      style={{ left: percentOf(shownS, lengthS) }}
    />
  );
}
