import type { Capability } from '../../nodes/kit/definition.ts';
import type { Result } from '../../nodes/kit/diagnostics.ts';
import type { NodeModule } from '../../nodes/kit/runtime.ts';
import type { Session, SessionEvent } from '../../nodes/kit/session.ts';
import type { Program } from '../program/program.ts';
import type { AssetSource } from '../runtime/assets/asset-source.ts';
import { createBrowserClock } from '../runtime/clock.ts';
import type { CreateSceneBackend } from '../runtime/scene-backend.ts';
import type { CreateLens } from '../runtime/sessions/camera/lens.ts';
import { requestCameraSession } from '../runtime/sessions/camera/request-camera.ts';
import type { SessionInputs } from '../runtime/sessions/input/session-inputs.ts';
import { createOrbitSession } from '../runtime/sessions/orbit/orbit-session.ts';
import { requestWebXrSession } from '../runtime/sessions/webxr/request-session.ts';
import type { CreateSpatial } from '../runtime/spatial/spatial.ts';
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
  readonly createLens: CreateLens | null;
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
  /** Enters a session mode. Call it from a click handler. On failure it shows the reason and the fallbacks and keeps the orbit view. */
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
  const offer = () => panel.show({ kind: 'ready', offers, reason: modes.noAr });
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
          return onEvent(immersive, event);
        case 'camera':
          return onEvent('camera', event);
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

  const onEvent = (mode: SessionMode, event: SessionEvent) => {
    switch (event.kind) {
      case 'ended':
        for (const topic of ['tracking', 'missing', 'hint', ...Object.keys(SILENT)]) notices.clear(topic);
        step?.end();
        offer();
        root.setMode(null);
        if (event.by === 'page') return;
        notices.show('ended', { text: ENDED[mode], tone: 'hint' });
        void lookAround();
        return;
      case 'tracking':
        step?.setTracked(event.tracked);
        if (event.tracked) notices.clear('tracking');
        else notices.show('tracking', { text: UNTRACKED[mode], tone: 'hint' });
        // The hint says to turn the device.
        if (mode === 'camera' && !event.tracked) notices.clear('hint');
        return;
      case 'sensing': {
        const text = SILENT[event.capability];
        if (event.working) notices.clear(event.capability);
        else if (text !== undefined) notices.show(event.capability, { text, tone: 'hint' });
        return;
      }
      case 'problem':
        notices.show('session', { text: event.message, tone: 'problem' });
        return;
      case 'visibility':
      case 'reset':
      case 'recentered':
        return;
      default:
        event satisfies never;
    }
  };
  const request = (mode: SessionMode): Promise<Result<Session>> => {
    const { gl } = mounted;
    if (mode === 'camera') {
      const { inputs, createLens } = parts;
      return requestCameraSession({ window: page, media: page.navigator.mediaDevices, gl, canvas, clock, inputs, createLens });
    }
    return requestWebXrSession({
      inputs: parts.inputs,
      mode: mode === 'vr' ? 'immersive-vr' : 'immersive-ar',
      xr: page.navigator.xr,
      gl,
      needs: program.needs,
      antialias: program.presentation.antialias,
      overlayRoot: root.overlay,
    });
  };

  return {
    ready: mounted.player.ready.then(({ shaderErrors }) => {
      isReady = true;
      if (shaderErrors.length > 0) notices.show('shaders', { text: SHADERS_BROKEN, tone: 'problem' });
    }),
    get isReady() {
      return isReady;
    },
    enter: async (mode) => {
      panel.show({ kind: 'entering', mode });
      for (const topic of ['ended', 'session']) notices.clear(topic);
      const { output, diagnostics } = await request(mode);
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
      if (mode === 'camera') notices.show('hint', { text: CAMERA_HINT, tone: 'hint' });
      if (mode !== 'vr') await step?.begin(output);
      await mounted.play(output);
    },
    lookAround,
    setParam: (node, param, value) => {
      mounted.player.setParam(node, param, value);
    },
  };
}

const ENDED: Readonly<Record<SessionMode, string>> = {
  ar: 'AR has ended. You can enter it again.',
  camera: 'The camera stopped. Close other apps that use it, then try again.',
  vr: 'VR has ended. You can enter it again.',
};

const UNTRACKED: Readonly<Record<SessionMode, string>> = {
  ar: 'Looking for the room: move slowly, with enough light.',
  camera: 'This device has no motion sensor. Drag to look around.',
  vr: 'The headset lost tracking. Look around slowly, with enough light.',
};

/** Notice for each feature that was granted but currently delivers no data. */
const SILENT: Readonly<Partial<Record<Capability, string>>> = {
  depth: 'The device measures no depth at the moment, so real objects hide nothing. Move it slowly from side to side.',
  'light-estimation': 'The device does not measure the light of the room at the moment. Default light is used.',
};

const CAMERA_HINT = 'Turn the device to look around. Drag up or down until objects stand on the floor. Pinch or scroll to zoom.';
const CONTEXT_LOST = 'Graphics were interrupted. If they do not return, reload the page.';
const SHADERS_BROKEN = 'Part of this page cannot be drawn on this device. Try another browser or device.';
