import { isHistoryDependent } from '../../../export/program/history-dependence.ts';
import { type Diagnostic, hasErrors } from '../../../nodes/kit/diagnostics.ts';
import { type FrameTimes, timeOfFrame } from '../../../nodes/kit/frame-times.ts';
import type { FrameRenderRequest, FrameRenderSource, PreviewSource } from '../../preview-protocol.ts';
import type { Editor, FrameRenderLink } from '../editor/editor.ts';
import { chosenSource, type FrameRange, towardsLight } from '../editor/preview-state.ts';
import { addToast, toastDiagnostic } from '../editor/ui.ts';
import { showRefusal } from '../files/files.ts';
import { previewSource } from './preview-source.ts';

/** What the person asked for. */
export interface FramesWish {
  readonly what: 'pictures' | 'video';
  readonly range: FrameRange;
  readonly widthPx: number;
  readonly heightPx: number;
  /** Null: the recording's own frames; rooms have none. */
  readonly frameRateHz: number | null;
  /** Folder for pictures; videos go where downloads do. */
  readonly out: string;
}

interface PlannedFrame {
  readonly timeS: number;
  /** Names the picture. */
  readonly number: number;
  /** Those before the range are played for what depends on them. */
  readonly keep: boolean;
}

/** Of an emulated room, where nothing else is asked for. */
export const ROOM_RATE_HZ = 30;

const ROUNDING_S = 1e-6;

/** The frames to play, in order. Of the recording's own, numbers are its own, too; at another rate they count from 0. */
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

/** Of an emulated room, which has no time of its own: all that come before are played, from the first one on. */
export function planRoomFrames({ from, to }: FrameRange, frameRateHz: number): readonly PlannedFrame[] {
  return Array.from({ length: to + 1 }, (_, number) => ({ timeS: number / frameRateHz, number, keep: number >= from }));
}

/** Whether the preview shows an emulated room. */
function isInRoom({ preview }: Pick<Editor, 'preview'>): boolean {
  return chosenSource(preview.getState())?.kind === 'room';
}

/** Frames per second of a recording, as videos of its own frames have them. */
export function rateOf({ timesS, durationS }: FrameTimes): number {
  return Math.round((timesS.length / durationS) * 1000) / 1000;
}

/** Asks what to render; says so where there is nothing to go through frame by frame. */
export function askForFrames(editor: Editor): void {
  if (editor.preview.getState().frames !== null || isInRoom(editor)) editor.ui.setState({ dialog: { kind: 'render' } });
  else tellOfSources(editor);
}

function tellOfSources({ ui }: Editor): void {
  addToast(ui, {
    tone: 'info',
    text: 'Frames are rendered over recordings and emulated rooms: choose one below the preview.',
    detail: 'What a camera sees comes once, and not frame by frame. The preview’s menu records it as a video.',
  });
}

/** Draws the frames of the project as it stands, beside the preview. True where they were written. */
export async function renderFrames(editor: Editor, wish: FramesWish): Promise<boolean> {
  const { open } = editor.document.getState();
  const { frames, shaderDiagnostics } = editor.preview.getState();
  const { program, programRevision, laterValues, diagnostics } = editor.compile.getState();
  if (open === null || editor.ui.getState().exporting !== null) return false;
  const source = previewSource(editor);
  const over = source && frameRenderSource(editor, source, wish.frameRateHz);
  if (!over || (frames === null && over.kind === 'recorded')) {
    tellOfSources(editor);
    return false;
  }
  if (programRevision !== editor.document.getState().revision && editor.compile.getState().busy) {
    addToast(editor.ui, { tone: 'info', text: 'The project is still being compiled: try again in a moment.' });
    return false;
  }
  if (program === null || hasErrors(diagnostics) || hasErrors(shaderDiagnostics)) {
    addToast(editor.ui, {
      tone: 'error',
      text: 'The project has problems. Fix them first.',
      detail: 'They are under Problems.',
    });
    editor.ui.setState({ bottom: 'problems' });
    return false;
  }
  const link = editor.renderPage.open?.();
  if (!link) return false;
  const { handle } = open;
  const { what, widthPx, heightPx, frameRateHz, out } = wish;
  const rateHz = over.kind === 'room' ? over.frameRateHz : (frameRateHz ?? (frames ? rateOf(frames) : 0));
  const video = what === 'video' ? { frameRateHz: rateHz } : null;
  const values = laterValues.map(({ node, param, value }) => ({ node, param, value }));
  const request: FrameRenderRequest = { program, values, source: over, assetBaseUrl: open.assetBaseUrl, widthPx, heightPx, video };
  const plan =
    over.kind === 'room' || frames === null
      ? planRoomFrames(wish.range, rateHz)
      : planFrames(frames, wish.range, frameRateHz, isHistoryDependent(program));
  editor.ui.setState({ exporting: { handle, text: 'Preparing…', cancelled: false, frames: true }, dialog: null });
  let begun = false;
  const stopped = cancellation(editor);
  /** Null where the person has had enough. */
  const ask = (message: FrameRenderQuestion) => Promise.race([link.ask(message), stopped.promise]);
  try {
    if (what === 'pictures') {
      await editor.host.call('frames.begin', { handle, out, widthPx, heightPx });
      begun = true;
    }
    if (filmed(await ask({ kind: 'render-begin', request })) === null) return tellCancelled(editor);
    const kept = plan.filter(({ keep }) => keep).length;
    let done = 0;
    for (const { timeS, number, keep } of plan) {
      if (keep) say(editor, `Frame ${++done} of ${kept}`);
      else say(editor, 'Playing earlier frames…');
      const answer = filmed(await ask({ kind: 'render-frame', timeS, keep }));
      if (answer === null) return tellCancelled(editor);
      if (answer.kind === 'frame-rendered' && answer.frame) await editor.host.call('frames.add', { handle, number, rgba: answer.frame });
    }
    if (isCancelled(editor)) return tellCancelled(editor);
    if (what === 'video') {
      const answer = filmed(await ask({ kind: 'render-end' }));
      if (answer?.kind !== 'render-finished' || answer.file === null) return tellCancelled(editor);
      giveVideo(editor, answer.file);
      return true;
    }
    begun = false;
    const { title } = editor.document.getState().project;
    const written = await editor.host.call('frames.finish', { handle, title, frameRateHz: rateHz });
    addToast(editor.ui, { tone: 'success', text: `Rendered ${counted(written.pictures)} to ${written.out}.` });
    return true;
  } catch (error) {
    // The host ends the work of a project that is closed.
    if (editor.document.getState().open?.handle !== handle) return tellCancelled(editor);
    if (error instanceof FrameRenderError) toastDiagnostic(editor.ui, error.diagnostic);
    else showRefusal(editor, error);
    return false;
  } finally {
    stopped.dispose();
    link.close();
    editor.ui.setState({ exporting: null });
    if (begun) await editor.host.call('frames.cancel', { handle }).catch((error: unknown) => showRefusal(editor, error));
  }
}

/** What the preview shows, as a film is drawn over it; a room from where the walk stands, in the light that it has now. */
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

/** What stopped the page that draws. */
class FrameRenderError extends Error {
  readonly diagnostic: Diagnostic;

  constructor(diagnostic: Diagnostic) {
    super(diagnostic.message);
    this.diagnostic = diagnostic;
  }
}

type FrameRenderQuestion = Parameters<FrameRenderLink['ask']>[0];
type FrameRenderAnswer = Awaited<ReturnType<FrameRenderLink['ask']>>;

function filmed(answer: FrameRenderAnswer | null): Exclude<FrameRenderAnswer, { kind: 'render-failed' }> | null {
  if (answer?.kind === 'render-failed') throw new FrameRenderError(answer.diagnostic);
  return answer;
}

/** Resolves when the person cancels, also while a frame takes its time. */
function cancellation({ ui }: Editor) {
  let dispose = () => {};
  const promise = new Promise<null>((resolve) => {
    dispose = ui.subscribe(({ exporting }) => {
      if (exporting?.cancelled) resolve(null);
    });
  });
  return { promise, dispose };
}

function giveVideo(editor: Editor, file: Blob): void {
  const { title } = editor.document.getState().project;
  const name = `${title.trim() === '' ? 'Video' : title}.${file.type === 'video/mp4' ? 'mp4' : 'webm'}`;
  editor.keepFile(file, name);
  addToast(editor.ui, { tone: 'success', text: `${name} is with your downloads.` });
}

function say({ ui }: Editor, text: string): void {
  ui.setState(({ exporting }) => ({ exporting: exporting && !exporting.cancelled ? { ...exporting, text } : exporting }));
}

function isCancelled({ ui }: Editor): boolean {
  return ui.getState().exporting?.cancelled === true;
}

function tellCancelled({ ui }: Editor): false {
  addToast(ui, { tone: 'info', text: 'Rendering was cancelled.', detail: 'Nothing was written.' });
  return false;
}

function counted(pictures: number): string {
  return pictures === 1 ? 'one picture' : `${pictures} pictures`;
}
