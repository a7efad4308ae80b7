import type { Result } from '../../nodes/kit/diagnostics.ts';
import type { NodeModule } from '../../nodes/kit/runtime.ts';
import type { Session, SessionEvent } from '../../nodes/kit/session.ts';
import type { Program } from '../program/program.ts';
import type { AssetSource } from '../runtime/assets/asset-source.ts';
import { createBrowserClock } from '../runtime/clock.ts';
import type { CreateSceneBackend } from '../runtime/scene-backend.ts';
import type { SessionInputs } from '../runtime/sessions/input/session-inputs.ts';
import { createOrbitSession } from '../runtime/sessions/orbit/orbit-session.ts';
import type { CreateSpatial } from '../runtime/spatial/spatial.ts';
import type { EnteredSessions } from './entered-sessions.ts';
import { type Mounted, type MountOptions, mount } from './mount.ts';
import { showDiagnostics } from './notices.ts';
import type { PageRoot } from './page-root.ts';
import type { CreatePagePanorama } from './panorama-step/page-panorama.ts';
import type { PanoramaStep } from './panorama-step/panorama-step.ts';
import type { SessionMode, SessionModes } from './session-modes.ts';

export interface PageControllerOptions {
  readonly modules: Readonly<Record<string, NodeModule>>;
  readonly createScenes: CreateSceneBackend | null;
  readonly createSpatial: CreateSpatial | null;
  readonly inputs: SessionInputs | null;
  readonly createPanel: MountOptions['createPanel'];
  readonly overlay: MountOptions['overlay'];
  /** Creates the step that takes a panorama of the room; null if the program uses none. */
  readonly createPanorama: CreatePagePanorama | null;
  readonly page: Window;
  readonly root: PageRoot;
  readonly program: Program;
  readonly assets: AssetSource;
  readonly modes: SessionModes;
}

/** Controls the sessions of the page (orbit, camera, AR, VR) and their notices. */
export interface PageController {
  /** Resolves when the first frame can be drawn. */
  readonly ready: Promise<void>;
  readonly isReady: boolean;
  /** Resolves when all files of the page are loaded or failed. */
  readonly complete: Promise<void>;
  /**
   * Sets the sessions that can be entered, and offers them.
   *
   * @param loaded Null if they could not be loaded or this device has none.
   * @param reason Why no better mode is offered, as text for visitors, or null.
   */
  offer(loaded: EnteredSessions | null, reason: string | null): void;
  /** Enters a session mode that was offered. Call it from a click handler. On failure it shows the reason and the fallbacks and keeps the orbit view. */
  enter(mode: SessionMode): Promise<void>;
  lookAround(): Promise<void>;
  /** Sets the param of a control, also after the player is set up again. */
  setParam(node: string, param: string, value: number | boolean): void;
}

/**
 * Creates the controller of a page, which starts in the orbit view.
 *
 * @throws Error if the browser has no WebGL 2.
 */
export function createPageController({ page, root, program, modes, createPanorama, ...parts }: PageControllerOptions): PageController {
  const { canvas, notices, panel } = root;
  const clock = createBrowserClock();
  let isReady = false;
  /** Mode of the current WebXR session. */
  let immersive: 'ar' | 'vr' = 'ar';
  let { offers } = modes;
  let sessions: EnteredSessions | null = null;
  let noBetter = modes.noAr;
  const offer = () => panel.show({ kind: 'ready', offers: sessions ? offers : [], reason: noBetter });
  const { around } = program.presentation;
  const orbit = (gl: WebGL2RenderingContext) =>
    createOrbitSession({ gl, canvas, clock, inputs: parts.inputs, ...(around && { start: around }) });
  let step: PanoramaStep | null = null;
  const interlude: MountOptions['interlude'] = createPanorama && {
    get covers() {
      return step?.covers ?? false;
    },
    frame: (frame) => step?.frame(frame),
    contextLost: () => step?.contextLost(),
  };
  const mounted: Mounted = mount(canvas, {
    ...parts,
    interlude,
    program,
    session: orbit,
    onDiagnostics: (diagnostics) => showDiagnostics(notices, 'player', diagnostics),
    onSessionEvent: (event, session) => {
      switch (session.kind) {
        case 'webxr':
          return sessions ? onEvent(immersive, event, session, sessions) : undefined;
        case 'camera':
          return sessions ? onEvent('camera', event, session, sessions) : undefined;
        case 'orbit':
        case 'recorded':
          if (event.kind === 'problem') notices.show('session', { text: event.message, tone: 'problem' });
          return;
        default:
          session.kind satisfies never;
      }
    },
    onContext: (state) => {
      if (state === 'restored') notices.clear('context');
      else notices.show('context', { text: CONTEXT_LOST, tone: 'problem' });
    },
  });
  step = createPanorama?.({ page, root, program, modules: parts.modules, gl: mounted.gl, setPanorama: mounted.player.setPanorama }) ?? null;
  const lookAround = () => mounted.play(orbit(mounted.gl));

  const onEvent = (mode: SessionMode, event: SessionEvent, { hidesPage = false }: Session, { texts, offerRoomScan }: EnteredSessions) => {
    switch (event.kind) {
      case 'ended':
        for (const topic of ['tracking', 'missing', 'hint', 'room', ...Object.keys(texts.silent)]) notices.clear(topic);
        step?.end();
        offer();
        root.setMode(null);
        if (event.by === 'page') return;
        notices.show('ended', { text: texts.ended[mode], tone: 'hint' });
        void lookAround();
        return;
      case 'tracking':
        step?.setTracked(event.tracked);
        if (event.tracked) notices.clear('tracking');
        else notices.show('tracking', { text: texts.untracked[mode], tone: 'hint' });
        // The hint says to turn the device.
        if (mode === 'camera' && !event.tracked) notices.clear('hint');
        return;
      case 'sensing': {
        const text = texts.silent[event.capability];
        if (event.working) notices.clear(event.capability);
        else if (text !== undefined) notices.show(event.capability, { text, tone: 'hint' });
        return;
      }
      case 'problem':
        notices.show('session', { text: event.message, tone: 'problem' });
        return;
      case 'room-unknown':
        offerRoomScan?.({ document: page.document, notices, mounted, hidesPage, capture: event.capture });
        return;
      case 'visibility':
      case 'reset':
      case 'recentered':
        return;
      default:
        event satisfies never;
    }
  };
  const request = (
    mode: SessionMode,
    { requestCamera, requestWebXr, createLens, inputs: ofPanel }: EnteredSessions,
  ): Promise<Result<Session>> => {
    const { gl } = mounted;
    const { inputs } = parts;
    if (mode === 'camera' && requestCamera) {
      return requestCamera({ window: page, media: page.navigator.mediaDevices, gl, canvas, clock, inputs, createLens });
    }
    return requestWebXr({
      inputs: inputs ?? ofPanel,
      mode: mode === 'vr' ? 'immersive-vr' : 'immersive-ar',
      xr: page.navigator.xr,
      gl,
      needs: program.needs,
      antialias: program.presentation.antialias,
      screenDepth: program.presentation.screenDepth,
      overlayRoot: root.overlay,
    });
  };

  return {
    ready: mounted.player.ready.then(({ shaderErrors }) => {
      isReady = true;
      if (shaderErrors.length > 0) notices.show('shaders', { text: SHADERS_BROKEN, tone: 'problem' });
    }),
    complete: mounted.player.complete,
    get isReady() {
      return isReady;
    },
    offer: (loaded, reason) => {
      sessions = loaded;
      noBetter = reason;
      offer();
    },
    enter: async (mode) => {
      if (sessions === null) return;
      const { cameraHint } = sessions;
      panel.show({ kind: 'entering', mode });
      for (const topic of ['ended', 'session']) notices.clear(topic);
      const { output, diagnostics } = await request(mode, sessions);
      showDiagnostics(notices, 'missing', diagnostics);
      if (output === null) {
        // Offers the fallbacks and another attempt.
        offers = modes.fallbacks;
        offer();
        panel.focus();
        return;
      }
      if (mode !== 'camera') immersive = mode;
      root.setMode(mode);
      if (mode === 'camera' && cameraHint !== null) notices.show('hint', { text: cameraHint, tone: 'hint' });
      if (mode !== 'vr') await step?.begin(output);
      await mounted.play(output);
    },
    lookAround,
    setParam: (node, param, value) => {
      mounted.player.setParam(node, param, value);
    },
  };
}

const CONTEXT_LOST = 'Graphics were interrupted. If they do not return, reload the page.';
const SHADERS_BROKEN = 'Part of this page cannot be drawn on this device. Try another browser or device.';
