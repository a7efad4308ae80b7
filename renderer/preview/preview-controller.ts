import type { Program } from '../../export/program/program.ts';
import type { FrameClock } from '../../export/runtime/clock.ts';
import type { PlayResult } from '../../export/runtime/player.ts';
import { showLayer } from '../../export/runtime/present/show-layer.ts';
import type { SessionFrame } from '../../nodes/kit/session.ts';
import { watchDrags } from '../drag-watch.ts';
import type { FromPreview, HiddenWork, PreviewSource, ToPreview } from '../preview-protocol.ts';
import { createCaptures } from './captures.ts';
import { coalesce } from './coalesce.ts';
import { createFrameDrawing } from './frame-drawing.ts';
import { createGizmo } from './gizmo/gizmo.ts';
import { createHeldImage } from './held-image.ts';
import { createKeys } from './keys.ts';
import { createLayerGate } from './layer-gate.ts';
import { type OpenSession, openSession, sessionKey, standsInRoom } from './open-session.ts';
import { createPhysicsView, roomOf } from './physics/physics-view.ts';
import { createPlayerHost, type PlayerHost } from './player-host.ts';
import { type CaptureSource, createPosters, type PosterRequest, sourceOnCanvas } from './posters.ts';
import { createProbes } from './probes.ts';
import { createProblemReport } from './problem-report.ts';
import { createSessionRecorder } from './recording/session-recorder.ts';
import { createRenderResolution, drawsInSoftware, setCanvasSize } from './render-resolution.ts';
import { isHandKey } from './room-hands.ts';
import { createRoomPanorama } from './room-panorama.ts';
import { isTrackingKey } from './room-tracking.ts';
import { createSimulatedSensors } from './simulated-sensors.ts';
import { createStatus } from './status.ts';
import { createSteps } from './steps.ts';
import { createThumbnails } from './thumbnails.ts';
import { createTransportClock } from './transport-clock.ts';
import { createTrialCompiler } from './trial-compiler.ts';
import { isStep } from './walk.ts';

export interface PreviewControllerOptions {
  /** Parent element of the canvas. */
  readonly parent: HTMLElement;
  /** The element in which an emulated device shows its image. */
  readonly screen: HTMLElement;
  /** Element that shows the keys of simulated sensors. */
  readonly sensorHint: HTMLElement;
  readonly clock: FrameClock;
  readonly send: (message: FromPreview, transfer?: Transferable[]) => void;
}

export interface PreviewController {
  /** Handles a message of the editor. Those of `HiddenWork` are handled by others. */
  receive(message: ToPreview): void;
  /** Called when the window was resized. */
  resized(): void;
}

type Viewer = Extract<ToPreview, { kind: 'viewer' }>;

interface Wanted {
  readonly revision: number;
  readonly program: Program;
}

/** Duration of one step for sessions other than recordings. */
const DISPLAY_FRAME_S = 1 / 60;

/** Drives the player and the sessions of the preview. Messages store the wanted state; `settle` creates what it needs. */
export function createPreviewController({ parent, screen, sensorHint, clock: base, send }: PreviewControllerOptions): PreviewController {
  let wanted: Wanted | null = null;
  let source: PreviewSource | null = null;
  /** Counter of the message that set `source`. */
  let request = 0;
  let metering = false;

  let host: PlayerHost | null = null;
  let open: OpenSession | null = null;
  /** The key of the open session, by `sessionKey`. */
  let openKey = '';
  let lost = false;
  /** Whether the program is ready to be drawn. */
  let plays = false;
  /** Whether the session has drawn a frame of it. */
  let shown = false;
  /** The revision whose program plays from the next frame on. */
  let arriving: number | null = null;
  /** The last revision whose result the editor knows. */
  let reported: number | null = null;
  const problems = createProblemReport(send);
  const posters = createPosters(send, () => clock.wake());
  const captures = createCaptures(send, () => clock.wake());
  const panorama = createRoomPanorama(send, () => clock.wake());
  const recorder = createSessionRecorder(send);
  const probes = createProbes(send, () => clock.wake());
  let lightWorld: Extract<ToPreview, { kind: 'room-light' }>['directionWorld'] = null;
  const gizmo = createGizmo(parent, send, () => clock.wake());
  const physics = createPhysicsView(parent, send, () => clock.wake());
  const sensors = createSimulatedSensors(window, sensorHint);
  const isRoomKey = (event: KeyboardEvent, device: string): boolean =>
    isStep(event) || (device !== 'phone' && isHandKey(event)) || (!!wanted && standsInRoom(wanted.program) && isTrackingKey(event));
  const keys = createKeys(window, send, (event) => sensors.isKey(event) || (source?.kind === 'room' && isRoomKey(event, source.device)));
  let viewer: Viewer = { kind: 'viewer', left: null, right: null, split: 1, probed: null };
  const clock = createTransportClock(base, () => {
    posters.beforeFrame();
    probes.beforeFrame(captureSource());
    captures.beforeFrame(captureSource());
    if (!posters.busy) applySize();
  });
  const resolution = createRenderResolution(window, base, () => clock.wake());
  watchDrags(window, resolution.rest, (on) => resolution.setDragging('preview', on));
  const applySize = () => {
    if (source?.kind === 'room') open?.resize(null);
    else if (host) setCanvasSize(host.canvas, resolution.sizePx());
  };
  const status = createStatus(base, send);
  const thumbnails = createThumbnails(base, send);
  const gate = createLayerGate();
  const drawFrame = createFrameDrawing({ clock, gate, thumbnails });
  const trialCompiler = createTrialCompiler(base, send);
  const held = createHeldImage(screen, base);
  const steps = createSteps(() => {
    clock.step(open?.recording?.step() ?? DISPLAY_FRAME_S);
    clock.wake();
  });

  const updateState = () => {
    status.setState(lost ? 'lost' : !shown ? 'loading' : clock.playing ? 'playing' : 'paused');
    clock.wake();
  };
  const fail = (error: unknown) => {
    const reason = error instanceof Error ? error.message : String(error);
    problems.setSession([{ code: 'SCR053', severity: 'error', message: `The preview cannot draw: ${reason}` }]);
  };
  const report = (revision: number, { outcome, shaderErrors }: PlayResult) => {
    if (outcome === 'superseded') return;
    reported = revision;
    send({ kind: 'shader-errors', revision, errors: shaderErrors.map(({ shaderId, stage, log }) => ({ shaderId, stage, log })) });
    if (outcome === 'playing') {
      plays = true;
      arriving = revision;
    }
    problems.programChanged();
    thumbnails.invalidateAfterPause();
    clock.wake();
  };

  const endSession = async () => {
    recorder.stop();
    held.keepScreen();
    shown = false;
    const ending = open;
    open = null;
    openKey = '';
    host?.player.setSession(null);
    await ending?.end();
  };
  const build = async ({ revision, program }: Wanted, { assetBaseUrl }: PreviewSource) => {
    panorama.stop();
    await endSession();
    if (host) held.keepCanvas(host.dispose());
    host = null;
    arriving = null;
    plays = false;
    lost = false;
    problems.forgetPlayer();
    const made = createPlayerHost({
      parent,
      program,
      assetBaseUrl,
      clock,
      send,
      gate,
      onDiagnostics: problems.setPlayer,
      onContext: (played) => {
        lost = played === null;
        updateState();
        // A program that was loading when the context was lost plays only now.
        if (played && wanted && wanted.revision !== reported) report(wanted.revision, played);
      },
    });
    host = made;
    resolution.setSoftware(drawsInSoftware(made.gl));
    setCanvasSize(made.canvas, resolution.sizePx());
    made.meter.setOn(metering);
    void made.player.ready.then((result) => {
      if (host === made) report(revision, result);
    });
  };
  const begin = async (playerHost: PlayerHost, { program }: Wanted, from: PreviewSource) => {
    await endSession();
    updateState();
    const { gl, canvas } = playerHost;
    const onEnd = () => pause();
    const opened = await openSession(from, { gl, canvas, clock, program, screen, sizePx: resolution.sizePx, onEnd, onArrival: clock.wake });
    open = opened;
    // The editor answers with the play range.
    send({ kind: 'frames', frames: opened.recording?.frames ?? null, shape: opened.shape });
    openKey = sessionKey(from, program);
    if (lightWorld) opened.moveLight(lightWorld);
    problems.setSession(opened.diagnostics);
    if (opened.session === null) held.release();
    playerHost.player.setPanorama(panorama.enter(from));
    playerHost.player.reset();
    playerHost.player.setSession(opened.session);
    status.rewind(opened.recording?.frames ?? null);
    steps.restart();
    opened.session?.start(draw, (event) => {
      if (event.kind === 'reset') playerHost.player.reset(event.cause);
      if (event.kind === 'problem') problems.addSession({ code: 'SCR054', severity: 'warning', message: event.message });
    });
    updateState();
  };
  /** Tells the editor that the newest program is on the screen. */
  const showProgram = () => {
    if (arriving !== null) send({ kind: 'playing', revision: arriving });
    arriving = null;
    if (shown) return;
    shown = true;
    held.release();
    updateState();
  };
  const draw = (frame: SessionFrame) => {
    if (!host || lost) return;
    status.begin();
    resolution.begin();
    panorama.beforeDraw(frame);
    sensors.beforeFrame(frame);
    const needed = !shown || metering || source?.kind === 'room' || [posters, probes, captures].some(({ busy }) => busy);
    const drawn = drawFrame(host.player, frame, viewer, needed);
    recorder.afterFrame(frame, () => host && roomOf(host.player));
    status.end(frame, open?.recording?.isLate ?? false, drawn);
    host.meter.afterFrame();
    if (!posters.busy) showViewer(host.player, frame, viewer);
    if (plays) {
      posters.afterFrame();
      showProgram();
    }
    probes.afterFrame(host.player, frame, captureSource());
    captures.afterFrame(captureSource());
    if (!posters.busy) {
      gizmo.afterFrame(host.player, frame, captureSource());
      physics.afterFrame(host.player, frame, captureSource());
    }
    const restS = thumbnails.afterFrame(host.player);
    if (restS !== null) clock.wakeIn(restS);
    steps.afterFrame(open?.recording?.isLate ?? false);
    if (drawn) resolution.end();
  };
  const settle = coalesce(async () => {
    if (!wanted || !source) return;
    const asked = request;
    if (!host?.canPlay(wanted.program, source.assetBaseUrl)) await build(wanted, source);
    if (host && sessionKey(source, wanted.program) !== openKey) await begin(host, wanted, source);
    status.setRequest(asked);
  }, fail);

  const setProgram = (next: Wanted) => {
    wanted = next;
    problems.follow(next.revision, next.program);
    gate.follow(next.program);
    resolution.follow(next.program);
    sensors.follow(next.program);
    if (source && host?.canPlay(next.program, source.assetBaseUrl)) {
      void host.player.replaceProgram(next.program).then((result) => report(next.revision, result));
    }
    settle();
  };
  const pause = () => {
    clock.setPlaying(false);
    updateState();
  };
  const transport = (action: Extract<ToPreview, { kind: 'transport' }>['action']) => {
    if (action !== 'step') steps.restart();
    if (action === 'reset') {
      open?.rewind();
      host?.player.reset();
      status.rewind(open?.recording?.frames ?? null);
    } else if (action === 'step') steps.ask();
    else clock.setPlaying(action === 'play');
    if (action === 'play') open?.recording?.enterRange();
    updateState();
  };

  const captureSource = (): CaptureSource | null => {
    if (lost || !plays || !host || !open?.session) return null;
    if (source?.kind !== 'room') return sourceOnCanvas(host.canvas);
    const canvas = screen.querySelector('canvas');
    const { views } = source;
    const { resize } = open;
    return canvas && { canvas, views, shows: 'after it', resize: (size) => resize(size && [size.widthPx * views, size.heightPx]) };
  };
  const requestPoster = (asked: PosterRequest) => {
    const place = captureSource();
    if (place && host) posters.request(asked, place, host.player, open?.setHead ?? null);
    else posters.refuse(asked);
  };

  return {
    receive: (message) => {
      switch (message.kind) {
        case 'program':
          setProgram(message);
          return;
        case 'trials':
          trialCompiler.compile(message);
          return;
        case 'param':
          host?.player.setParam(message.node, message.param, message.value);
          thumbnails.invalidate();
          clock.wake();
          return;
        case 'session':
          ({ source, request } = message);
          settle();
          return;
        case 'room-light':
          lightWorld = message.directionWorld;
          open?.moveLight(lightWorld);
          clock.wake();
          return;
        case 'poster':
          requestPoster(message);
          return;
        case 'thumbnails':
          thumbnails.setPorts(message.ports, message.heightPx);
          clock.wake();
          return;
        case 'viewer':
          viewer = message;
          clock.wake();
          return;
        case 'cost':
          metering = message.on;
          host?.meter.setOn(metering);
          clock.wake();
          return;
        case 'take-panorama':
          panorama.take(lost ? null : host, open?.setHead ?? null, message.widthPx);
          return;
        case 'screenshot':
          captures.screenshot(captureSource());
          return;
        case 'render-size':
          resolution.setSize(message.size);
          return;
        case 'dragging':
          resolution.setDragging('editor', message.on);
          return;
        case 'record':
          resolution.setFixed(message.on);
          captures.record(message.on, captureSource());
          return;
        case 'record-session':
          recorder.receive(message, open?.session && source ? { ...open, source, lightDirectionWorld: lightWorld } : null);
          return;
        case 'probe':
          probes.ask(message);
          return;
        case 'gizmo':
        case 'picking':
          gizmo.receive(message);
          return;
        case 'physics':
        case 'physics-drop':
        case 'physics-view':
          physics.receive(message);
          return;
        case 'keys':
          keys.receive(message);
          return;
        case 'seek':
          steps.restart();
          open?.recording?.seek(message.timeS);
          clock.wake();
          return;
        case 'range':
          open?.recording?.setRange(message.range);
          if (clock.playing) open?.recording?.enterRange();
          return;
        case 'transport':
          transport(message.action);
          return;
        default:
          // Pages of their own render frames, take photographs and draw models.
          message satisfies HiddenWork;
      }
    },
    resized: clock.wake,
  };
}

function showViewer(player: PlayerHost['player'], frame: SessionFrame, { left, right, split }: Viewer): void {
  const [leftLayer, rightLayer] = [left === null ? null : player.inspect(left), right === null ? null : player.inspect(right)];
  for (let view = 0; view < frame.viewCount; view++) {
    if (leftLayer) showLayer(leftLayer, view, 0, split);
    if (rightLayer) showLayer(rightLayer, view, split, 1);
  }
}
