import { printSession } from '../../../export/runtime/sessions/print-session.ts';
import { recordInput } from '../../../export/runtime/sessions/record-input.ts';
import type { SessionFile, SessionFileInput } from '../../../export/runtime/sessions/session-format.ts';
import { multiplyMatrices } from '../../../nodes/kit/matrices.ts';
import type { PhysicsRoom } from '../../../nodes/kit/physics.ts';
import type { SessionFrame, ViewFrame } from '../../../nodes/kit/session.ts';
import type { FromPreview, PreviewSource, RecordedFiles, ToPreview } from '../../preview-protocol.ts';
import type { OpenSession } from '../open-session.ts';
import { createFileList, type Film, filmCamera, intrinsicsOf, type RecordedFrame } from './film.ts';
import { filmCameraImages, filmNothing } from './film-camera.ts';
import { filmRoom } from './film-room.ts';

/** Records what a visitor of the preview does: where the head is, and the input, with images that a replay shows behind it. */
export interface SessionRecorder {
  /**
   * Starts or stops a recording.
   *
   * @param place What plays; null while nothing does.
   */
  receive(message: RecordMessage, place: RecordedPlace | null): void;
  /**
   * Called with each frame that was drawn.
   *
   * @param findRoom Finds the measured room of the physics world; null if there is none.
   */
  afterFrame(frame: SessionFrame, findRoom: () => PhysicsRoom | null): void;
  /** Ends the recording and makes the images. The editor gets `session-recorded`. */
  stop(): void;
}

/** What a recording is made of. */
export interface RecordedPlace extends Pick<OpenSession, 'video' | 'roomFromView'> {
  readonly source: PreviewSource;
  readonly lightDirectionWorld: Extract<ToPreview, { kind: 'room-light' }>['directionWorld'];
}

type RecordMessage = Extract<ToPreview, { kind: 'record-session' }>;

interface Recording {
  readonly film: Film;
  readonly title: string;
  readonly roomFromView: OpenSession['roomFromView'];
  readonly frames: RecordedFrame[];
  /** Projection of the first view in the last frame: cameras learn their field of view while they turn. Null before the first frame. */
  clipFromView: Float32Array | null;
  aspect: number;
  /** The voxels of the room when the recording began; null until the world has written them. */
  room: Uint8Array | null;
  /** Where the voxels are written; undefined before the first frame. */
  from: PhysicsRoom | null | undefined;
}

const FRAME_RATE_HZ = 30;
/** Frames come a little early or late. */
const EARLY_S = 0.004;
const MAX_RECORDING_S = 60;
/** A view whose aspect ratio differs by more shows another part of the image. */
const SAME_ASPECT = 0.01;
const ROOM_FILE = 'room.voxels';

const scratchRoomFromWorld = new Float32Array(16);

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
    finish(ended).then(
      (recorded) => send({ kind: 'session-recorded', recorded, text: '' }, [recorded.content.buffer]),
      (error: unknown) => refuse(`The session could not be recorded: ${error instanceof Error ? error.message : String(error)}`),
    );
  }

  function start(title: string, place: RecordedPlace | null): void {
    const film = place && filmOf(place);
    if (!place) refuse('Nothing can be recorded before the preview plays.');
    else if (!film) refuse('The preview replays a recording. Choose a room, a camera or orbit as its source to record a session.');
    else {
      const { roomFromView } = place;
      recording = { film, title, roomFromView, frames: [], clipFromView: null, aspect: 1, room: null, from: undefined };
    }
  }

  return {
    receive: ({ on, title }, place) => {
      if (on) start(title, place);
      else stop();
    },
    afterFrame: (frame, findRoom) => {
      const view = frame.views[0];
      if (!recording || !view || frame.viewCount === 0) return;
      readRoom(recording, findRoom);
      const { frames, film, roomFromView } = recording;
      const roomView = roomFromView?.() ?? null;
      if (roomView) multiplyMatrices(scratchRoomFromWorld, roomView, view.viewFromWorld);
      const input = recordInput(frame.input, roomView && scratchRoomFromWorld);
      const lastS = frames.at(-1)?.timeS;
      if (lastS !== undefined && !(frame.timeS > lastS)) return;
      if (lastS !== undefined && frame.timeS - lastS < 1 / FRAME_RATE_HZ - EARLY_S && !changesPress(input)) return;
      if (frames.length === 0) recording.aspect = aspectOf(view);
      if (Math.abs(aspectOf(view) / recording.aspect - 1) < SAME_ASPECT) recording.clipFromView = view.clipFromView.slice();
      if (!recording.clipFromView || !film.take(view, filmCamera(recording.clipFromView, recording.aspect))) return;
      frames.push({ timeS: frame.timeS, worldFromCamera: [...(roomView ?? view.worldFromView)], ...(input && { input }) });
      if (frame.timeS - (frames[0]?.timeS ?? 0) >= MAX_RECORDING_S) stop();
    },
    stop,
  };
}

function filmOf({ source, video, lightDirectionWorld }: RecordedPlace): Film | null {
  switch (source.kind) {
    case 'room':
      return filmRoom(source.captureUrl, lightDirectionWorld);
    case 'camera':
    case 'still':
      return video && filmCameraImages(video);
    case 'orbit':
      return filmNothing();
    case 'recorded':
      return null;
  }
}

/** A press begins or ends in a single frame, which must not be lost. */
function changesPress(input: SessionFileInput | undefined): boolean {
  return input?.pointers?.some(({ phase }) => phase === 'start' || phase === 'end' || phase === 'cancel') ?? false;
}

function aspectOf({ viewport }: ViewFrame): number {
  return viewport.widthPx / Math.max(1, viewport.heightPx);
}

/** Asks for the voxels in the first frame, and takes them when the world has answered. */
function readRoom(recording: Recording, findRoom: () => PhysicsRoom | null): void {
  if (recording.from === undefined) {
    recording.from = findRoom();
    if (recording.from) Object.assign(recording.from, { file: null, wantsFile: true });
  }
  recording.room ??= recording.from?.file ?? null;
}

async function finish({ film, title, frames, clipFromView, aspect, room }: Recording): Promise<RecordedFiles> {
  const camera = filmCamera(clipFromView ?? new Float32Array(16), aspect);
  const files = createFileList();
  const { paths, head } = await film.make(frames, camera, files);
  if (room) files.add(ROOM_FILE, room);
  const startS = frames[0]?.timeS ?? 0;
  const session: SessionFile = {
    format: 'scrim-session',
    version: 1,
    title,
    color: { widthPx: camera.widthPx, heightPx: camera.heightPx, intrinsics: intrinsicsOf(camera, camera.widthPx, camera.heightPx) },
    frameRateHz: FRAME_RATE_HZ,
    ...head,
    ...(room && { room: ROOM_FILE }),
    frames: frames.map(({ timeS, ...frame }, i) => ({ timeS: timeS - startS, color: '', ...paths[i], ...frame })),
  };
  return { session: printSession(session), ...files.joined() };
}
