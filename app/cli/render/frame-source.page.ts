import type { Emulator, HeadPose } from '../../../export/emulator/emulator.ts';
import { installEmulator } from '../../../export/emulator/install-emulator.ts';
import type { Program } from '../../../export/program/program.ts';
import { createFetchAssetSource } from '../../../export/runtime/assets/asset-source.ts';
import { createRecordedSession } from '../../../export/runtime/sessions/recorded/recorded-session.ts';
import { requestWebXrSession } from '../../../export/runtime/sessions/webxr/request-session.ts';
import type { Diagnostic, Result } from '../../../nodes/kit/diagnostics.ts';
import type { Session, SessionEvent, SessionFrame } from '../../../nodes/kit/session.ts';

/** Where the viewer stands in a room: where the editor's preview begins its walk. Meters; 0.15 rad down, as a quaternion. */
const ROOM_POSE: HeadPose = { position: [0, 1.5, 1], quaternion: [-Math.sin(0.075), 0, 0, Math.cos(0.075)] };

/** Where frames come from; addresses are relative to the page. */
export type RenderSession =
  | { readonly kind: 'recorded'; readonly url: string }
  /** `captureUrl` null: the room that the emulator makes itself. */
  | { readonly kind: 'room'; readonly captureUrl: string | null; readonly sizePx: readonly [number, number] };

/** A session whose frames come when asked for. */
export interface FrameSource {
  readonly session: Session;
  /** Null: there is no end. */
  readonly frameCount: number | null;
  /** Frames go on from one to the next where `frameCount` is null. False where the frame could not be had. */
  step(index: number): Promise<boolean>;
  /** What a visitor saw in the last frame, where that is more than what the program drew. */
  readonly seen: Emulator['readComposite'] | null;
}

export interface FrameHandlers {
  readonly onFrame: (frame: SessionFrame) => void;
  readonly onEvent: (event: SessionEvent) => void;
}

export function openFrameSource(
  source: RenderSession,
  gl: WebGL2RenderingContext,
  program: Program,
  handlers: FrameHandlers,
): Promise<Result<FrameSource>> {
  switch (source.kind) {
    case 'recorded':
      return openRecording(source.url, gl, handlers);
    case 'room':
      return openRoom(source, gl, program, handlers);
  }
}

async function openRecording(url: string, gl: WebGL2RenderingContext, handlers: FrameHandlers): Promise<Result<FrameSource>> {
  const files = createFetchAssetSource(new URL(url, document.baseURI).href, fetch.bind(globalThis));
  const session = createRecordedSession({ gl, files, mode: { kind: 'manual' } });
  const { output, diagnostics } = await session.ready;
  if (output === null) return { output: null, diagnostics };
  session.start(handlers.onFrame, handlers.onEvent);
  return { output: { session, frameCount: output.frames.timesS.length, step: session.step, seen: null }, diagnostics };
}

async function openRoom(
  { captureUrl, sizePx }: Extract<RenderSession, { kind: 'room' }>,
  gl: WebGL2RenderingContext,
  program: Program,
  handlers: FrameHandlers,
): Promise<Result<FrameSource>> {
  const room = captureUrl === null ? 'studio' : { capture: await (await fetch(captureUrl)).json() };
  const emulator = installEmulator({ device: 'phone', room, clock: 'manual', sizePx, display: false, antialias: true });
  emulator.setPose(ROOM_POSE);
  const { antialias } = program.presentation;
  const { output, diagnostics } = await requestWebXrSession({ xr: navigator.xr, gl, needs: program.needs, antialias });
  if (output === null) return { output: null, diagnostics };
  output.start(handlers.onFrame, handlers.onEvent);
  await emulator.frameRequested();
  const step = async () => {
    await emulator.stepFrame();
    return true;
  };
  return { output: { session: output, frameCount: null, step, seen: emulator.readComposite }, diagnostics: asWarnings(diagnostics) };
}

/** The device is one of ours: what it lacks is told, and stops nothing. */
function asWarnings(diagnostics: readonly Diagnostic[]): Diagnostic[] {
  return diagnostics.map((diagnostic) => ({ ...diagnostic, severity: 'warning' }));
}
