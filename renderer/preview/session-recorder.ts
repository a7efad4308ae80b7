import { encode } from 'fast-png';
import { createRoomFilm, type FilmCamera, surveyRoom } from '../../export/emulator/rooms/room-film.ts';
import { createRoom } from '../../export/emulator/rooms/room-source.ts';
import { printSession } from '../../export/runtime/sessions/print-session.ts';
import { recordInput } from '../../export/runtime/sessions/record-input.ts';
import type { Intrinsics, SessionFile, SessionFileFrame, SessionFileInput } from '../../export/runtime/sessions/session-format.ts';
import type { SessionFrame, ViewFrame } from '../../nodes/kit/session.ts';
import type { FromPreview, PreviewSource, RecordedFiles, ToPreview } from '../preview-protocol.ts';
import { loadRoom } from './open-session.ts';

/**
 * Records what a visitor of an emulated room does: where the head was, and the input. The images are made afterwards, from the same
 * places in the same room, because filming in between would hold up what is recorded.
 */
export interface SessionRecorder {
  /**
   * Starts or stops a recording.
   *
   * @param source Null while it does not play.
   */
  receive(message: RecordMessage, source: PreviewSource | null, lightDirectionWorld: LightDirection): void;
  /** Called with each frame that was drawn. */
  afterFrame(frame: SessionFrame): void;
  /** Ends the recording and films the room. The editor gets `session-recorded`. */
  stop(): void;
}

type RecordMessage = Extract<ToPreview, { kind: 'record-session' }>;
type LightDirection = Extract<ToPreview, { kind: 'room-light' }>['directionWorld'];

/** A frame without its images. */
type RecordedFrame = Pick<SessionFileFrame, 'timeS' | 'worldFromCamera' | 'input'>;

interface Recording {
  readonly captureUrl: string | null;
  readonly lightDirectionWorld: LightDirection;
  readonly title: string;
  readonly frames: RecordedFrame[];
  /** Of the first view; null before the first frame. */
  clipFromView: Float32Array | null;
  aspect: number;
}

const FRAME_RATE_HZ = 30;
/** Frames come a little early or late. */
const EARLY_S = 0.004;
const MAX_RECORDING_S = 60;
/** Of the longer side of color images; depth has half of it, as on phones. */
const LONG_SIDE_PX = 480;
const METERS_PER_UNIT = 0.001;
const JPEG_QUALITY = 0.82;

export function createSessionRecorder(send: (message: FromPreview, transfer?: Transferable[]) => void): SessionRecorder {
  let recording: Recording | null = null;

  function refuse(text: string): void {
    send({ kind: 'session-recorded', recorded: null, text });
  }

  function stop(): void {
    const ended = recording;
    recording = null;
    if (!ended) return;
    if (ended.frames.length === 0) {
      refuse('Nothing was recorded, because the preview is paused.');
      return;
    }
    send({ kind: 'session-filming' });
    filmRecording(ended).then(
      (recorded) => send({ kind: 'session-recorded', recorded, text: '' }, [recorded.content.buffer]),
      (error: unknown) => refuse(`The session could not be recorded: ${error instanceof Error ? error.message : String(error)}`),
    );
  }

  return {
    receive: ({ on, title }, source, lightDirectionWorld) => {
      if (!on) stop();
      else if (source?.kind !== 'room') refuse('Choose an emulated room as the source of the preview first.');
      else recording = { captureUrl: source.captureUrl, lightDirectionWorld, title, frames: [], clipFromView: null, aspect: 1 };
    },
    afterFrame: (frame) => {
      const view = frame.views[0];
      if (!recording || !view || frame.viewCount === 0) return;
      const { frames } = recording;
      const input = recordInput(frame.input);
      const lastS = frames.at(-1)?.timeS;
      if (lastS !== undefined && !(frame.timeS > lastS)) return;
      if (lastS !== undefined && frame.timeS - lastS < 1 / FRAME_RATE_HZ - EARLY_S && !changesPress(input)) return;
      recording.clipFromView ??= Float32Array.from(view.clipFromView);
      if (frames.length === 0) recording.aspect = aspectOf(view);
      frames.push({ timeS: frame.timeS, worldFromCamera: [...view.worldFromView], ...(input && { input }) });
      if (frame.timeS - (frames[0]?.timeS ?? 0) >= MAX_RECORDING_S) stop();
    },
    stop,
  };
}

/** A press begins or ends in a single frame, which must not be lost. */
function changesPress(input: SessionFileInput | undefined): boolean {
  return input?.pointers?.some(({ phase }) => phase === 'start' || phase === 'end' || phase === 'cancel') ?? false;
}

function aspectOf({ viewport }: ViewFrame): number {
  return viewport.widthPx / Math.max(1, viewport.heightPx);
}

async function filmRecording({ captureUrl, lightDirectionWorld, title, frames, clipFromView, aspect }: Recording): Promise<RecordedFiles> {
  const source = await loadRoom(captureUrl);
  if (source === null || clipFromView === null) throw new Error('the room could not be read.');
  const room = createRoom(source);
  room.moveLight(lightDirectionWorld);
  const camera = cameraOf(clipFromView, aspect);
  const film = createRoomFilm(room, camera);
  const files: { path: string; bytes: number }[] = [];
  const parts: Uint8Array[] = [];
  const add = (path: string, bytes: Uint8Array) => {
    files.push({ path, bytes: bytes.length });
    parts.push(bytes);
  };
  try {
    const startS = frames[0]?.timeS ?? 0;
    const filmed: SessionFileFrame[] = [];
    for (const [i, { timeS, ...frame }] of frames.entries()) {
      const number = String(i).padStart(6, '0');
      const [color, depth] = [`color/${number}.jpg`, `depth/${number}.png`];
      const { jpeg, meters } = await film.shoot(frame.worldFromCamera);
      add(color, jpeg);
      add(depth, encodeDepth(meters, camera));
      filmed.push({ timeS: timeS - startS, color, depth, ...frame });
    }
    const session: SessionFile = {
      format: 'scrim-session',
      version: 1,
      title,
      color: { widthPx: camera.widthPx, heightPx: camera.heightPx, intrinsics: intrinsicsOf(camera, camera.widthPx, camera.heightPx) },
      depth: {
        widthPx: camera.depthWidthPx,
        heightPx: camera.depthHeightPx,
        intrinsics: intrinsicsOf(camera, camera.depthWidthPx, camera.depthHeightPx),
        metresPerUnit: METERS_PER_UNIT,
        kind: 'z',
      },
      frameRateHz: FRAME_RATE_HZ,
      ...surveyRoom(room),
      frames: filmed,
    };
    return { session: printSession(session), files, content: joined(parts) };
  } finally {
    film.dispose();
    room.dispose();
  }
}

/** Sides are even, so that depth has exactly half of them. */
function cameraOf(clipFromView: Float32Array, aspect: number): FilmCamera {
  const even = (px: number) => Math.max(2, 2 * Math.round(px / 2));
  const widthPx = even(aspect >= 1 ? LONG_SIDE_PX : LONG_SIDE_PX * aspect);
  const heightPx = even(aspect >= 1 ? LONG_SIDE_PX / aspect : LONG_SIDE_PX);
  return {
    widthPx,
    heightPx,
    depthWidthPx: widthPx / 2,
    depthHeightPx: heightPx / 2,
    clipFromView,
    jpegQuality: JPEG_QUALITY,
    oversampling: 1,
  };
}

/** The pinhole camera of a projection, with y down. */
function intrinsicsOf({ clipFromView }: FilmCamera, widthPx: number, heightPx: number): Intrinsics {
  const at = (i: number) => clipFromView[i] ?? 0;
  return {
    fxPx: (at(0) * widthPx) / 2,
    fyPx: (at(5) * heightPx) / 2,
    cxPx: ((1 - at(8)) * widthPx) / 2,
    cyPx: ((1 + at(9)) * heightPx) / 2,
  };
}

function encodeDepth(meters: Float32Array, { depthWidthPx, depthHeightPx }: FilmCamera): Uint8Array {
  const data = Uint16Array.from(meters, (m) => Math.min(0xffff, Math.round(m / METERS_PER_UNIT)));
  return encode({ width: depthWidthPx, height: depthHeightPx, data, depth: 16, channels: 1 });
}

function joined(parts: readonly Uint8Array[]): Uint8Array<ArrayBuffer> {
  const all = new Uint8Array(parts.reduce((sum, { length }) => sum + length, 0));
  let at = 0;
  for (const part of parts) {
    all.set(part, at);
    at += part.length;
  }
  return all;
}
