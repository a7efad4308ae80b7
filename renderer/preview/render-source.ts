import { Matrix4, Quaternion, Vector3 } from 'three';
import type { HeadPose } from '../../export/emulator/emulator.ts';
import { installEmulator } from '../../export/emulator/install-emulator.ts';
import type { Program } from '../../export/program/program.ts';
import { createFetchAssetSource } from '../../export/runtime/assets/asset-source.ts';
import type { Player } from '../../export/runtime/player.ts';
import { readScreen } from '../../export/runtime/readback.ts';
import { SESSION_INPUTS } from '../../export/runtime/sessions/input/session-inputs.ts';
import { createRecordedSession } from '../../export/runtime/sessions/recorded/recorded-session.ts';
import { requestWebXrSession } from '../../export/runtime/sessions/webxr/request-session.ts';
import type { Diagnostic, Result } from '../../nodes/kit/diagnostics.ts';
import type { Session, SessionFrame } from '../../nodes/kit/session.ts';
import type { FrameRenderSource } from '../preview-protocol.ts';
import { pageFetch } from './network.ts';
import { loadRoom } from './open-session.ts';
import { START_POSE } from './walk.ts';

/** Draws the frames of a frame render. */
export interface OpenRenderSource {
  /** Draws the frame at this time, in seconds; a room draws its next frame. Resolves to false if there is no such frame. */
  draw(timeS: number): Promise<boolean>;
  /** Pixels as a visitor sees them, rows from the top. */
  read(): Uint8Array<ArrayBuffer>;
  /** Whether the canvas of the program shows these pixels. In a room it does not, because the room lies behind it. */
  readonly onCanvas: boolean;
}

export function openRenderSource(
  source: FrameRenderSource,
  gl: WebGL2RenderingContext,
  program: Program,
  player: Player,
): Promise<Result<OpenRenderSource>> {
  switch (source.kind) {
    case 'recorded':
      return openRecording(source.url, gl, player);
    case 'room':
      return openRoom(source, gl, program, player);
  }
}

async function openRecording(url: string, gl: WebGL2RenderingContext, player: Player): Promise<Result<OpenRenderSource>> {
  const session = createRecordedSession({ gl, files: createFetchAssetSource(url, pageFetch), mode: { kind: 'manual' } });
  const { output, diagnostics } = await session.ready;
  if (output === null) return { output: null, diagnostics };
  const drawn = startDrawing(player, session, (frame) => player.drawSettled(frame));
  const draw = async (timeS: number) => {
    if (!(await session.stepTo(timeS))) return false;
    await drawn();
    return true;
  };
  return { output: { draw, read: () => readScreen(gl).pixels, onCanvas: true }, diagnostics };
}

async function openRoom(
  { captureUrl, tier, refuse, frameRateHz, lightDirectionWorld, worldFromHead }: Extract<FrameRenderSource, { kind: 'room' }>,
  gl: WebGL2RenderingContext,
  program: Program,
  player: Player,
): Promise<Result<OpenRenderSource>> {
  const room = await loadRoom(captureUrl);
  if (room === null) throw new Error('the emulated room could not be read.');
  const sizePx = [gl.drawingBufferWidth, gl.drawingBufferHeight] as const;
  const emulator = installEmulator({
    device: 'phone',
    refuse,
    room,
    clock: 'manual',
    framesPerSecond: frameRateHz,
    sizePx,
    display: false,
    antialias: true,
  });
  emulator.setPose(worldFromHead === null ? START_POSE : poseOf(worldFromHead));
  emulator.moveLight(lightDirectionWorld);
  const { needs, presentation } = program;
  const mode = tier === 'vr' ? 'immersive-vr' : 'immersive-ar';
  const { output, diagnostics } = await requestWebXrSession({
    xr: navigator.xr,
    inputs: SESSION_INPUTS,
    gl,
    needs,
    antialias: presentation.antialias,
    mode,
  });
  if (output === null) return { output: null, diagnostics };
  // WebXR textures are valid only during their frame, so the frame is drawn without waiting. Videos therefore show the frame that was
  // requested one frame earlier.
  const drawn = startDrawing(player, output, (frame) => {
    player.draw(frame);
    return player.settle();
  });
  await emulator.frameRequested();
  const draw = async () => {
    await emulator.stepFrame();
    await drawn();
    return true;
  };
  const read = () => Uint8Array.from(emulator.readComposite().rgba);
  return { output: { draw, read, onCanvas: false }, diagnostics: asWarnings(diagnostics) };
}

/** Turns diagnostics into warnings, because missing features of the emulated device do not stop the render. */
function asWarnings(diagnostics: readonly Diagnostic[]): Diagnostic[] {
  return diagnostics.map((diagnostic) => ({ ...diagnostic, severity: 'warning' }));
}

function poseOf(worldFromHead: readonly number[]): HeadPose {
  const position = new Vector3();
  const quaternion = new Quaternion();
  new Matrix4().fromArray([...worldFromHead]).decompose(position, quaternion, new Vector3());
  return { position: [position.x, position.y, position.z], quaternion: [quaternion.x, quaternion.y, quaternion.z, quaternion.w] };
}

/** Plays the session. The returned function resolves when the current frame is completely drawn. */
function startDrawing(player: Player, session: Session, draw: (frame: SessionFrame) => Promise<void>): () => Promise<void> {
  let drawing: Promise<void> = Promise.resolve();
  player.setSession(session);
  session.start(
    (frame) => {
      drawing = draw(frame);
    },
    () => {},
  );
  return () => drawing;
}
