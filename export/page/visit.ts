import type { Capability } from '../../nodes/kit/definition.ts';
import type { Result } from '../../nodes/kit/diagnostics.ts';
import type { Session, SessionEvent } from '../../nodes/kit/session.ts';
import type { Program } from '../program/program.ts';
import type { AssetSource } from '../runtime/assets/asset-source.ts';
import { createBrowserClock } from '../runtime/clock.ts';
import type { CreateSceneBackend } from '../runtime/scene-backend.ts';
import { requestCameraSession } from '../runtime/sessions/camera/request-camera.ts';
import { createOrbitSession } from '../runtime/sessions/orbit/orbit-session.ts';
import { requestWebXrSession } from '../runtime/sessions/webxr/request-session.ts';
import { type Mounted, type MountOptions, mount } from './mount.ts';
import { showDiagnostics } from './notices.ts';
import type { Stage } from './stage.ts';
import type { PageParts } from './start-page.ts';
import { canUseCamera, type Way, type Ways } from './way-texts.ts';

export interface VisitOptions {
  readonly modules: PageParts['modules'];
  readonly createScenes: CreateSceneBackend | null;
  readonly createPanel: MountOptions['createPanel'];
  readonly page: Window;
  readonly stage: Stage;
  readonly program: Program;
  readonly assets: AssetSource;
  readonly ways: Ways;
}

/** A visitor's time with the page: looking around, with the camera or in AR, and the notices of each. */
export interface Visit {
  /** When the first picture can be drawn. */
  readonly ready: Promise<void>;
  readonly isReady: boolean;
  /** To be called from a click. Says why where it fails, offers the next best, and goes on with looking around. */
  enter(way: Way): Promise<void>;
  lookAround(): Promise<void>;
  /** Sets what a control stands for, now and whenever the picture is set up again. */
  setParam(node: string, param: string, value: number | boolean): void;
}

/** Throws where the browser has no WebGL 2. */
export function createVisit({ page, stage, program, ways, ...parts }: VisitOptions): Visit {
  const { canvas, notices, panel } = stage;
  const clock = createBrowserClock();
  let isReady = false;
  /** Which of the two a session of WebXR is. */
  let immersive: 'ar' | 'vr' = 'ar';
  let { offers } = ways;
  const offer = () => panel.show({ kind: 'ready', offers, reason: ways.noAr });
  const { around } = program.presentation;
  const orbit = (gl: WebGL2RenderingContext) => createOrbitSession({ gl, canvas, clock, ...(around && { start: around }) });
  const mounted: Mounted = mount(canvas, {
    ...parts,
    program,
    session: orbit,
    onDiagnostics: (diagnostics) => showDiagnostics(notices, 'player', diagnostics),
    onSessionEvent: (event, session) => {
      if (session.kind === 'webxr') onEvent(immersive, event);
      else if (session.kind === 'camera') onEvent('camera', event);
      else if (event.kind === 'problem') notices.show('session', { text: event.message, tone: 'problem' });
    },
    onContext: (state) => {
      if (state === 'restored') notices.clear('context');
      else notices.show('context', { text: CONTEXT_LOST, tone: 'problem' });
    },
  });
  const lookAround = () => mounted.play(orbit(mounted.gl));

  const onEvent = (way: Way, event: SessionEvent) => {
    switch (event.kind) {
      case 'ended':
        for (const topic of ['tracking', 'missing', 'hint', ...Object.keys(SILENT)]) notices.clear(topic);
        offer();
        stage.setWay(null);
        if (event.by === 'page') return;
        notices.show('ended', { text: ENDED[way], tone: 'hint' });
        void lookAround();
        return;
      case 'tracking':
        if (event.tracked) notices.clear('tracking');
        else notices.show('tracking', { text: UNTRACKED[way], tone: 'hint' });
        // It tells to turn the device.
        if (way === 'camera' && !event.tracked) notices.clear('hint');
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
        return;
    }
  };
  const request = (way: Way): Promise<Result<Session>> => {
    const { gl } = mounted;
    if (way === 'camera') return requestCameraSession({ window: page, media: page.navigator.mediaDevices, gl, canvas, clock });
    return requestWebXrSession({
      mode: way === 'vr' ? 'immersive-vr' : 'immersive-ar',
      xr: page.navigator.xr,
      gl,
      needs: program.needs,
      antialias: program.presentation.antialias,
      overlayRoot: stage.overlay,
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
    enter: async (way) => {
      panel.show({ kind: 'entering', way });
      for (const topic of ['ended', 'session']) notices.clear(topic);
      const { output, diagnostics } = await request(way);
      showDiagnostics(notices, 'missing', diagnostics);
      if (output === null) {
        // The next best, beside another try.
        if (way === 'ar' && canUseCamera(page, program.tiers)) offers = ['ar', 'camera'];
        offer();
        panel.focus();
        return;
      }
      if (way !== 'camera') immersive = way;
      stage.setWay(way);
      if (way === 'camera') notices.show('hint', { text: CAMERA_HINT, tone: 'hint' });
      await mounted.play(output);
    },
    lookAround,
    setParam: (node, param, value) => {
      mounted.player.setParam(node, param, value);
    },
  };
}

const ENDED: Readonly<Record<Way, string>> = {
  ar: 'AR has ended. You can enter it again.',
  camera: 'The camera was taken away. Close other apps that use it, then try again.',
  vr: 'VR has ended. You can enter it again.',
};

const UNTRACKED: Readonly<Record<Way, string>> = {
  ar: 'Looking for the room: move slowly, with enough light.',
  camera: 'This device does not tell how it is turned: drag to look around.',
  vr: 'The headset does not know where it is. Look around slowly, with enough light.',
};

/** What a capability's silence means for the picture. */
const SILENT: Readonly<Partial<Record<Capability, string>>> = {
  depth: 'The device measures no depth at the moment, so real things hide nothing. Move it slowly from side to side.',
  'light-estimation': 'The device does not measure the light of the room at the moment: things are lit by a guess.',
};

const CAMERA_HINT = 'Turn the device to look around. Pinch or scroll to step closer.';
const CONTEXT_LOST = 'The graphics were interrupted. They come back by themselves; if not, reload the page.';
const SHADERS_BROKEN = 'A part of the picture cannot be drawn with this device’s graphics. Try another browser or device to see all of it.';
