import { installEmulator } from '../../export/emulator/install-emulator.ts';
import type { EmulatorOptions } from '../../export/emulator/options.ts';
import type { Program } from '../../export/program/program.ts';
import { createFetchAssetSource } from '../../export/runtime/assets/asset-source.ts';
import type { FrameClock } from '../../export/runtime/clock.ts';
import { createCameraSession } from '../../export/runtime/sessions/camera/camera-session.ts';
import { createLens } from '../../export/runtime/sessions/camera/lens.ts';
import { listenForOrientation } from '../../export/runtime/sessions/camera/orientation-sensor.ts';
import { requestCameraSession } from '../../export/runtime/sessions/camera/request-camera.ts';
import type { CanvasFitter } from '../../export/runtime/sessions/fit-canvas.ts';
import { SESSION_INPUTS } from '../../export/runtime/sessions/input/session-inputs.ts';
import { createOrbitSession } from '../../export/runtime/sessions/orbit/orbit-session.ts';
import { createRecordedSession } from '../../export/runtime/sessions/recorded/recorded-session.ts';
import { requestWebXrSession } from '../../export/runtime/sessions/webxr/request-session.ts';
import type { Diagnostic, Result } from '../../nodes/kit/diagnostics.ts';
import type { FrameTimes } from '../../nodes/kit/frame-times.ts';
import type { Session } from '../../nodes/kit/session.ts';
import type { PreviewRange, PreviewSource } from '../preview-protocol.ts';
import { pageFetch } from './network.ts';
import type { SizePx } from './render-resolution.ts';
import { createRoomHands } from './room-hands.ts';
import { createRoomTouches } from './room-touches.ts';
import { createRoomTracking } from './room-tracking.ts';
import { createStillStream } from './still-stream.ts';
import { createWalk } from './walk.ts';

/** A session of the preview, with the control of its time. */
export interface OpenSession {
  /** The session; null if it could not be opened, as `diagnostics` says. */
  readonly session: Session | null;
  readonly diagnostics: readonly Diagnostic[];
  /** Controls the time of a recording; null if the session is not a recording. */
  readonly recording: RecordingTransport | null;
  /** Width of the images of a recording or camera divided by their height; null for other sessions. */
  readonly shape: number | null;
  rewind(): void;
  /** Resizes the screen of an emulated device from the next frame on; null: to that of the preview. No effect on other sessions. */
  resize(sizePx: readonly [width: number, height: number] | null): void;
  /** Applies the `room-light` message to an emulated room. No effect on other sessions. */
  moveLight(directionWorld: readonly [number, number, number] | null): void;
  /** Turns the head of an emulated device, column-major 4×4; null gives it back to the visitor. Null for other sessions. */
  readonly setHead: ((worldFromHead: Float32Array | null) => void) | null;
  /** The image of a camera; null for other sessions. */
  readonly video: HTMLVideoElement | null;
  /** Pose of the first view in an emulated room, against which world space drifts; null for other sessions. */
  readonly roomFromView: (() => Float32Array | null) | null;
  end(): Promise<void>;
}

/** Controls the time of a recording. */
export interface RecordingTransport {
  readonly frames: FrameTimes;
  /** The session shows an earlier frame while the current one is being decoded. */
  readonly isLate: boolean;
  /** Goes to a time in seconds since the recording began. */
  seek(timeS: number): void;
  /** Advances to the next frame. Returns the difference in seconds. */
  step(): number;
  setRange(range: PreviewRange | null): void;
  enterRange(): void;
}

export interface SessionPlace {
  readonly gl: WebGL2RenderingContext;
  readonly clock: FrameClock;
  readonly program: Program;
  /** The element in which an emulated device shows its image. */
  readonly screen: HTMLElement;
  /** The canvas of `gl`. */
  readonly canvas: HTMLCanvasElement;
  /** The size in which the preview renders. */
  readonly sizePx: () => SizePx;
  /** Called at the end of a play range without loop. */
  readonly onEnd: () => void;
  /** Called when a late frame of a recording has been decoded. */
  readonly onArrival: () => void;
}

/** The controller sizes the canvas. */
const SIZED: CanvasFitter = { update: () => {}, dispose: () => {} };

/** Opens a session for a preview source. Never rejects; failures are diagnostics. */
export function openSession(source: PreviewSource, place: SessionPlace): Promise<OpenSession> {
  switch (source.kind) {
    case 'recorded':
      return openRecording(source.url, place);
    case 'room':
      return openRoom(source, place);
    case 'camera':
      return openCamera(place);
    case 'still':
      return openStill(source.picture, place);
    case 'orbit':
      return Promise.resolve(opened({ output: createOrbitSession({ ...place, inputs: SESSION_INPUTS, fitter: SIZED }), diagnostics: [] }));
  }
}

async function openCamera({ gl, clock, canvas }: SessionPlace): Promise<OpenSession> {
  const media = navigator.mediaDevices;
  const result = await requestCameraSession({ window, media, gl, canvas, clock, inputs: SESSION_INPUTS, createLens, fitter: SIZED });
  return ofCamera(opened(result), result.output?.video);
}

async function openStill(image: Blob, { gl, clock, canvas }: SessionPlace): Promise<OpenSession> {
  const stream = createStillStream(canvas.ownerDocument, image);
  try {
    await stream.start();
  } catch {
    stream.stop();
    const message = 'The image for the preview could not be read.';
    return opened({ output: null, diagnostics: [{ code: 'SCR032', severity: 'error', message, fix: 'Choose a PNG, JPEG or WebP file.' }] });
  }
  const output = createCameraSession({
    gl,
    canvas,
    clock,
    stream,
    sensor: listenForOrientation(window),
    inputs: SESSION_INPUTS,
    fitter: SIZED,
  });
  return ofCamera(opened({ output, diagnostics: [] }), output.video);
}

function ofCamera(session: OpenSession, video: HTMLVideoElement | undefined): OpenSession {
  const known = video !== undefined && video.videoWidth > 0;
  return { ...session, video: video ?? null, shape: known ? video.videoWidth / video.videoHeight : null };
}

/** Two sources with the same key share a session. A recording depends only on its URL. */
export function sessionKey(source: PreviewSource, program: Program): string {
  switch (source.kind) {
    case 'recorded':
      return `recorded ${source.url}`;
    case 'room': {
      const { captureUrl, views, device, tier, refuse } = source;
      const { needs, presentation, readsInput } = program;
      return JSON.stringify([captureUrl, views, device, tier, refuse, needs, presentation.antialias, readsInput ?? false]);
    }
    case 'still':
      return `still ${source.key}`;
    case 'camera':
    case 'orbit':
      return source.kind;
  }
}

/** Wraps a session without controls. */
function opened({ output, diagnostics }: Result<Session>): OpenSession {
  return {
    session: output,
    diagnostics,
    recording: null,
    shape: null,
    rewind: () => {},
    resize: () => {},
    moveLight: () => {},
    setHead: null,
    video: null,
    roomFromView: null,
    end: async () => output?.end(),
  };
}

async function openRecording(url: string, { gl, clock, onEnd, onArrival }: SessionPlace): Promise<OpenSession> {
  const files = createFetchAssetSource(url, pageFetch);
  const session = createRecordedSession({ gl, files, mode: { kind: 'clock', clock }, inputs: SESSION_INPUTS, onEnd, onArrival });
  const { output, diagnostics } = await session.ready;
  return {
    ...opened({ output: output && session, diagnostics }),
    shape: output?.shape ?? null,
    recording: output && {
      frames: output.frames,
      get isLate() {
        return session.isLate;
      },
      seek: session.seekTime,
      step: () => {
        const fromS = session.playheadS;
        session.nextFrame();
        return session.playheadS - fromS;
      },
      setRange: session.setRange,
      enterRange: session.enterRange,
    },
    rewind: () => session.seek(0),
    end: () => session.end(),
  };
}

async function openRoom(source: Extract<PreviewSource, { kind: 'room' }>, place: SessionPlace): Promise<OpenSession> {
  const { gl, clock, program, screen } = place;
  const room = await loadRoom(source.captureUrl);
  if (room === null) {
    const message = 'The emulated room could not be read.';
    const broken: Diagnostic = { code: 'SCR054', severity: 'error', message, fix: 'Install Scrim again, or choose another source.' };
    return opened({ output: null, diagnostics: [broken] });
  }
  const { device, views, tier, refuse } = source;
  const emulator = installEmulator({ device, views, refuse, room, frameClock: clock, container: screen, sizePx: place.sizePx() });
  const [hint, trackingHint] = ['hint', 'tracking-hint'].map((id) => screen.ownerDocument.getElementById(id));
  const walk = createWalk(emulator, screen, clock, device === 'phone' && program.readsInput === true);
  // Phones have neither controllers nor hands; pages that read no input have no use for them.
  const createInput = device === 'phone' ? createRoomTouches : createRoomHands;
  const input = hint && program.readsInput ? createInput(emulator, screen, hint, clock) : null;
  const tracking = trackingHint && standsInRoom(program) ? createRoomTracking(emulator, trackingHint) : null;
  const { output, diagnostics } = await requestWebXrSession({
    xr: navigator.xr,
    inputs: SESSION_INPUTS,
    gl,
    needs: program.needs,
    antialias: program.presentation.antialias,
    mode: tier === 'vr' ? 'immersive-vr' : 'immersive-ar',
  });
  return {
    ...opened({ output, diagnostics }),
    rewind: walk.rewind,
    resize: (asked) => emulator.setSize(asked ?? place.sizePx()),
    moveLight: emulator.moveLight,
    setHead: (worldFromHead) => (worldFromHead ? emulator.setPose({ matrix: worldFromHead }) : walk.restore()),
    roomFromView: emulator.viewPose,
    end: async () => {
      walk.dispose();
      input?.dispose();
      tracking?.dispose();
      await output?.end();
      await emulator.uninstall();
    },
  };
}

/** Whether the program puts something at points of the real room, so that faults of tracking show. */
export function standsInRoom({ needs }: Program): boolean {
  return needs.some(({ capability }) => capability === 'anchors' || capability === 'hit-test');
}

export async function loadRoom(captureUrl: string | null): Promise<NonNullable<EmulatorOptions['room']> | null> {
  if (captureUrl === null) return 'studio';
  const response = await pageFetch(captureUrl).catch(() => null);
  if (!response?.ok) return null;
  const capture: unknown = await response.json().catch(() => null);
  return capture === null ? null : { capture };
}
