import type { PointerEvent } from 'react';
import { useStore } from 'zustand';
import { frameAtTime, timeOfFrame } from '../../nodes/kit/frame-times.ts';
import { useEditor } from '../shell/editor-context.ts';
import { goToFrame } from '../state/playing.ts';
import { frameOf, timeOf } from '../state/preview.ts';
import { frameWords } from './frame-words.ts';
import { marksOf, percentOf, timeAt } from './time-scale.ts';

/** Seconds. Pressed or dragged, recordings go to that frame and hold. */
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
        data-tip={frames === null ? 'Only recordings have moments to go to' : 'Go to a frame'}
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

/** The frame that is shown. Its keys are those of the whole panel. */
export function Playhead({ lengthS }: { readonly lengthS: number }) {
  const { preview } = useEditor();
  const timeS = useStore(preview, timeOf);
  const frame = useStore(preview, frameOf);
  const frames = useStore(preview, (state) => state.frames);
  if (frames === null) return timeS <= lengthS && <span className="timeline-head" style={{ left: percentOf(timeS, lengthS) }} />;
  // All rounds of a recording look alike where no key goes on behind the first.
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
      aria-valuetext={frameWords(frame, timeS)}
      style={{ left: percentOf(shownS, lengthS) }}
    />
  );
}
