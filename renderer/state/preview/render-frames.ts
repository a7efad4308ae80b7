import { isHistoryDependent } from '../../../export/program/history-dependence.ts';
import { type FrameTimes, timeOfFrame } from '../../../nodes/kit/frame-times.ts';
import type { FrameRenderRequest, FrameRenderSource, PreviewSource } from '../../preview-protocol.ts';
import type { Editor } from '../editor/editor.ts';
import { chosenSource, type FrameRange, towardsLight } from '../editor/preview-state.ts';
import { addToast } from '../editor/ui.ts';
import { CANCELED, isCancelled, playDrawnWork, readyProgram, showProgress } from './drawn-work.ts';
import { previewSource } from './preview-source.ts';

/** Options of a frame render. */
export interface FrameRenderOptions {
  readonly what: 'pictures' | 'video';
  readonly range: FrameRange;
  readonly widthPx: number;
  readonly heightPx: number;
  /** Frame rate of the render. Null renders the frames of the recording; rooms need a frame rate. */
  readonly frameRateHz: number | null;
  /** Folder for images. Videos are saved to the downloads. */
  readonly out: string;
}

interface PlannedFrame {
  readonly timeS: number;
  /** Number in the file name. */
  readonly number: number;
  /** Whether the frame is returned. False for frames before the range, which are drawn only for stateful nodes. */
  readonly keep: boolean;
}

/** Default frame rate in an emulated room. */
export const ROOM_RATE_HZ = 30;

const ROUNDING_S = 1e-6;

/** Plans the frames to draw, in order. Frames of the recording keep their numbers; at another rate, frames are numbered from 0. */
export function planFrames(
  frames: FrameTimes,
  range: FrameRange,
  frameRateHz: number | null,
  historyDependent: boolean,
): readonly PlannedFrame[] {
  if (frameRateHz === null) {
    const first = historyDependent ? 0 : Math.max(0, range.from - 1);
    return Array.from({ length: range.to - first + 1 }, (_, i) => {
      const number = first + i;
      return { timeS: timeOfFrame(frames, number), number, keep: number >= range.from };
    });
  }
  const fromS = timeOfFrame(frames, range.from);
  const lengthS = timeOfFrame(frames, range.to + 1) - fromS;
  const count = Math.max(1, Math.ceil((lengthS - ROUNDING_S) * frameRateHz));
  const before = Math.floor((fromS + ROUNDING_S) * frameRateHz);
  const first = -(historyDependent ? before : Math.min(1, before));
  return Array.from({ length: count - first }, (_, i) => {
    const number = first + i;
    return { timeS: Math.max(0, fromS + number / frameRateHz), number, keep: number >= 0 };
  });
}

/** Plans the frames of an emulated room. A room has no seek, so all frames before the range are drawn. */
export function planRoomFrames({ from, to }: FrameRange, frameRateHz: number): readonly PlannedFrame[] {
  return Array.from({ length: to + 1 }, (_, number) => ({ timeS: number / frameRateHz, number, keep: number >= from }));
}

/** Whether the preview source is an emulated room. */
function isInRoom({ preview }: Pick<Editor, 'preview'>): boolean {
  return chosenSource(preview.getState())?.kind === 'room';
}

/** Frame rate of a recording. */
export function rateOf({ timesS, durationS }: FrameTimes): number {
  return Math.round((timesS.length / durationS) * 1000) / 1000;
}

/** Opens the dialog for frame renders, or explains why the source has no frames. */
export function openRenderDialog(editor: Editor): void {
  if (editor.preview.getState().frames !== null || isInRoom(editor)) editor.ui.setState({ dialog: { kind: 'render' } });
  else explainSources(editor);
}

function explainSources({ ui }: Editor): void {
  addToast(ui, {
    tone: 'info',
    text: 'This preview source has no frames to render. Choose a recording or an emulated room below the preview.',
    detail: 'To record a camera, choose “Record video” in the preview options.',
  });
}

/** Renders frames of the current project in a separate page. Returns true if they were written. */
export async function renderFrames(editor: Editor, options: FrameRenderOptions): Promise<boolean> {
  const { open } = editor.document.getState();
  const { frames } = editor.preview.getState();
  if (open === null || editor.ui.getState().exporting !== null) return false;
  const source = previewSource(editor);
  const over = source && frameRenderSource(editor, source, options.frameRateHz);
  if (!over || (frames === null && over.kind === 'recorded')) {
    explainSources(editor);
    return false;
  }
  const ready = readyProgram(editor, 'The project has problems. Fix them, then render again.');
  if (ready === null) return false;
  const { program, values } = ready;
  const { handle } = open;
  const { what, widthPx, heightPx, frameRateHz, out } = options;
  const rateHz = over.kind === 'room' ? over.frameRateHz : (frameRateHz ?? (frames ? rateOf(frames) : 0));
  const video = what === 'video' ? { frameRateHz: rateHz } : null;
  const request: FrameRenderRequest = { program, values, source: over, assetBaseUrl: open.assetBaseUrl, widthPx, heightPx, video };
  const plan =
    over.kind === 'room' || frames === null
      ? planRoomFrames(options.range, rateHz)
      : planFrames(frames, options.range, frameRateHz, isHistoryDependent(program));
  const done = await playDrawnWork(editor, {
    handle,
    text: 'Preparing…',
    cancelOnHost: () => editor.host.call('frames.cancel', { handle }),
    reportCanceled: () => addToast(editor.ui, { tone: 'info', text: 'Rendering canceled.', detail: 'Nothing was written.' }),
    run: async (page) => {
      if (what === 'pictures') {
        await editor.host.call('frames.begin', { handle, out, widthPx, heightPx });
        page.isOnHost = true;
      }
      // A folder that is refused is an error of the dialog.
      editor.ui.setState({ dialog: null });
      if ((await page.ask({ kind: 'render-begin', request })) === null) return CANCELED;
      const kept = plan.filter(({ keep }) => keep).length;
      let count = 0;
      for (const { timeS, number, keep } of plan) {
        if (keep) showProgress(editor, `Frame ${++count} of ${kept}`);
        else showProgress(editor, 'Playing earlier frames…');
        const answer = await page.ask({ kind: 'render-frame', timeS, keep });
        if (answer === null) return CANCELED;
        if (answer.kind === 'frame-rendered' && answer.frame) await editor.host.call('frames.add', { handle, number, rgba: answer.frame });
      }
      if (isCancelled(editor)) return CANCELED;
      if (what === 'video') {
        const answer = await page.ask({ kind: 'render-end' });
        if (answer?.kind !== 'render-finished' || answer.file === null) return CANCELED;
        saveVideo(editor, answer.file);
        return true;
      }
      page.isOnHost = false;
      const { title } = editor.document.getState().project;
      const written = await editor.host.call('frames.finish', { handle, title, frameRateHz: rateHz });
      addToast(editor.ui, { tone: 'success', text: `Rendered ${counted(written.pictures)} to ${written.out}.` });
      return true;
    },
  });
  return done !== null;
}

/** The source of the frame render: that of the preview; for a room with its current camera pose and light. */
function frameRenderSource({ preview }: Editor, source: PreviewSource, frameRateHz: number | null): FrameRenderSource | null {
  switch (source.kind) {
    case 'recorded':
      return { kind: 'recorded', url: source.url };
    case 'room': {
      const { roomLight, status } = preview.getState();
      return {
        kind: 'room',
        captureUrl: source.captureUrl,
        tier: source.tier,
        refuse: source.refuse,
        frameRateHz: frameRateHz ?? ROOM_RATE_HZ,
        lightDirectionWorld: roomLight && towardsLight(roomLight),
        worldFromHead: status?.worldFromView ?? null,
      };
    }
    case 'camera':
    case 'still':
    case 'orbit':
      return null;
  }
}

function saveVideo(editor: Editor, file: Blob): void {
  const { title } = editor.document.getState().project;
  const name = `${title.trim() === '' ? 'Video' : title}.${file.type === 'video/mp4' ? 'mp4' : 'webm'}`;
  editor.keepFile(file, name);
  addToast(editor.ui, { tone: 'success', text: `Saved ${name} to your downloads.` });
}

function counted(frames: number): string {
  return frames === 1 ? '1 frame' : `${frames} frames`;
}
