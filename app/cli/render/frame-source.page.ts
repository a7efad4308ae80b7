import type { Emulator, HeadPose } from '../../../export/emulator/emulator.ts';
import { installEmulator } from '../../../export/emulator/install-emulator.ts';
import type { Program } from '../../../export/program/program.ts';
import { createFetchAssetSource } from '../../../export/runtime/assets/asset-source.ts';
import { createRecordedSession } from '../../../export/runtime/sessions/recorded/recorded-session.ts';
import { requestWebXrSession } from '../../../export/runtime/sessions/webxr/request-session.ts';
import type { Diagnostic, Result } from '../../../nodes/kit/diagnostics.ts';
import type { Session, SessionEvent, SessionFrame } from '../../../nodes/kit/session.ts';

/** Pose of the head in a room: the start pose of the walk in the editor’s preview. Meters; the quaternion is a pitch of -0.15 rad. */
const ROOM_POSE: HeadPose = { position: [0, 1.5, 1], quaternion: [-Math.sin(0.075), 0, 0, Math.cos(0.075)] };

/** Source of the frames. URLs are relative to the page. */
export type RenderSession =
  | { readonly kind: 'recorded'; readonly url: string }
  /** An emulated room. `captureUrl` is the URL of a capture; null for the emulator’s built-in room. */
  | { readonly kind: 'room'; readonly captureUrl: string | null; readonly sizePx: readonly [number, number] };

/** A session that produces frames on request. */
export interface FrameSource {
  readonly session: Session;
  /** Number of frames; null if the session has no end. */
  readonly frameCount: number | null;
  /** Plays the frame; if `frameCount` is null, the next one. Returns false if there is no such frame. */
  step(index: number): Promise<boolean>;
  /** Reads the composited image of a room; null if the canvas of the program shows all. */
  readonly seen: Emulator['readComposite'] | null;
  /** Sets the pose of the head in a room, column-major 4×4; null gives the start pose back. Null for recordings. */
  readonly setHead: ((worldFromHead: Float32Array | null) => void) | null;
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
  return { output: { session, frameCount: output.frames.timesS.length, step: session.step, seen: null, setHead: null }, diagnostics };
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
  const setHead = (matrix: Float32Array | null) => emulator.setPose(matrix ? { matrix } : ROOM_POSE);
  return {
    output: { session: output, frameCount: null, step, seen: emulator.readComposite, setHead },
    diagnostics: asWarnings(diagnostics),
  };
}

/** Turns diagnostics into warnings, because missing features of the emulated device do not stop the render. */
function asWarnings(diagnostics: readonly Diagnostic[]): Diagnostic[] {
  return diagnostics.map((diagnostic) => ({ ...diagnostic, severity: 'warning' }));
}
