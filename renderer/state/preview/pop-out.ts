import { timeOfFrame } from '../../../nodes/kit/frame-times.ts';
import type { Editor } from '../editor/editor.ts';
import { frameOf, isLoading } from '../editor/preview-state.ts';
import { isHeld } from './playback.ts';

/**
 * Moves the preview to a window of its own, or back to its panel. The preview page is loaded again there: the recording continues at its
 * frame, playing or paused.
 */
export function popOutPreview({ preview, transport }: Pick<Editor, 'preview' | 'transport'>, on: boolean): void {
  const state = preview.getState();
  if (state.poppedOut === on) return;
  const held = isHeld(state);
  const timeS = state.frames && timeOfFrame(state.frames, frameOf(state));
  preview.setState({ poppedOut: on });
  if (state.status === null) return;
  let left = false;
  const stop = preview.subscribe((next) => {
    left ||= next.status === null;
    if (!left || isLoading(next)) return;
    stop();
    if (held) transport.post({ kind: 'transport', action: 'pause' });
    if (timeS !== null && next.frames !== null) transport.post({ kind: 'seek', timeS });
  });
}
