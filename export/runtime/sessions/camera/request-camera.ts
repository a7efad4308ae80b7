import type { Diagnostic, Result } from '../../../../nodes/kit/diagnostics.ts';
import type { FrameClock } from '../../clock.ts';
import type { CanvasFitter } from '../fit-canvas.ts';
import type { SessionInputs } from '../input/session-inputs.ts';
import { type CameraSession, createCameraSession } from './camera-session.ts';
import { createCameraStream } from './camera-stream.ts';
import type { CreateLens } from './lens.ts';
import { listenForOrientation, type OrientationWindow, requestOrientationPermission } from './orientation-sensor.ts';

export interface CameraRequest {
  readonly window: OrientationWindow;
  /** `navigator.mediaDevices`; undefined in insecure pages. */
  readonly media: MediaDevices | undefined;
  readonly gl: WebGL2RenderingContext;
  readonly canvas: HTMLCanvasElement;
  readonly clock: FrameClock;
  /** Functions that read input; absent or null: frames have no input. */
  readonly inputs?: SessionInputs | null;
  /** Sizes the drawing buffer. Default: the size of the canvas on the page. */
  readonly fitter?: CanvasFitter;
  /** Creates the estimation of the field of view; absent or null: the field of view stays as assumed. */
  readonly createLens?: CreateLens | null;
}

/**
 * Requests the camera and permission for the orientation sensor. Call it from a click or tap handler, before any `await`.
 *
 * @returns Never rejects. Without a session the diagnostics give the reason (SCR051); with one, what is missing (SCR055).
 */
export async function requestCameraSession(request: CameraRequest): Promise<Result<CameraSession>> {
  const { window, media, canvas } = request;
  if (!media?.getUserMedia) return { output: null, diagnostics: [NO_CAMERA] };
  let session: CameraSession | null = null;
  const stream = createCameraStream(canvas.ownerDocument, media, () => session?.lost());
  // Both requests start within the click, because Safari's permission ends with the first `await`.
  const [orientation, refused] = await Promise.all([
    requestOrientationPermission(window),
    stream.start().then(
      () => null,
      (error: unknown) => explain(error),
    ),
  ]);
  if (refused) return { output: null, diagnostics: [refused] };
  session = createCameraSession({ ...request, stream, sensor: listenForOrientation(window) });
  return { output: session, diagnostics: orientation === 'denied' ? [NO_MOTION] : [] };
}

const NO_CAMERA = refusal('The camera cannot be used here.', 'Open the page over https, in a browser that supports cameras.');

const NO_MOTION: Diagnostic = {
  code: 'SCR055',
  severity: 'warning',
  message: 'The motion sensor was not allowed. Drag to look around. To allow it, close this tab and open the page again.',
};

/** Translates the exceptions of `getUserMedia` (Media Capture and Streams §10.2). */
function explain(error: unknown): Diagnostic {
  switch (error instanceof Error ? error.name : '') {
    case 'NotAllowedError':
    case 'SecurityError':
      return refusal('The camera was not allowed.', 'Allow it for this page in the browser’s settings, then try again.');
    case 'NotFoundError':
    case 'OverconstrainedError':
      return refusal('No camera was found.', 'Try again on a device with a camera.');
    case 'NotReadableError':
    case 'AbortError':
      return refusal('The camera is in use or does not respond.', 'Close other apps that use it, then try again.');
    default:
      return refusal(`The camera could not be started: ${reason(error)}.`, 'Try again.');
  }
}

function refusal(message: string, fix: string): Diagnostic {
  return { code: 'SCR051', severity: 'error', message, fix };
}

function reason(error: unknown): string {
  return (error instanceof Error ? error.message : String(error)).replace(/\.$/, '');
}
