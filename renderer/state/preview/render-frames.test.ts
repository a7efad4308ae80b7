import { describe, expect, test } from '@jest/globals';
import { compileText } from '../../../tests/support/compile-project.ts';
import { projectText } from '../../../tests/support/project-kit.ts';
import { openTestEditor } from '../../../tests/support/test-editor.ts';
import type { FrameRenderRequest } from '../../preview-protocol.ts';
import type { FrameRenderLink } from '../editor/editor.ts';
import { openPath } from '../files/files.ts';
import { type FrameRenderOptions, planFrames, planRoomFrames, rateOf, renderFrames } from './render-frames.ts';

/** Ten a second. */
const FRAMES = { timesS: Array.from({ length: 36 }, (_, i) => i / 10), durationS: 3.6 };
const RANGE = { from: 5, to: 7 };

const kept = (plan: ReturnType<typeof planFrames>) => plan.filter(({ keep }) => keep).map(({ number, timeS }) => [number, timeS]);
const earlier = (plan: ReturnType<typeof planFrames>) => plan.filter(({ keep }) => !keep).map(({ timeS }) => timeS);

describe('the frames to render', () => {
  test('are the recording’s own, by their numbers, after the one before', () => {
    const plan = planFrames(FRAMES, RANGE, null, false);
    expect(kept(plan)).toEqual([
      [5, 0.5],
      [6, 0.6],
      [7, 0.7],
    ]);
    expect(earlier(plan)).toEqual([0.4]);
    expect(earlier(planFrames(FRAMES, { from: 0, to: 1 }, null, false))).toEqual([]);
  });

  test('come after all before them where the program depends on these', () => {
    expect(earlier(planFrames(FRAMES, RANGE, null, true))).toEqual([0, 0.1, 0.2, 0.3, 0.4]);
    expect(earlier(planFrames(FRAMES, RANGE, 20, true))).toHaveLength(10);
  });

  test('at another rate fill the same time, counted from 0', () => {
    const twice = planFrames(FRAMES, RANGE, 20, false);
    expect(kept(twice).map(([, timeS]) => timeS)).toEqual([0.5, 0.55, 0.6, 0.65, 0.7, 0.75].map((s) => expect.closeTo(s, 9)));
    expect(kept(twice).map(([number]) => number)).toEqual([0, 1, 2, 3, 4, 5]);
    expect(earlier(twice)).toEqual([expect.closeTo(0.45, 9)]);
    expect(kept(planFrames(FRAMES, { from: 0, to: 35 }, 24, false))).toHaveLength(87);
    expect(kept(planFrames(FRAMES, { from: 3, to: 3 }, 1, false))).toHaveLength(1);
  });

  test('of a room are all from the first on, of which those asked for are kept', () => {
    expect(planRoomFrames({ from: 1, to: 2 }, 20)).toEqual([
      { timeS: 0, number: 0, keep: false },
      { timeS: 0.05, number: 1, keep: true },
      { timeS: 0.1, number: 2, keep: true },
    ]);
  });

  test('have the rate that the recording has', () => {
    expect(rateOf(FRAMES)).toBe(10);
    expect(rateOf({ timesS: [0, 1 / 29.97], durationS: 2 / 29.97 })).toBe(29.97);
  });
});

describe('rendering', () => {
  const WISH: FrameRenderOptions = { what: 'pictures', range: RANGE, widthPx: 1, heightPx: 1, frameRateHz: null, out: '/frames' };

  /** An editor over a recording, and a page that draws one white pixel after the other. */
  async function overRecording() {
    const { editor, host } = await openTestEditor();
    const program = compileText(
      projectText({
        nodes: { 'video-0000': 'source/camera-video', 'screen-0000': 'output/screen' },
        wires: ['video-0000.layer -> screen-0000.layer'],
      }),
    );
    const link = { asked: [] as string[], request: null as FrameRenderRequest | null, closed: false };
    const film: FrameRenderLink = {
      ask: async (message) => {
        link.asked.push(message.kind);
        if (message.kind === 'render-begin') link.request = message.request;
        const kept = message.kind === 'render-frame' && message.keep;
        return { kind: 'frame-rendered', frame: kept ? Uint8Array.of(255, 255, 255, 255) : null };
      },
      close: () => {
        link.closed = true;
      },
    };
    editor.renderPage.open = () => film;
    editor.compile.setState({ program, programRevision: editor.document.getState().revision });
    editor.preview.setState({ frames: FRAMES, sources: [{ id: 'a', title: 'A', kind: 'recorded', url: 'http://127.0.0.1:1/a/' }] });
    const methods = () => host.calls.flatMap(({ method }) => (method.startsWith('frames.') ? method : []));
    return { editor, host, link, methods, texts: () => editor.ui.getState().toasts.map(({ text }) => text) };
  }

  test('writes each frame that was asked for, and puts them in their place at the end', async () => {
    const { editor, link, methods, texts } = await overRecording();
    expect(await renderFrames(editor, WISH)).toBe(true);
    expect(methods()).toEqual(['frames.begin', 'frames.add', 'frames.add', 'frames.add', 'frames.finish']);
    expect([link.asked[0], link.closed]).toEqual(['render-begin', true]);
    expect(texts()).toEqual(['Rendered 1 frame to /frames.']);
  });

  test('draws values that were set after the program was compiled', async () => {
    const { editor, link } = await overRecording();
    editor.compile.setState({ laterValues: [{ node: 'video-0000', param: 'opacity', value: 0.25 }] });
    await renderFrames(editor, WISH);
    expect(link.request?.values).toEqual([{ node: 'video-0000', param: 'opacity', value: 0.25 }]);
  });

  test('of an emulated room begins at its first frame, and keeps those asked for', async () => {
    const { editor, link, methods } = await overRecording();
    editor.preview.setState({ frames: null, sources: [{ id: 'room/a', title: 'A', kind: 'room', url: null }], sourceId: 'room/a' });
    expect(await renderFrames(editor, WISH)).toBe(true);
    expect(link.asked.filter((kind) => kind === 'render-frame')).toHaveLength(RANGE.to + 1);
    expect(methods().filter((method) => method === 'frames.add')).toHaveLength(3);
  });

  test('is cancelled by another project that is opened', async () => {
    const { editor, host, link, methods, texts } = await overRecording();
    host.answer('frames.add', async () => {
      host.refuse('frames.add', 'SCR073', 'No frames of this project are being rendered.');
      await openPath(editor, '/other');
      return {};
    });
    expect(await renderFrames(editor, WISH)).toBe(false);
    expect(texts()).toEqual(['Rendering canceled.']);
    expect([methods().at(-1), link.closed, editor.ui.getState().exporting]).toEqual(['frames.cancel', true, null]);
  });

  test('says what cannot be rendered frame by frame, and what has to be fixed', async () => {
    const { editor, link, texts } = await overRecording();
    editor.preview.setState({ sourceId: 'orbit' });
    expect(await renderFrames(editor, WISH)).toBe(false);
    expect(texts()).toEqual(['This preview source has no frames to render. Choose a recording or an emulated room below the preview.']);
    editor.preview.setState({ sourceId: null, shaderDiagnostics: [{ code: 'SCR042', severity: 'error', message: 'broken' }] });
    expect(await renderFrames(editor, WISH)).toBe(false);
    expect(texts().at(-1)).toBe('The project has problems. Fix them, then render again.');
    expect(link.asked).toEqual([]);
  });
});
