import { expect, test } from '@jest/globals';
import { openTestEditor } from '../../../tests/support/test-editor.ts';
import { popOutPreview } from './pop-out.ts';

const FRAMES = { timesS: [0, 0.1, 0.2, 0.3], durationS: 0.4 };

test.each([
  ['paused', ['pause', 0.2]],
  ['playing', [0.2]],
] as const)('a preview that is %s continues so, at its frame, in its own window', async (state, expected) => {
  const { editor } = await openTestEditor();
  const posted: unknown[] = [];
  editor.transport.post = (message) => void posted.push(message.kind === 'seek' ? message.timeS : 'action' in message && message.action);
  const status = { state, frame: 2, timeS: 0.2, request: 1, late: false } as never;
  editor.preview.setState({ frames: FRAMES, playing: 1, request: 1, status });
  popOutPreview(editor, true);
  // The old page goes, the new one begins.
  editor.preview.setState({ ready: false, playing: null, status: null });
  expect(posted).toEqual([]);
  editor.preview.setState({ playing: 1, status: { ...(status as object), state: 'playing', frame: 0 } as never });
  expect(posted).toEqual(expected);
});
