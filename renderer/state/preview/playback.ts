import { type FrameTimes, frameAtTime, timeOfFrame } from '../../../nodes/kit/frame-times.ts';
import type { PreviewRange } from '../../preview-protocol.ts';
import type { Editor } from '../editor/editor.ts';
import { type FrameRange, frameOf, type PreviewState } from '../editor/preview-state.ts';

/** Play, steps and ranges, as the timeline, the transport bar and the keys ask for them. */
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

/** Holds the preview at a frame of the recording. What remembers earlier frames begins anew there. */
export function goToFrame({ preview, transport }: Playing, frame: number): void {
  const { frames } = preview.getState();
  if (frames === null) return;
  const to = Math.max(0, frame);
  preview.setState({ asked: to });
  transport.post({ kind: 'transport', action: 'pause' });
  transport.post({ kind: 'seek', timeS: timeOfFrame(frames, to) });
}

/** Holds the preview at a moment between frames, such as that of a keyframe. */
export function goToTime({ preview, transport }: Playing, timeS: number): void {
  preview.setState({ asked: null });
  transport.post({ kind: 'transport', action: 'pause' });
  transport.post({ kind: 'seek', timeS });
}

/** One frame on goes on from what is there; back, as everywhere, begins anew. */
export function stepFrames(editor: Playing, by: number): void {
  const state = editor.preview.getState();
  if (by !== 1) {
    goToFrame(editor, frameOf(state) + by);
    return;
  }
  if (state.frames !== null) editor.preview.setState({ asked: frameOf(state) + 1 });
  editor.transport.post({ kind: 'transport', action: 'step' });
}

/** The frame that a time falls into, to the nearest border between frames. */
export function nearestFrame(frames: FrameTimes, timeS: number): number {
  const before = frameAtTime(frames, timeS);
  return timeOfFrame(frames, before + 1) - timeS < timeS - timeOfFrame(frames, before) ? before + 1 : before;
}

/** The last frame of the recording; without one, 0. */
export function lastFrame({ frames }: Pick<PreviewState, 'frames'>): number {
  return (frames?.timesS.length ?? 1) - 1;
}

/** What is played: the range, or the whole recording. */
export function playedRange(state: Pick<PreviewState, 'frames' | 'range'>): FrameRange {
  return state.range ?? { from: 0, to: lastFrame(state) };
}

/** The range begins with this frame. One that ends before it ends there now. */
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

/** What the preview is told: null where the recording plays as it would without a timeline. */
export function previewRange(state: Pick<PreviewState, 'frames' | 'range' | 'loop'>): PreviewRange | null {
  const { frames, range, loop } = state;
  if (frames === null || (range === null && !loop)) return null;
  const { from, to } = playedRange(state);
  return { fromS: timeOfFrame(frames, from), lastS: timeOfFrame(frames, to), endS: timeOfFrame(frames, to + 1), loop };
}
