import type { Diagnostic, Result } from '../../../../nodes/kit/diagnostics.ts';
import type { Session } from '../../../../nodes/kit/session.ts';
import type { Capability, ProgramNeed } from '../../../program/program.ts';
import { grantedCapabilities, sessionInit } from './features.ts';
import { createWebXrSession } from './webxr-session.ts';
import { createSurface } from './webxr-surface.ts';

export type WebXrMode = 'immersive-ar' | 'immersive-vr';

export interface WebXrRequest {
  /** `navigator.xr`, or an emulated one; undefined where the browser has none. */
  readonly xr: XRSystem | undefined;
  readonly gl: WebGL2RenderingContext;
  /** AR unless given. In VR a room of ours stands in for the visitor's, also for what reads the camera's picture. */
  readonly mode?: WebXrMode;
  readonly needs: readonly ProgramNeed[];
  readonly antialias: boolean;
  /** Page elements to show over the picture on handheld devices. */
  readonly overlayRoot?: Element | null;
}

/** Whether it makes sense to offer AR, or VR. Never rejects. */
export async function supportsWebXr(xr: XRSystem | undefined, mode: WebXrMode = 'immersive-ar'): Promise<boolean> {
  return (await xr?.isSessionSupported(mode).catch(() => false)) ?? false;
}

/** Where no browser knows the floor: below the eyes of someone who stands, metres. */
const EYES_ABOVE_FLOOR_M = 1.6;

/**
 * Asks for a session that brings what the program needs. To be called from a click or tap, before anything is awaited.
 * Never rejects: without a session the diagnostics say why (SCR050, SCR051); with one they say what it lacks (SCR055).
 */
export async function requestWebXrSession(request: WebXrRequest): Promise<Result<Session>> {
  const { xr, gl, needs, mode = 'immersive-ar' } = request;
  const name = mode === 'immersive-ar' ? 'AR' : 'VR';
  // In VR there is no room to be measured; hands and voice are the visitor's own everywhere.
  const asked = mode === 'immersive-ar' ? needs : needs.filter(({ capability }) => capability === 'hands' || capability === 'microphone');
  if (!xr) return refused(NO_WEBXR);
  let session: XRSession;
  try {
    session = await xr.requestSession(mode, sessionInit(asked, request.overlayRoot ?? null));
  } catch (error) {
    return refused(explain(error, asked, name));
  }
  try {
    const floor = await session.requestReferenceSpace('local-floor').catch(() => null);
    const world = floor ?? (await session.requestReferenceSpace('local'));
    const capabilities = new Set(grantedCapabilities(session, asked));
    if (mode === 'immersive-vr') capabilities.add('camera-image');
    const authoredFloorM = mode === 'immersive-ar' ? null : floor ? 0 : -EYES_ABOVE_FLOOR_M;
    const wishes = { antialias: request.antialias, wantsDepth: capabilities.has('depth'), authoredFloorM };
    const surface = await createSurface(gl, session, wishes);
    const renewSurface = () => createSurface(gl, session, wishes);
    const output = createWebXrSession({ gl, session, world, surface, renewSurface, capabilities });
    return { output, diagnostics: needs.filter((need) => !capabilities.has(need.capability)).map(missing) };
  } catch (error) {
    await session.end().catch(() => {});
    return refused(refusal(`${name} began and could not be shown: ${reason(error)}.`, 'Close other tabs and try again.'));
  }
}

const NO_WEBXR: Diagnostic = {
  code: 'SCR050',
  severity: 'error',
  message: 'This browser cannot show AR: it has no WebXR.',
  fix: 'Open the page in Chrome on an Android phone that has AR, or in the browser of a headset.',
};

function refused(diagnostic: Diagnostic): Result<Session> {
  return { output: null, diagnostics: [diagnostic] };
}

function refusal(message: string, fix: string): Diagnostic {
  return { code: 'SCR051', severity: 'error', message, fix };
}

/** What the names of the exceptions mean: WebXR Device API §4.2, `requestSession`. */
function explain(error: unknown, needs: readonly ProgramNeed[], name: 'AR' | 'VR'): Diagnostic {
  const required = needs.filter((need) => need.required).map((need) => WORDS[need.capability]);
  switch (error instanceof DOMException ? error.name : '') {
    case 'NotSupportedError':
      return required.length === 0
        ? refusal(`This device has no ${name}.`, 'Open the page on a phone or headset that has it.')
        : refusal(
            `This device has no ${name}, or lacks what the page needs: ${required.join(', ')}.`,
            'Open the page on another phone or headset.',
          );
    case 'NotAllowedError':
      return refusal(`${name} was not allowed.`, 'Try again and allow what the browser asks for.');
    case 'SecurityError':
      return refusal(`The browser starts ${name} only after a click or tap, on a page loaded over https.`, 'Tap the button again.');
    case 'InvalidStateError':
      return refusal(`Another ${name} session is running.`, 'End it and try again.');
    default:
      return refusal(`${name} could not be started: ${reason(error)}.`, 'Try again.');
  }
}

function missing(need: ProgramNeed): Diagnostic {
  return { code: 'SCR055', severity: 'warning', message: `Not available here: ${WORDS[need.capability]}. ${need.without}` };
}

/** As visitors would say it. */
const WORDS: Readonly<Record<Capability, string>> = {
  'camera-image': 'the camera picture',
  depth: 'depth of the room',
  'light-estimation': 'light of the room',
  'hit-test': 'finding surfaces',
  anchors: 'holding places',
  planes: 'detected planes',
  meshes: 'detected shapes',
  hands: 'hand tracking',
  microphone: 'the microphone',
};

function reason(error: unknown): string {
  return (error instanceof Error ? error.message : String(error)).replace(/\.$/, '');
}
