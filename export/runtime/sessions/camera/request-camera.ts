import type { Diagnostic, Result } from '../../../../nodes/kit/diagnostics.ts';
import type { Session } from '../../../../nodes/kit/session.ts';
import type { FrameClock } from '../../clock.ts';
import { type CameraSession, createCameraSession } from './camera-session.ts';
import { createCameraStream } from './camera-stream.ts';
import { askForOrientation, listenForOrientation, type OrientationWindow } from './orientation-sensor.ts';

export interface CameraRequest {
  readonly window: OrientationWindow;
  /** `navigator.mediaDevices`, which insecure pages do not have. */
  readonly media: MediaDevices | undefined;
  readonly gl: WebGL2RenderingContext;
  readonly canvas: HTMLCanvasElement;
  readonly clock: FrameClock;
}

/**
 * Asks for the camera, and for leave to follow how the device turns. To be called from a click or tap, before anything is awaited.
 * Never rejects: without a session the diagnostics say why (SCR051); with one they say what it lacks (SCR055).
 */
export async function requestCameraSession({ window, media, gl, canvas, clock }: CameraRequest): Promise<Result<Session>> {
  if (!media?.getUserMedia) return { output: null, diagnostics: [NO_CAMERA] };
  let session: CameraSession | null = null;
  const stream = createCameraStream(canvas.ownerDocument, media, () => session?.lost());
  // Both within the click: Safari forgets it at the first wait.
  const [orientation, refused] = await Promise.all([
    askForOrientation(window),
    stream.start().then(
      () => null,
      (error: unknown) => explain(error),
    ),
  ]);
  if (refused) return { output: null, diagnostics: [refused] };
  session = createCameraSession({ gl, canvas, clock, stream, sensor: listenForOrientation(window) });
  return { output: session, diagnostics: orientation === 'denied' ? [NO_MOTION] : [] };
}

const NO_CAMERA = refusal('The camera cannot be used here.', 'Open the page over https, in a browser that allows it.');

const NO_MOTION: Diagnostic = {
  code: 'SCR055',
  severity: 'warning',
  message: 'Following how the device turns was not allowed: drag to look around. To allow it, close this tab and open the page again.',
};

/** What the names of the exceptions mean: Media Capture and Streams §10.2, `getUserMedia`. */
function explain(error: unknown): Diagnostic {
  switch (error instanceof Error ? error.name : '') {
    case 'NotAllowedError':
    case 'SecurityError':
      return refusal('The camera was not allowed.', 'Allow it for this page in the browser’s settings, then try again.');
    case 'NotFoundError':
    case 'OverconstrainedError':
      return refusal('No camera was found.', 'Connect one, or open the page on a phone.');
    case 'NotReadableError':
    case 'AbortError':
      return refusal('The camera is busy or does not answer.', 'Close other apps that use it, then try again.');
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
