import type { Capability } from '../../../../nodes/kit/definition.ts';
import type { Diagnostic, Result } from '../../../../nodes/kit/diagnostics.ts';
import type { Session } from '../../../../nodes/kit/session.ts';
import type { ProgramNeed } from '../../../program/needs.ts';
import type { Presentation } from '../../../program/program-presentation.ts';
import { WEBXR_FEATURES } from '../../../program/webxr-features.ts';
import type { SessionInputs } from '../input/session-inputs.ts';
import { grantedCapabilities, sessionInit } from './session-init.ts';
import { createWebXrSession } from './webxr-session.ts';
import { createXrRenderTarget } from './xr-render-target.ts';

export type WebXrMode = 'immersive-ar' | 'immersive-vr';

export interface WebXrRequest {
  /** `navigator.xr` or an emulated one; undefined if the browser has none. */
  readonly xr: XRSystem | undefined;
  readonly gl: WebGL2RenderingContext;
  /** The session mode; default: AR. In VR an authored room replaces the visitor's room, also for nodes that read the camera image. */
  readonly mode?: WebXrMode;
  readonly needs: readonly ProgramNeed[];
  readonly antialias: boolean;
  /** As in `Presentation`. */
  readonly screenDepth?: Presentation['screenDepth'] | undefined;
  /** Page element that handheld devices show over the camera feed. */
  readonly overlayRoot?: Element | null;
  /** Functions that read input; absent or null: frames have no input. */
  readonly inputs?: SessionInputs | null;
}

/** Whether the browser supports the session mode. Never rejects. */
export async function supportsWebXr(xr: XRSystem | undefined, mode: WebXrMode = 'immersive-ar'): Promise<boolean> {
  return (await xr?.isSessionSupported(mode).catch(() => false)) ?? false;
}

/** Height of the eyes of a standing person, meters: for devices that do not know the floor. */
const EYE_HEIGHT_M = 1.6;

/**
 * Requests a session with the features that the program needs. Call it from a click or tap handler, before any `await`.
 *
 * @returns Never rejects. Without a session the diagnostics give the reason (SCR050, SCR051); with one, the missing features (SCR055).
 */
export async function requestWebXrSession(request: WebXrRequest): Promise<Result<Session>> {
  const { xr, gl, needs, mode = 'immersive-ar' } = request;
  const name = mode === 'immersive-ar' ? 'AR' : 'VR';
  // VR measures no room. Hands, and what WebXR does not ask for, work in both modes.
  const asked =
    mode === 'immersive-ar' ? needs : needs.filter(({ capability }) => capability === 'hands' || WEBXR_FEATURES[capability] === null);
  if (!xr) return refused(NO_WEBXR);
  let session: XRSession;
  try {
    session = await xr.requestSession(mode, sessionInit(asked, request.overlayRoot ?? null));
  } catch (error) {
    return refused(explain(error, asked, name));
  }
  try {
    const { origin, referenceSpace } = await requestReferenceSpaces(session);
    const capabilities = new Set(grantedCapabilities(session, asked));
    if (mode === 'immersive-vr') capabilities.add('camera-image');
    const options = {
      antialias: request.antialias,
      screenDepth: request.screenDepth,
      wantsDepth: capabilities.has('depth'),
      authoredRoom: mode === 'immersive-vr',
    };
    const target = await createXrRenderTarget(gl, session, options);
    const renewTarget = () => createXrRenderTarget(gl, session, options);
    const output = createWebXrSession({
      gl,
      session,
      origin,
      referenceSpace,
      target,
      renewTarget,
      capabilities,
      inputs: request.inputs ?? null,
    });
    // A phone is touched: nobody misses hand tracking on it.
    const isTouched = session.interactionMode === 'screen-space';
    const lacking = needs.filter(({ capability }) => !capabilities.has(capability) && !(capability === 'hands' && isTouched));
    return { output, diagnostics: lacking.map(missing) };
  } catch (error) {
    await session.end().catch(() => {});
    return refused(refusal(`${name} could not be shown: ${reason(error)}.`, 'Close other tabs and try again.'));
  }
}

/**
 * Requests the spaces of a session. `origin` is the space that the browser resets when the visitor re-centers. `referenceSpace` is the same
 * space, or that space with an offset to the floor.
 */
async function requestReferenceSpaces(
  session: XRSession,
): Promise<{ readonly origin: XRReferenceSpace; readonly referenceSpace: XRReferenceSpace }> {
  const floor = await session.requestReferenceSpace('local-floor').catch(() => null);
  if (floor) return { origin: floor, referenceSpace: floor };
  const eyes = await session.requestReferenceSpace('local');
  // All three coordinates are given, because iwer computes NaN from missing ones.
  return { origin: eyes, referenceSpace: eyes.getOffsetReferenceSpace(new XRRigidTransform({ x: 0, y: -EYE_HEIGHT_M, z: 0 })) };
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

/** Translates the exceptions of `requestSession` (WebXR Device API §4.2). */
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

/** Names of features, as messages for visitors call them. */
const WORDS: Readonly<Record<Capability, string>> = {
  'camera-image': 'the camera feed',
  depth: 'the depth of the room',
  'light-estimation': 'the light in the room',
  'hit-test': 'surfaces you point at',
  anchors: 'fixed places in the room',
  planes: 'floors, walls and tables',
  meshes: 'the shape of the room',
  hands: 'your hands',
  microphone: 'the microphone',
  motion: 'how you move the device',
  location: 'where you are',
};

function reason(error: unknown): string {
  return (error instanceof Error ? error.message : String(error)).replace(/\.$/, '');
}
