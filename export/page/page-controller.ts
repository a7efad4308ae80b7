import type { NodeModule } from '../../nodes/kit/runtime.ts';
import type { Program } from '../program/program.ts';
import type { AssetSource } from '../runtime/assets/asset-source.ts';
import { createBrowserClock } from '../runtime/clock.ts';
import type { CreateSceneBackend } from '../runtime/scene-backend.ts';
import type { SessionInputs } from '../runtime/sessions/input/session-inputs.ts';
import { createOrbitSession } from '../runtime/sessions/orbit/orbit-session.ts';
import type { CreateSpatial } from '../runtime/spatial/spatial.ts';
import { type Mounted, type MountOptions, mount } from './mount.ts';
import { showDiagnostics } from './notices.ts';
import type { PageRoot } from './page-root.ts';
import type { CreatePagePanorama } from './panorama-step/page-panorama.ts';
import type { PanoramaStep } from './panorama-step/panorama-step.ts';
import { createSessionEntry, type SessionEntry } from './session-entry.ts';
import type { SessionModes } from './session-modes.ts';

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
export interface PageController extends Pick<SessionEntry, 'offer' | 'enter'> {
  /** Resolves when the first frame can be drawn. */
  readonly ready: Promise<void>;
  readonly isReady: boolean;
  /** Resolves when all files of the page are loaded or failed. */
  readonly complete: Promise<void>;
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
  const { canvas, notices } = root;
  const clock = createBrowserClock();
  let isReady = false;
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
      if (session.kind === 'webxr' || session.kind === 'camera') entry.onEvent(event, session);
      else if (event.kind === 'problem') notices.show('session', { text: event.message, tone: 'problem' });
    },
    onContext: (state) => {
      if (state === 'restored') notices.clear('context');
      else notices.show('context', { text: CONTEXT_LOST, tone: 'problem' });
    },
  });
  step = createPanorama?.({ page, root, program, modules: parts.modules, gl: mounted.gl, setPanorama: mounted.player.setPanorama }) ?? null;
  const lookAround = () => mounted.play(orbit(mounted.gl));
  const entry = createSessionEntry({ page, root, program, modes, mounted, step, clock, inputs: parts.inputs, lookAround });
  return {
    ready: mounted.player.ready.then(({ shaderErrors }) => {
      isReady = true;
      if (shaderErrors.length > 0) notices.show('shaders', { text: SHADERS_BROKEN, tone: 'problem' });
    }),
    complete: mounted.player.complete,
    get isReady() {
      return isReady;
    },
    offer: entry.offer,
    enter: entry.enter,
    lookAround,
    setParam: (node, param, value) => {
      mounted.player.setParam(node, param, value);
    },
  };
}

const CONTEXT_LOST = 'Graphics were interrupted. If they do not return, reload the page.';
const SHADERS_BROKEN = 'Part of this page cannot be drawn on this device. Try another browser or device.';
