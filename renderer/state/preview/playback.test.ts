import { beforeEach, describe, expect, test } from '@jest/globals';
import { openTestEditor } from '../../../tests/support/test-editor.ts';
import type { PreviewStatus, ToPreview } from '../../preview-protocol.ts';
import type { Editor } from '../editor/editor.ts';
import { frameOf, timeOf } from '../editor/preview-state.ts';
import { createPreviewSync, type PreviewSync } from '../preview-sync/preview-sync.ts';
import { keepRanges } from './kept-ranges.ts';
import { clearRange, goToFrame, goToStart, nearestFrame, setIn, setOut, stepFrames, toggleLoop, togglePlay } from './playback.ts';

/** Ten frames, 0.1 s each. */
const FRAMES = { timesS: Array.from({ length: 10 }, (_, i) => i / 10), durationS: 1 };

let editor: Editor;
let feed: PreviewSync;
let sent: ToPreview[];
beforeEach(async () => {
  ({ editor } = await openTestEditor());
  feed = createPreviewSync(editor, { postMessage: () => {}, onmessage: null, terminate: () => {} });
  sent = [];
  feed.attach((message) => void sent.push(message));
  feed.receive({ kind: 'frames', frames: FRAMES, shape: 4 / 3 });
  sent = [];
});

function status(frame: number, state: PreviewStatus['state'] = 'paused', late = false): void {
  feed.receive({
    kind: 'status',
    status: {
      state,
      request: 0,
      frame,
      late,
      timeS: frame / 10,
      frameMs: 1,
      framesPerS: 0,
      widthPx: 4,
      heightPx: 3,
      worldFromView: null,
      tangents: null,
    },
  });
}

const shown = () => frameOf(editor.preview.getState());
const range = () => sent.splice(0).flatMap((message) => (message.kind === 'range' ? [message.range] : []));

describe('frames', () => {
  test('count from what was asked for, however late the preview tells', () => {
    status(4);
    stepFrames(editor, 1);
    stepFrames(editor, 1);
    expect(shown()).toBe(6);
    expect(timeOf(editor.preview.getState())).toBeCloseTo(0.6, 9);
    status(5);
    expect(shown()).toBe(6);
    stepFrames(editor, -1);
    expect(sent.at(-1)).toEqual({ kind: 'seek', timeS: 0.5 });
    status(5);
    status(5, 'playing');
    status(8, 'playing');
    expect(shown()).toBe(8);
  });

  test('are there once their own picture is', () => {
    status(3);
    goToFrame(editor, 7);
    status(7, 'paused', true);
    expect(editor.preview.getState().asked).toBe(7);
    status(7);
    expect(editor.preview.getState().asked).toBeNull();
  });

  test('are gone to while the preview is held, and there is none before the first', () => {
    status(3, 'playing');
    goToFrame(editor, -5);
    expect(sent).toEqual([
      { kind: 'transport', action: 'pause' },
      { kind: 'seek', timeS: 0 },
    ]);
    goToFrame(editor, 7);
    goToStart(editor);
    expect(shown()).toBe(0);
  });

  test('play and pause by what the preview does', () => {
    status(3, 'playing');
    togglePlay(editor);
    status(3);
    togglePlay(editor);
    expect(sent).toEqual([
      { kind: 'transport', action: 'pause' },
      { kind: 'transport', action: 'play' },
    ]);
  });

  test('have borders half way between which one belongs to either', () => {
    expect([0, 0.04, 0.06, 0.149, 0.151, 0.97].map((timeS) => nearestFrame(FRAMES, timeS))).toEqual([0, 0, 1, 1, 2, 10]);
  });
});

describe('what is played', () => {
  test('is told by the times of its frames, the last one to its end', () => {
    setIn(editor, 3);
    setOut(editor, 5);
    expect(range().at(-1)).toEqual({ fromS: 0.3, lastS: 0.5, endS: 0.6, loop: false });
    toggleLoop(editor);
    expect(range()).toMatchObject([{ loop: true }]);
    clearRange(editor);
    expect(range()).toEqual([{ fromS: 0, lastS: 0.9, endS: 1, loop: true }]);
    toggleLoop(editor);
    expect(range()).toEqual([null]);
  });

  test('gives way where it would end before it begins', () => {
    setIn(editor, 3);
    setOut(editor, 1);
    expect(editor.preview.getState().range).toEqual({ from: 1, to: 1 });
    setIn(editor, 8);
    expect(editor.preview.getState().range).toEqual({ from: 8, to: 8 });
  });

  test('is nothing where there is no recording', () => {
    setIn(editor, 3);
    sent = [];
    feed.receive({ kind: 'frames', frames: null, shape: null });
    expect(range()).toEqual([null]);
    goToFrame(editor, 3);
    expect(sent).toEqual([]);
  });

  test('comes back with project and recording', async () => {
    const texts = new Map<string, string>();
    const storage = { getItem: (key: string) => texts.get(key) ?? null, setItem: (key: string, text: string) => void texts.set(key, text) };
    const sources = ['desk', 'hall'].map((id) => ({ id, title: id, kind: 'recorded' as const, url: `http://x/${id}/` }));
    const stop = keepRanges(editor, storage);
    editor.preview.setState({ sources });
    setIn(editor, 2);
    toggleLoop(editor);
    editor.preview.setState({ sourceId: 'hall' });
    expect(editor.preview.getState()).toMatchObject({ range: null, loop: false });
    setOut(editor, 4);
    editor.preview.setState({ sourceId: 'desk' });
    expect(editor.preview.getState()).toMatchObject({ range: { from: 2, to: 9 }, loop: true });
    stop();

    const other = await openTestEditor();
    keepRanges(other.editor, storage);
    other.editor.preview.setState({ sources, sourceId: 'hall' });
    expect(other.editor.preview.getState()).toMatchObject({ range: { from: 0, to: 4 }, loop: false });
    texts.set('scrim-ranges', '[["desk /project",{"range":{"from":"x"},"loop":1}],7]');
    const third = await openTestEditor();
    keepRanges(third.editor, storage);
    third.editor.preview.setState({ sources });
    expect(third.editor.preview.getState().range).toBeNull();
  });
});
