import { type FrameTimes, frameAtTime, timeOfFrame } from '../../../nodes/kit/frame-times.ts';
import type { PreviewRange } from '../../preview-protocol.ts';
import type { Editor } from '../editor/editor.ts';
import { type FrameRange, frameOf, type PreviewState } from '../editor/preview-state.ts';

/** The part of the editor that playback needs. */
type Playing = Pick<Editor, 'preview' | 'transport'>;

export function isHeld({ status }: PreviewState): boolean {
  return status?.state === 'paused';
}

export function togglePlay({ preview, transport }: Playing): void {
  const held = isHeld(preview.getState());
  preview.setState({ asked: null });
  transport.post({ kind: 'transport', action: held ? 'play' : 'pause' });
}

export function goToStart({ preview, transport }: Playing): void {
  const { asked, status } = preview.getState();
  if (asked !== null || status?.state === 'paused') preview.setState({ asked: 0 });
  transport.post({ kind: 'transport', action: 'reset' });
}

/** Pauses at a frame of the recording. Stateful nodes restart. */
export function goToFrame({ preview, transport }: Playing, frame: number): void {
  const { frames } = preview.getState();
  if (frames === null) return;
  const to = Math.max(0, frame);
  preview.setState({ asked: to });
  transport.post({ kind: 'transport', action: 'pause' });
  transport.post({ kind: 'seek', timeS: timeOfFrame(frames, to) });
}

/** Pauses at a time between frames, such as that of a keyframe. */
export function goToTime({ preview, transport }: Playing, timeS: number): void {
  preview.setState({ asked: null });
  transport.post({ kind: 'transport', action: 'pause' });
  transport.post({ kind: 'seek', timeS });
}

/** Steps by frames. A step to the next frame keeps the state of stateful nodes; other steps restart them. */
export function stepFrames(editor: Playing, by: number): void {
  const state = editor.preview.getState();
  if (by !== 1) {
    goToFrame(editor, frameOf(state) + by);
    return;
  }
  if (state.frames !== null) editor.preview.setState({ asked: frameOf(state) + 1 });
  editor.transport.post({ kind: 'transport', action: 'step' });
}

/** The frame whose start is nearest to the time. */
export function nearestFrame(frames: FrameTimes, timeS: number): number {
  const before = frameAtTime(frames, timeS);
  return timeOfFrame(frames, before + 1) - timeS < timeS - timeOfFrame(frames, before) ? before + 1 : before;
}

/** Index of the last frame of the recording; 0 without a recording. */
export function lastFrame({ frames }: Pick<PreviewState, 'frames'>): number {
  return (frames?.timesS.length ?? 1) - 1;
}

/** The play range; without one, the whole recording. */
export function playedRange(state: Pick<PreviewState, 'frames' | 'range'>): FrameRange {
  return state.range ?? { from: 0, to: lastFrame(state) };
}

/** Sets the in point. An out point before it moves to the same frame. */
export function setIn({ preview }: Pick<Editor, 'preview'>, frame: number): void {
  preview.setState((state) => {
    const from = Math.max(0, frame);
    return { range: { from, to: Math.max(from, playedRange(state).to) } };
  });
}

export function setOut({ preview }: Pick<Editor, 'preview'>, frame: number): void {
  preview.setState((state) => {
    const to = Math.max(0, frame);
    return { range: { from: Math.min(playedRange(state).from, to), to } };
  });
}

export function clearRange({ preview }: Pick<Editor, 'preview'>): void {
  preview.setState({ range: null });
}

export function toggleLoop({ preview }: Pick<Editor, 'preview'>): void {
  preview.setState(({ loop }) => ({ loop: !loop }));
}

/** The range to send to the preview; null to play the recording without a range. */
export function previewRange(state: Pick<PreviewState, 'frames' | 'range' | 'loop'>): PreviewRange | null {
  const { frames, range, loop } = state;
  if (frames === null || (range === null && !loop)) return null;
  const { from, to } = playedRange(state);
  return { fromS: timeOfFrame(frames, from), lastS: timeOfFrame(frames, to), endS: timeOfFrame(frames, to + 1), loop };
}
